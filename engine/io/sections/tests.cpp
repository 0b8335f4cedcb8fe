// tests: launches, hands at the inputs, how long they run, and what is then expected.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "engine/core/at.h"
#include "engine/core/numbers.h"
#include "engine/io/entries.h"
#include "engine/io/node_writer.h"
#include "engine/io/quantity.h"
#include "engine/io/schema_parts.h"
#include "engine/io/section.h"
#include "engine/io/value_reader.h"
#include "engine/io/value_writer.h"
#include "engine/scene/part_traits.h"

namespace pinfield::sections {
namespace {

void read_launch(ReadContext& context, TableTest& test, const YamlNode& node) {
    if (node.kind != YamlKind::map)
        return context.report(Code::wrong_shape, node.span, "a launch is due here: {at: [x, y], velocity: [x, y]}");
    static const std::vector<std::string_view> keys{"at", "velocity"};
    TableTest::Launch launch;
    launch.where = context.source().place(node.span);
    read_entries(context, "a launch", node, keys, [&](auto index, const YamlNode& value) {
        const Unit unit = index == 0 ? Unit::metre : Unit::metre_per_second;
        const auto read = read_value(
            context, number_field(at(keys, index), unit, from(-1e6), to(1e6), FieldKind::vec2),
            value);
        if (read) (index == 0 ? launch.at : launch.velocity) = std::get<Vec2>(*read);
    });
    if (!node.find("at")) context.report(Code::missing_field, node.span, "a launch needs at");
    test.launches.push_back(launch);
}

/// What a test may refer to, found once for all tests.
struct Quantities {
    std::set<std::string> measured;
    std::vector<std::string> named;  ///< those with a name of the author's: what is worth suggesting
    std::map<std::string, std::string> idle;  ///< what would always be 0, and why
};

/// The part of whose shape a node is a piece, which is hit in its place; null: none.
const Node* part_around(const Scene& scene, const Node& node) {
    for (const Node* above = scene.find(node.parent); above; above = scene.find(above->parent))
        if (above->type->part && above->type->part->role != Role::group) return above;
    return nullptr;
}

/// Is there anything in a group that balls meet?
bool has_surface(const Scene& scene, const Node& node) {
    if (!node.type->part) return true;
    if (node.type->part->role != Role::group) return node.type->part->customary_shape || !node.children.empty();
    return std::any_of(node.children.begin(), node.children.end(), [&](NodeId child) { return has_surface(scene, *scene.find(child)); });
}

Quantities quantities_of(const Scene& scene) {
    Quantities out{{"escaped", "drained"}, {"escaped", "drained"}, {}};
    for (const auto& [id, path] : scene.paths()) {
        const Node& node = *scene.find(id);
        if (node.is_record()) continue;
        if (const Node* part = part_around(scene, node)) {
            const std::string whole = scene.path(part->id);
            out.idle.emplace(path + ".hits", fmt::format("{} counts as a part of {}: {}.hits counts both", path, whole, whole));
        } else if (!has_surface(scene, node)) {
            out.idle.emplace(path + ".hits", fmt::format("a {} has no surface, so that nothing hits it", node.type->key()));
        } else {
            out.measured.insert(path + ".hits");
            if (!node.name.empty()) out.named.push_back(path + ".hits");
        }
    }
    return out;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

void read_expectation(ReadContext& context, const Quantities& known, TableTest& test, const YamlNode& node) {
    const auto reject = [&](std::string message) {
        context.report(Code::bad_expectation, node.span, std::move(message), "for example: pop.hits >= 1");
    };
    if (node.kind != YamlKind::scalar) return reject("an expectation is due here");
    const std::size_t at = node.text.find_first_of("=!<>");
    if (at == std::string_view::npos) return reject("an expectation compares a quantity with a number");
    const std::size_t length = at + 1 < node.text.size() && node.text[at + 1] == '=' ? 2 : 1;
    const std::string_view quantity = trimmed(node.text.substr(0, at)), comparison = node.text.substr(at, length),
                           number = trimmed(node.text.substr(at + length));
    if (comparison == "=" || comparison == "!")
        return reject(fmt::format("{} is no comparison; there are == != < <= > >=", comparison));
    const QuantityResult value = read_quantity(number, Unit::none);
    if (!value) return reject(fmt::format("{} is no number", number));
    if (const auto idle = known.idle.find(std::string(quantity)); idle != known.idle.end())
        return context.report(Code::unknown_quantity, node.span, fmt::format("{} is always 0", quantity), idle->second);
    if (!known.measured.contains(std::string(quantity)))
        return context.report(Code::unknown_quantity, node.span, fmt::format("nothing called {} is measured", quantity),
                              suggestion(quantity, std::vector<std::string_view>(known.named.begin(), known.named.end())));
    test.expectations.push_back(
        {std::string(quantity), std::string(comparison), value->value, std::string(node.text), context.source().place(node.span)});
}

/// One thing or a list of them.
template <class Read>
void each(const ReadContext& context, const YamlNode& node, Read read) {
    if (node.kind != YamlKind::sequence) return read(node);
    for (const YamlNode* item : node.items) {
        if (context.full()) return;
        read(item->resolved());
    }
}

void read_times(ReadContext& context, TableTest::Hand& hand, const YamlNode& node) {
    static const FieldType time = number_field("inputs", Unit::second, from(0), to(3600));
    each(context, node, [&](const YamlNode& item) {
        const auto read = read_value(context, time, item);
        if (!read) return;
        const double seconds = std::get<double>(*read);
        if (!hand.times.empty() && seconds <= hand.times.back())
            context.report(Code::out_of_range, item.span, "the times of an input must rise", "it is pressed at the first, let go at the second, and so on");
        hand.times.push_back(seconds);
    });
}

/// {plunge: [0.2s, 1s], left: 2s}
void read_hands(ReadContext& context, const Scene& scene, TableTest& test, const YamlNode& node) {
    if (node.kind != YamlKind::map)
        return context.report(Code::wrong_shape, node.span, "times of inputs are due here: {left: [1s, 1.2s]}",
                              "pressed at the first, let go at the second, and so on");
    std::vector<std::string_view> names;
    for (const InputBinding& input : scene.inputs) names.push_back(input.name);
    for (std::size_t i = 0; i < node.entries() && !context.full(); ++i) {
        const YamlNode& key = node.key(i);
        const YamlNode& value = node.value(i).resolved();
        if (!is_plain_key(key)) continue;
        if (std::find(names.begin(), names.end(), key.text) == names.end())
            context.report(Code::unknown_input, key.span, fmt::format("no input is called {}", key.text), suggestion(key.text, names));
        else if (value.kind == YamlKind::null)
            report_missing_value(context, key, value);
        else
            read_times(context, test.inputs.emplace_back(TableTest::Hand{std::string(key.text), {}, context.source().place(key.span)}), value);
    }
}

void read_name(ReadContext& context, TableTest& test, const YamlNode& value) {
    if (value.kind == YamlKind::scalar) test.name = value.text;
    else context.report(Code::wrong_shape, value.span, "a text is due here");
}

void read_test(ReadContext& context, Scene& scene, const Quantities& known, const YamlNode& node) {
    if (node.kind != YamlKind::map)
        return context.report(Code::wrong_shape, node.span,
                              "a test is due here: {launch: {...}, run: 3s, expect: [...]}");
    TableTest test;
    test.where = context.source().place(node.span);
    read_entries(context, "a test", node, {"name", "launch", "inputs", "run", "expect"}, [&](auto index, const YamlNode& value) {
        if (index == 0) {
            read_name(context, test, value);
        } else if (index == 1) {
            each(context, value, [&](const YamlNode& launch) { read_launch(context, test, launch); });
        } else if (index == 2) {
            read_hands(context, scene, test, value);
        } else if (index == 3) {
            const auto run = read_value(context, number_field("run", Unit::second, above(0), to(3600)), value);
            if (run) test.run = std::get<double>(*run);
        } else {
            each(context, value,
                 [&](const YamlNode& expectation) { read_expectation(context, known, test, expectation); });
        }
    });
    if (!node.find("expect")) context.report(Code::missing_field, node.span, "a test needs expect");
    scene.tests.push_back(std::move(test));
}

void read(ReadContext& context, Scene& scene, const YamlNode&, const YamlNode& section) {
    if (section.is_empty()) return;
    if (section.kind != YamlKind::sequence)
        return context.report(Code::wrong_shape, section.span, "a list of tests is due here",
                              "begin each test with a dash");
    const Quantities known = quantities_of(scene);
    for (const YamlNode* item : section.items) {
        if (context.full()) return;
        read_test(context, scene, known, item->resolved());
    }
}

std::string launch_text(const TableTest::Launch& launch) {
    const auto pair = [](const Vec2& v) { return fmt::format("[{}, {}]", to_text(v.x()), to_text(v.y())); };
    return fmt::format("{{at: {}, velocity: {}}}", pair(launch.at), pair(launch.velocity));
}

std::string hands_text(const std::vector<TableTest::Hand>& hands) {
    std::vector<std::string> entries;
    for (const TableTest::Hand& hand : hands) {
        std::vector<std::string> times;
        for (const double time : hand.times) times.push_back(to_text(time));
        entries.push_back(fmt::format("{}: [{}]", hand.input, fmt::join(times, ", ")));
    }
    return flow_map(entries);
}

std::string write(const Scene& scene) {
    std::string out = scene.tests.empty() ? "" : "tests:\n";
    for (const TableTest& test : scene.tests) out += fmt::format("  - {}\n", flow_map(entries_of(test)));
    return out;
}

FieldMeta unit_meta(Unit unit) {
    FieldMeta meta;
    meta.unit = unit;
    return meta;
}

std::string test_schema() {
    FieldMeta run = unit_meta(Unit::second);
    run.min = above(0);
    FieldMeta time = unit_meta(Unit::second);
    time.min = from(0);
    const std::string launch =
        fmt::format(R"({{"type": "object", "additionalProperties": false, "required": ["at"], "properties": {{"at": {}, "velocity": {}}}}})",
                    schema::pair(unit_meta(Unit::metre)), schema::pair(unit_meta(Unit::metre_per_second)));
    return fmt::format(
        R"({{"type": "object", "additionalProperties": false, "required": ["expect"], "properties": {{
            "name": {{"type": ["string", "number", "boolean"]}}, "launch": {}, "inputs": {}, "run": {}, "expect": {}}}}})",
        schema::one_or_list(launch), schema::named_map(schema::one_or_list(schema::number(time))), schema::number(run),
        schema::one_or_list(R"({"type": "string", "pattern": "^[^=!<>]+(==|!=|<=|>=|<|>)[^=!<>]+$"})"));
}

}  // namespace
}  // namespace pinfield::sections

namespace pinfield {

std::vector<std::string> entries_of(const TableTest& test) {
    std::vector<std::string> entries, launches, expectations;
    for (const auto& launch : test.launches) launches.push_back(sections::launch_text(launch));
    for (const auto& e : test.expectations)
        expectations.push_back(fmt::format("{} {} {}", e.quantity, e.comparison, to_text(e.value)));
    if (!test.name.empty()) entries.push_back("name: " + write_text(test.name));
    if (launches.size() == 1) entries.push_back("launch: " + launches[0]);
    if (launches.size() > 1) entries.push_back(fmt::format("launch: [{}]", fmt::join(launches, ", ")));
    if (!test.inputs.empty()) entries.push_back("inputs: " + sections::hands_text(test.inputs));
    entries.push_back("run: " + to_text(test.run));
    entries.push_back(fmt::format("expect: [{}]", fmt::join(expectations, ", ")));
    return entries;
}

}  // namespace pinfield

namespace pinfield::sections {

extern const Section tests{
    .key = "tests",
    .read = read,
    .write = write,
    .schema = [] { return schema::list(test_schema()); },
    .same = [](const Scene& a,
               const Scene& b) { return std::equal(a.tests.begin(), a.tests.end(), b.tests.begin(), b.tests.end(), same_test); },
    .phase = Section::Phase::after_nodes,
    .why_not_included = "a test tells of a whole table",
};

}  // namespace pinfield::sections
