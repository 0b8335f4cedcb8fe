#include "engine/io/section_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "engine/core/at.h"
#include "engine/core/keys.h"
#include "engine/io/quantity.h"
#include "engine/io/value_reader.h"

namespace pinfield {
namespace {

FieldType number_field(std::string_view key, Unit unit, Limit min, Limit max, FieldKind kind = FieldKind::number) {
    FieldMeta meta;
    meta.unit = unit;
    meta.min = min;
    meta.max = max;
    return {key, kind, meta, {}, {}, false};
}

void read_binding(ReadContext& context, Scene& scene, const YamlNode& key, const YamlNode& value) {
    if (!is_plain_key(key)) return;
    if (!is_name(key.text))
        return context.report(Code::bad_name, key.span, fmt::format("{} is no name for an input", key.text),
                              "small letters, digits and _");
    if (value.kind == YamlKind::null) return report_missing_value(context, key, value);
    InputBinding binding{std::string(key.text), {}, {key.span.begin, value.span.end}};
    std::vector<const YamlNode*> items{&value};
    if (value.kind == YamlKind::sequence) items.assign(value.items.begin(), value.items.end());
    for (const YamlNode* item : items) {
        if (context.full()) return;
        const YamlNode& name = item->resolved();
        if (name.kind != YamlKind::scalar || name.text.empty()) {
            context.report(Code::wrong_shape, name.span, "the name of a key is due here");
            continue;
        }
        if (key_code(name.text) < 0) {
            std::vector<std::string_view> known;
            for (const KeyboardKey& known_key : keyboard_keys()) known.push_back(known_key.name);
            context.report(Code::unknown_keyboard_key, name.span,
                           fmt::format("no key of a keyboard is called {}", name.text), suggestion(name.text, known));
        }
        binding.keys.emplace_back(name.text);
    }
    scene.inputs.push_back(std::move(binding));
}

/// Entries of a map whose keys are few and known: calls read(key index, value) for those with a value.
template <class Read>
void read_entries(ReadContext& context, std::string_view what, const YamlNode& map,
                  const std::vector<std::string_view>& keys, Read read) {
    for (std::size_t i = 0; i < map.entries() && !context.full(); ++i) {
        const auto it = std::find(keys.begin(), keys.end(), map.key(i).text);
        const YamlNode& value = map.value(i).resolved();
        if (!is_plain_key(map.key(i))) continue;
        if (it == keys.end())
            context.report(Code::unknown_key, map.key(i).span, fmt::format("{} has no {}", what, map.key(i).text),
                           suggestion(map.key(i).text, keys));
        else if (value.kind == YamlKind::null)
            report_missing_value(context, map.key(i), value);
        else
            read(it - keys.begin(), value);
    }
}

void read_launch(ReadContext& context, TableTest& test, const YamlNode& node) {
    if (node.kind != YamlKind::map)
        return context.report(Code::wrong_shape, node.span, "a launch is due here: {at: [x, y], velocity: [x, y]}");
    static const std::vector<std::string_view> keys{"at", "velocity"};
    TableTest::Launch launch;
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

/// What a test may expect something of, found once for all expectations.
struct Quantities {
    std::set<std::string> measured;
    std::vector<std::string> named;  ///< those with a name of the author's: what is worth suggesting
};

Quantities quantities_of(const Scene& scene) {
    Quantities out{{"escaped", "drained"}, {"escaped", "drained"}};
    for (const auto& [id, path] : scene.paths()) {
        const Node& node = *scene.find(id);
        if (node.type->meta.kind == NodeKind::record) continue;
        out.measured.insert(path + ".hits");
        if (!node.name.empty()) out.named.push_back(path + ".hits");
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
    if (!known.measured.count(std::string(quantity)))
        return context.report(Code::unknown_quantity, node.span, fmt::format("nothing called {} is measured", quantity),
                              suggestion(quantity, {known.named.begin(), known.named.end()}));
    test.expectations.push_back(
        {std::string(quantity), std::string(comparison), value->value, std::string(node.text), node.span});
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

void read_test(ReadContext& context, Scene& scene, const Quantities& known, const YamlNode& node) {
    if (node.kind != YamlKind::map)
        return context.report(Code::wrong_shape, node.span,
                              "a test is due here: {launch: {...}, run: 3s, expect: [...]}");
    TableTest test;
    test.where = node.span;
    read_entries(context, "a test", node, {"name", "launch", "run", "expect"}, [&](auto index, const YamlNode& value) {
        if (index == 0) {
            if (value.kind == YamlKind::scalar)
                test.name = value.text;
            else
                context.report(Code::wrong_shape, value.span, "a text is due here");
        } else if (index == 1) {
            each(context, value, [&](const YamlNode& launch) { read_launch(context, test, launch); });
        } else if (index == 2) {
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

}  // namespace

void read_inputs(ReadContext& context, Scene& scene, const YamlNode& section) {
    if (section.is_empty()) return;
    if (section.kind != YamlKind::map)
        return context.report(Code::wrong_shape, section.span, "inputs are due here",
                              "write inputs: {left: [Z, LeftShift]}");
    for (std::size_t i = 0; i < section.entries() && !context.full(); ++i)
        read_binding(context, scene, section.key(i), section.value(i).resolved());
}

void read_tests(ReadContext& context, Scene& scene, const YamlNode& section) {
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

}  // namespace pinfield
