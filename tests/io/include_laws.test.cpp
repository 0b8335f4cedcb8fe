// A table dealt to files at random is the table in one file, right or wrong; written, patched and expanded it stays so.
#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include <sstream>

#include "engine/io/text_patch.h"
#include "engine/io/write_table.h"
#include "engine/scene/elsewhere.h"
#include "engine/scene/expanded.h"
#include "tests/io/random_table.h"
#include "tests/io/split_table.h"
#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

template <class Item, class Same>
bool same_list(const std::vector<Item>& a, const std::vector<Item>& b, Same same) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

/// All that two scenes hold, but for which of it stands where.
bool same_whole(const Scene& a, const Scene& b) {
    return same_node(a, a.table(), b, b.table()) && same_nodes(a, a.roots(), b, b.roots()) && same_nodes(a, a.materials(), b, b.materials()) &&
           same_list(a.params, b.params, same_param) && same_list(a.inputs, b.inputs, same_input) && same_list(a.tests, b.tests, same_test);
}

std::string without_comments(const std::string& text) {
    std::istringstream lines(text);
    std::string out;
    for (std::string line; std::getline(lines, line);)
        if (!line.starts_with("  # ")) out.append(line).append("\n");
    return out;
}

std::string told(const SplitTable& split) {
    std::string out = "--- table.yaml\n" + split.main;
    for (const auto& [path, text] : split.files) out += fmt::format("--- {}\n{}", path, text);
    return out;
}

/// What is found, wherever it stands: code, message, and the line that it is about.
std::vector<std::string> complaints(const Reading& reading) {
    std::vector<std::string> out;
    for (const Diagnostic& found : reading.diagnostics) {
        const SourceText* text = reading.scene.sources.find(found.where);
        REQUIRE(text);
        out.push_back(fmt::format("{} {} {}", found.code, found.message, text->line(text->line_column(found.where.span.begin).line)));
    }
    std::sort(out.begin(), out.end());
    return out;
}

}  // namespace

TEST_CASE("a table dealt to files is the table in one, value for value") {
    CHECK(rc::check([](std::uint64_t seed) {
        CounterRng rng(seed);
        const TableEntries entries = some_entries(rng);
        const Reading one = read(in_one(entries));
        INFO(in_one(entries) << test::told(one));
        REQUIRE(one.ok());
        const SplitTable split = Dealer(rng).deal(entries);
        const Reading many = read_with(split.main, split.files);
        INFO(told(split) << test::told(many));
        RC_ASSERT(many.ok());
        RC_ASSERT(same_whole(one.scene, many.scene));
        RC_ASSERT(without_comments(write_table(expanded(many.scene))) == without_comments(write_table(expanded(one.scene))));
        const Reading back = read_with(write_table(many.scene), split.files);
        INFO("written:\n" << write_table(many.scene) << test::told(back));
        RC_ASSERT(back.ok());
        RC_ASSERT(same_content(back.scene, many.scene));
        RC_ASSERT(read(write_table(expanded(many.scene))).ok());
    }));
}

TEST_CASE("what is wrong with a table is wrong with it in files, and told once, at the same line") {
    const std::vector<std::pair<std::size_t, std::string>> faults{
        {0, "bad: gap + 2kg"},
        {0, "r2: nowhere"},
        {1, "odd: {restitution: 2}"},
        {2, "self: {nodes: [use: {template: self}]}"},
        {2, "broken: {nodes: [circle: {radius: gap - r, at: [0.7, 0.7]}]}"},
        {3, "- use: {template: broken, id: x}"},
        {3, "- use: {template: lamp, with: {w: -1cm}}"},
        {3, "- circle: {id: gap, material: paper}"},
        {3, "- box: {size: [1cm, 1cm], copies: {count: 2.5}}"},
        {4, "middle: NoSuchKey"},
    };
    CHECK(rc::check([&](std::uint64_t seed) {
        CounterRng rng(seed);
        TableEntries entries = some_entries(rng);
        for (const auto& [section, entry] : faults) {
            if (rng.uniform() < 0.6) continue;
            auto& list = entries.sections[section].second;
            list.insert(list.begin() + static_cast<std::ptrdiff_t>(rng.next_u64() % (list.size() + 1)), entry);
        }
        const Reading one = read(in_one(entries));
        const SplitTable split = Dealer(rng).deal(entries);
        const Reading many = read_with(split.main, split.files);
        std::vector<std::string> expected = complaints(one);
        // What nobody uses is told of the table's own file only.
        const auto is_unused = [](const std::string& complaint) { return complaint.starts_with("W0513") || complaint.starts_with("W0514"); };
        std::vector<std::string> found = complaints(many);
        std::erase_if(expected, is_unused);
        std::erase_if(found, is_unused);
        INFO(in_one(entries) << test::told(one) << told(split) << test::told(many));
        RC_ASSERT(found == expected);
    }));
}

TEST_CASE("whatever bytes stand in the files of a table, reading ends, and every finding stands in one of them") {
    CHECK(rc::check([](std::uint64_t seed) {
        CounterRng rng(seed);
        SplitTable split = Dealer(rng).deal(some_entries(rng));
        const auto spoil = [&](std::string& text) {
            const std::string_view bits[] = {"include: [p1.yaml]\n", "../", "{", "]", "\n", "  ", "\xff", "#", ": ", "- ", "*a", "&a ", "\t", std::string_view("\0", 1), "scene:\n"};
            for (auto times = 1 + rng.next_u64() % 4; times > 0; --times) {
                const std::size_t at = rng.next_u64() % (text.size() + 1);
                if (rng.uniform() < 0.5) text.insert(at, bits[rng.next_u64() % std::size(bits)]);
                else text.erase(at, 1 + rng.next_u64() % 8);
            }
        };
        for (auto& [path, text] : split.files)
            if (rng.uniform() < 0.5) spoil(text);
        if (rng.uniform() < 0.3) spoil(split.main);
        const Reading reading = read_with(split.main, split.files);
        for (const Diagnostic& found : reading.diagnostics) {
            RC_ASSERT(reading.scene.sources.find(found.where));
            for (const Via& step : way_to(found, reading.scene.sources)) RC_ASSERT(reading.scene.sources.find(step.where));
        }
        const Reading again = read_again(reading, split.main);
        RC_ASSERT(test::told(again) == test::told(reading));
        if (reading.ok()) RC_ASSERT(same_content(read_with(write_table(reading.scene), split.files).scene, reading.scene));
    }));
}

TEST_CASE("edits of a table in files change its own text alone, or are refused with the place") {
    int made = 0;
    CHECK(rc::check([&](std::uint64_t seed) {
        CounterRng rng(seed);
        const SplitTable split = Dealer(rng).deal(some_entries(rng));
        Reading now = read_with(split.main, split.files);
        for (int i = 0; i < 6; ++i) {
            std::optional<Edit> edit;
            if (rng.uniform() < 0.5) edit = some_structural_edit(now.scene, rng);
            else if (const auto field = some_edit(now.scene, rng)) edit = *field;
            if (!edit) continue;
            if (const auto* field = std::get_if<SetField>(&*edit)) RC_ASSERT(!is_included(now.scene.find(field->node)->key));
            Scene expected = now.scene;
            pinfield::apply(expected, *edit);
            Result<PatchedText> patched = patch_for(now, std::span(&*edit, 1));
            if (!patched) continue;  // such as in a list that stands in one line
            RC_ASSERT(same_content(patched->reading.scene, expected));
            RC_ASSERT(patched->reading.files.size() == now.files.size());
            now = std::move(patched->reading);
            ++made;
        }
        RC_ASSERT(same_whole(read_with(now.source().text(), split.files).scene, now.scene));
    }));
    CHECK(made > 200);
}
