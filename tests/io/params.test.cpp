// Params: numbers of the table's own, read in whatever order they need each other, and set without touching the text.
#include <catch2/catch.hpp>

#include <fmt/format.h>
#include <rapidcheck.h>

#include "engine/io/param_patch.h"
#include "engine/io/quantity.h"
#include "engine/io/write_table.h"
#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

double number(const Reading& reading, std::string_view path, std::string_view key) { return reading.scene.find(path)->get<double>(key); }

const Param& param(const Reading& reading, std::string_view name) {
    const auto& params = reading.scene.params;
    return *std::find_if(params.begin(), params.end(), [&](const Param& p) { return p.name == name; });
}

/// Params that each need some of those before them in `order`, written in the order of their names.
struct RandomParams {
    std::vector<double> factors;           ///< of each
    std::vector<std::vector<int>> needs;   ///< by the place in `order`, smaller ones only
    std::vector<int> order;                ///< place -> name
};

RandomParams random_params() {
    RandomParams out;
    const int count = *rc::gen::inRange(1, 8);
    for (int i = 0; i < count; ++i) {
        out.factors.push_back(*rc::gen::inRange(1, 20));
        out.needs.emplace_back();
        for (int j = 0; j < i; ++j)
            if (*rc::gen::arbitrary<bool>()) out.needs.back().push_back(j);
        out.order.insert(out.order.begin() + *rc::gen::inRange(0, i + 1), i);
    }
    return out;
}

std::string text_of(const RandomParams& params, const std::map<int, double>& set) {
    std::vector<std::string> lines(params.factors.size());
    for (std::size_t place = 0; place < params.factors.size(); ++place) {
        const auto fixed = set.find(params.order[place]);
        std::string value = fmt::format("{}mm", params.factors[place]);
        for (const int need : params.needs[place]) value += fmt::format(" + p{}", params.order[static_cast<std::size_t>(need)]);
        if (fixed != set.end()) value = fmt::format("{}", fixed->second);
        lines[static_cast<std::size_t>(params.order[place])] = value;
    }
    std::string out = "pinfield: 1\nparams:\n", nodes;
    for (std::size_t name = 0; name < lines.size(); ++name) {
        out += fmt::format("  p{}: {}\n", name, lines[name]);
        nodes += fmt::format("  - circle: {{id: c{0}, radius: 1m + p{0}}}\n", name);
    }
    return out + "scene:\n" + nodes;
}

}  // namespace

TEST_CASE("params are worked out in whatever order they need each other") {
    const Reading reading = read(
        "pinfield: 1\n"
        "params:\n"
        "  petal: gap * teeth / 2\n"
        "  gap: {value: 46mm, min: least, max: 60mm, step: 1mm, label: Lane pitch}\n"
        "  least: 4cm\n"
        "  teeth: {value: 9, min: 3, max: 24, step: 1}\n"
        "  turn: {value: 30, unit: deg}\n"
        "scene:\n"
        "  - circle: {id: a, radius: petal, at: [gap, -gap], turn: turn}\n"
        "  - regular_polygon: {id: b, sides: teeth, radius: 1cm}\n");
    INFO(told(reading));
    REQUIRE(reading.ok());
    CHECK(number(reading, "a", "radius") == 0.046 * 9 / 2);
    CHECK(reading.scene.find("a")->get<Vec2>("at") == Vec2(0.046, -0.046));
    CHECK(number(reading, "a", "turn") == 30);
    CHECK(reading.scene.find("b")->get<std::int64_t>("sides") == 9);
    REQUIRE(reading.scene.params.size() == 5);
    CHECK(param(reading, "petal").is_calculated);
    const Param& gap = param(reading, "gap");
    CHECK_FALSE(gap.is_calculated);
    CHECK(gap.label == "Lane pitch");
    CHECK((gap.min->value == 0.04 && gap.max->value == 0.06 && gap.step->value == 0.001));
    CHECK(param(reading, "turn").dimension == dimension_of(Unit::degree));
}

TEST_CASE("an angle may not stand where a length is due, whatever param it comes through") {
    const Reading reading = read("pinfield: 1\nparams: {a: 30deg, b: 2 * a}\nscene: [circle: {radius: b}]\n");
    CHECK(codes_and_places(reading) == std::vector<std::string>{"E0213 3:26"});
}

TEST_CASE("what is wrong with a param is told once, and not of what depends on it") {
    const Reading reading = read("pinfield: 1\nparams: {a: 1 / 0, b: 2 * a}\nscene: [circle: {radius: b}, circle: {radius: a}]\n");
    CHECK(codes_and_places(reading) == std::vector<std::string>{"E0226 2:13"});
}

TEST_CASE("a param that nothing depends on is told, and one that only another needs is not") {
    const Reading reading = read("pinfield: 1\nparams: {a: 1cm, b: 2 * a, c: 3cm}\nscene: [circle: {radius: b}]\n");
    CHECK(codes_and_places(reading) == std::vector<std::string>{"W0513 2:28"});
}

TEST_CASE("as many params are read as the limit says, and not one more") {
    const auto table = [](std::size_t count) {
        std::string text = "pinfield: 1\nparams:\n  p0: 1cm\n";
        for (std::size_t i = 1; i < count; ++i) text += fmt::format("  p{}: p{}\n", i, i - 1);
        return text + fmt::format("scene: [circle: {{radius: p{}}}]\n", count - 1);
    };
    const Reading most = read(table(Limits{}.params));
    INFO(told(most));
    CHECK(most.diagnostics.empty());
    CHECK(read(table(Limits{}.params + 1)).diagnostics.front().code == "E0125");
}

TEST_CASE("random params give what a hand would work out, in any order") {
    CHECK(rc::check([] {
        const RandomParams params = random_params();
        const Reading reading = read(text_of(params, {}));
        RC_ASSERT(reading.ok());
        std::vector<double> values;
        for (std::size_t place = 0; place < params.factors.size(); ++place) {
            double value = params.factors[place] / 1000;
            for (const int need : params.needs[place]) value += values[static_cast<std::size_t>(need)];
            values.push_back(value);
            const double radius = number(reading, fmt::format("c{}", params.order[place]), "radius");
            RC_ASSERT(std::fabs(radius - (1 + value)) <= 1e-12 * value);
        }
    }));
}

TEST_CASE("a param that is set gives the table whose text says the value") {
    CHECK(rc::check([] {
        const RandomParams params = random_params();
        const Reading now = read(text_of(params, {}));
        const int which = *rc::gen::inRange(0, static_cast<int>(params.factors.size()));
        const double value = *rc::gen::inRange(1, 1000) / 4096.0;
        const Reading set = read_with_params(now, {{fmt::format("p{}", which), value}});
        const Reading written = read(text_of(params, {{which, value}}));
        RC_ASSERT(set.ok());
        for (const NodeId id : written.scene.all()) {
            const Node& node = *written.scene.find(id);
            if (!node.name.empty()) RC_ASSERT(identical(set.scene.find(node.name)->value("radius"), node.value("radius")));
        }
    }));
}

TEST_CASE("a slider changes the param's number in its own unit and decimals, and not a byte more") {
    const std::string text =
        "pinfield: 1\n"
        "params:  # what may be turned\n"
        "  gap: {value: 46.0mm, min: 40mm, max: 60mm}   # lanes\n"
        "  teeth: '9'\n"
        "  twice: 2 * gap\n"
        "scene:\n"
        "  - circle: {id: a, radius: twice}\n"
        "  - circle: {id: b, radius: 1cm, copies: {count: teeth, step: [gap, 0]}}\n";
    const Reading now = read(text);
    const auto set = [&](const std::string& name, double value) {
        const auto patched = patch_param(now, name, value);
        INFO((patched ? "" : patched.error().message));
        REQUIRE(patched);
        const Node& a = *patched->reading.scene.find("a");
        CHECK(a.id == now.scene.find("a")->id);
        return patched->reading.source().text();
    };
    const auto replaced = [&](std::string_view from, std::string_view to) { return std::string(text).replace(text.find(from), from.size(), to); };
    CHECK(set("gap", 0.0475) == replaced("46.0mm", "47.5mm"));
    CHECK(set("gap", 0.05) == replaced("46.0mm", "50.0mm"));
    CHECK(set("teeth", 11) == replaced("'9'", "'11'"));
    CHECK(patch_param(now, "gap", 0.061).error().message == "gap is at most 60mm");
    CHECK(patch_param(now, "twice", 0.1).error().message.find("twice follows `2 * gap`") == 0);
    CHECK(patch_param(now, "teeth", 2.5).error().message.find("line 8") == 0);
    CHECK(patch_param(now, "tooth", 2).error().message == "no param is called tooth");
}
