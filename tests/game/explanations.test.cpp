// The examples of `pinfield explain` are read here, so that none of them rots.
#include "engine/core/explanations.h"

#include <catch2/catch.hpp>
#include <set>
#include <sstream>

#include "engine/game/pockets.h"
#include "engine/game/starts.h"
#include "engine/io/script_reader.h"
#include "engine/program/compile.h"
#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

/// What no few lines can show: their texts say so.
const std::set<Code> without_example{
    Code::not_utf8,       Code::control_character, Code::file_too_large,  Code::too_deep,            Code::too_many_events,     Code::scalar_too_long,
    Code::too_many_nodes, Code::too_many_points,   Code::too_many_errors, Code::expression_too_deep, Code::expression_too_long, Code::too_many_params,
    Code::offset_of_bound,
};

/// Nodes as the scene of a table; a whole table as it is.
std::string table_of(std::string_view example) {
    if (!example.starts_with("- ")) return std::string(example);
    std::string table = "pinfield: 1\nscene:\n";
    std::istringstream lines{std::string(example)};
    for (std::string line; std::getline(lines, line);) table.append("  ").append(line).append("\n");
    return table;
}

/// The codes that `check`, for pockets with that option, or the reader of scripts finds in an example.
std::vector<std::string> codes_in(Code code, std::string_view example) {
    Diagnostics found;
    if (code == Code::unknown_step) {
        found = read_script(SourceText("script.yaml", std::string(example))).diagnostics;
    } else {
        const Reading read = test::read(table_of(example));
        found = read.diagnostics;
        const auto add = [&](const Diagnostics& more) { found.insert(found.end(), more.begin(), more.end()); };
        const auto program = read.ok() ? compile(read.scene) : tl::make_unexpected(Diagnostics{});
        add(program ? doubts_of(**program, read.scene) : program.error());
        if (program && code == Code::pocket) add(pocket_warnings(**program, read.scene));
    }
    std::vector<std::string> codes;
    for (const Diagnostic& diagnostic : found) codes.push_back(diagnostic.code);
    return codes;
}

}  // namespace

TEST_CASE("every code is explained, with an example of wrong and of right or the words why there is none") {
    for (const ErrorCode& code : error_codes()) {
        const auto which = static_cast<Code>(&code - error_codes().data());
        INFO(code.code << " " << code.name);
        const Explanation* explained = explanation(which);
        REQUIRE(explained);
        CHECK(explained->text.ends_with('.'));
        CHECK(explained->wrong.empty() == without_example.contains(which));
        CHECK(explained->right.empty() == explained->wrong.empty());
        for (const std::string_view example : {explained->wrong, explained->right}) CHECK((example.empty() || example.ends_with('\n')));
    }
}

TEST_CASE("codes are explained once, in their order") {
    std::vector<Code> codes;
    for (const auto family : {text_explanations(), structure_explanations(), reference_explanations(), doubt_explanations()})
        for (const Explanation& explained : family) codes.push_back(explained.code);
    CHECK(std::is_sorted(codes.begin(), codes.end()));
    CHECK(std::adjacent_find(codes.begin(), codes.end()) == codes.end());
    CHECK(codes.size() == error_codes().size());
}

TEST_CASE("each wrong example has its own code once and no other, each right one has none") {
    for (const ErrorCode& code : error_codes()) {
        const auto which = static_cast<Code>(&code - error_codes().data());
        const Explanation* explained = explanation(which);
        if (!explained || explained->wrong.empty()) continue;
        INFO(code.code << " " << code.name << "\n" << explained->wrong << explained->right);
        CHECK(codes_in(which, explained->wrong) == std::vector<std::string>{std::string(code.code)});
        CHECK(codes_in(which, explained->right).empty());
    }
}
