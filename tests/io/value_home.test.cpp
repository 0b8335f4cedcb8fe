// Values that templates, copies and expressions give: each may be changed where it comes from, and nothing else changes with it.
#include "engine/io/value_home.h"

#include <catch2/catch.hpp>

#include "engine/core/at.h"
#include "engine/io/yaml_items.h"
#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

using Kind = ValueHome::Kind;

const std::string once = R"(pinfield: 1
params: {gap: 50mm, bloom: {value: 34mm, min: 20mm, max: 40mm}, small: bloom * 0.5}   # two of them move
materials: {rubber: {}, goo: {}}
templates:
  gear:
    args: {r: 40mm, skin: rubber}
    nodes:
      - circle: {id: wheel, radius: r, material: $skin}   # the disc
      - box: {id: tooth, size: [5mm, 1cm], at: [0, 50mm]}
scene:
  - use: {template: gear, id: large, at: [0.2, 0.6]}   # alone
  - use: {template: gear, id: tiny, at: [0.4, 0.6], with: {r: small, skin: goo}}
  - capsule:                                           # a row
      id: lane
      # where it begins
      at: [0.1, 0.9]
      length: 30mm
      radius: 5mm
      copies: {count: 3, step: [gap, 0]}
  - bumper: {id: pop, at: [0.26, 0.8], radius: 24mm, copies: {count: 3, around: [0.26, 0.75]}}
  - flipper: {id: flip, at: [0.17, 0.12], rest: -30, swing: 51, input: [left, right], pair: 0.26}
  - group: {id: box, children: [use: {template: gear, id: held}]}
  - circle: {id: dot, at: [bloom * 2, 0.3], radius: bloom}
  - circle: {id: plain, radius: 1cm}
inputs: {left: Z, right: Slash}
tests:
  - {name: still, run: 1s, expect: [flip.left.hits == 0, escaped == 0]}
)";

SetField change(const Reading& now, std::string_view node, std::string_view field, Value value) {
    const Node* found = now.scene.find(node);
    REQUIRE(found);
    return {found->id, *found->type->find_field(field), std::move(value), true};
}

ValueHome home(const Reading& now, const SetField& edit, Kind kind, const std::string& name = {}) {
    for (const ValueHome& home : homes_of(now, edit))
        if (home.kind == kind && (name.empty() || home.name == name)) return home;
    FAIL("no such home");
    return {};
}

std::vector<std::string> told_homes(const Reading& now, const SetField& edit) {
    std::vector<std::string> out;
    for (const ValueHome& home : homes_of(now, edit)) out.push_back(home.told + " (" + std::to_string(home.values) + ")");
    return out;
}

std::string with(std::string text, const std::string& from, const std::string& to) {
    INFO(from);
    REQUIRE(text.find(from) != std::string::npos);
    return text.replace(text.find(from), from.size(), to);
}

std::string patched(const Reading& now, const SetField& edit, const ValueHome& home) {
    const Result<PatchedText> out = patch_home(now, edit, home);
    if (!out) FAIL_CHECK(out.error().message);
    return out ? out->reading.source().text() : std::string();
}

std::vector<std::string> comments_of(const Reading& reading) {
    const std::string& text = reading.source().text();
    std::vector<std::string> out;
    for (const Span& span : comments_in(text, {0, text.size()}, *reading.tree->root)) out.push_back(text.substr(span.begin, span.end - span.begin));
    std::sort(out.begin(), out.end());
    return out;
}

double off(const Value& a, const Value& b) {
    if (const auto* x = std::get_if<double>(&a)) return std::fabs(*x - std::get<double>(b));
    if (const auto* p = std::get_if<Vec2>(&a)) return length(*p - std::get<Vec2>(b));
    return identical(a, b) ? 0 : 1e9;
}

}  // namespace

TEST_CASE("where a value comes from is told, the nearest first") {
    const Reading now = read(once);
    INFO(told(now));
    REQUIRE(now.ok());
    using Homes = std::vector<std::string>;
    CHECK(told_homes(now, change(now, "plain", "radius", 0.02)) == Homes{});
    CHECK(told_homes(now, change(now, "dot", "radius", 0.036)) == Homes{"the param bloom (1)", "here, in place of bloom (1)"});
    CHECK(told_homes(now, change(now, "tiny.wheel", "radius", 0.02)) ==
          Homes{"r of this tiny (1)", "the param bloom (1)", "in the template gear, in place of r (3)", "here only: tiny is written out (1)"});
    CHECK(told_homes(now, change(now, "large.wheel", "radius", 0.02)) ==
          Homes{"r of this large (1)", "in the template gear, in place of r (3)", "here only: large is written out (1)"});
    CHECK(told_homes(now, change(now, "large.tooth", "size", Vec2(1, 1))) ==
          Homes{"in the template gear (3)", "here only: large is written out (1)"});
    CHECK(told_homes(now, change(now, "lane.2", "radius", 0.006)) == Homes{"in the item it is made of (3)", "here only: lane is written out (1)"});
}

TEST_CASE("a param is turned until the field that follows it has its value") {
    const Reading now = read(once);
    const SetField radius = change(now, "dot", "radius", 0.036), at = change(now, "dot", "at", Vec2(0.07, 0.31));
    CHECK(patched(now, radius, home(now, radius, Kind::param)) == with(once, "value: 34mm", "value: 36mm"));
    CHECK(patched(now, at, home(now, at, Kind::param)) == with(with(once, "value: 34mm", "value: 35mm"), "[bloom * 2, 0.3]", "[bloom * 2, 0.31]"));
    const SetField through = change(now, "tiny.wheel", "radius", 0.0185);
    CHECK(patched(now, through, home(now, through, Kind::param)) == with(once, "value: 34mm", "value: 37mm"));
    const SetField large = change(now, "dot", "radius", 0.05);
    CHECK(patch_home(now, large, home(now, large, Kind::param)).error().message == "bloom is at most 40mm");
}

TEST_CASE("an argument is changed for this use alone, or given to it") {
    const Reading now = read(once);
    const SetField tiny = change(now, "tiny.wheel", "radius", 0.02), large = change(now, "large.wheel", "radius", 0.045);
    CHECK(patched(now, tiny, home(now, tiny, Kind::argument)) == with(once, "r: small", "r: 20mm"));
    CHECK(patched(now, large, home(now, large, Kind::argument)) ==
          with(once, "{template: gear, id: large, at: [0.2, 0.6]}", "{template: gear, id: large, at: [0.2, 0.6], with: {r: 45mm}}"));
    const SetField skin = change(now, "tiny.wheel", "material", std::string("rubber"));
    CHECK(patched(now, skin, home(now, skin, Kind::argument)) == with(once, "skin: goo", "skin: rubber"));
}

TEST_CASE("the line of a template or a copied item is changed for all that it makes") {
    const Reading now = read(once);
    const SetField tooth = change(now, "large.tooth", "size", Vec2(0.005, 0.012)), wheel = change(now, "tiny.wheel", "radius", 0.03);
    CHECK(patched(now, tooth, home(now, tooth, Kind::line)) == with(once, "[5mm, 1cm]", "[5mm, 1.2cm]"));
    CHECK(patched(now, wheel, home(now, wheel, Kind::line)) == with(once, "radius: r,", "radius: 0.03,"));
    const SetField turn = change(now, "large.tooth", "turn", 5.0);
    CHECK(patched(now, turn, home(now, turn, Kind::line)) == with(once, "at: [0, 50mm]}", "at: [0, 50mm], turn: 5}"));
    const SetField lane = change(now, "lane.2", "at", Vec2(0.16, 0.88));
    CHECK(patched(now, lane, home(now, lane, Kind::line)) == with(once, "at: [0.1, 0.9]", "at: [0.11, 0.88]"));
    const SetField right = change(now, "flip.right", "at", Vec2(0.36, 0.13));
    CHECK(patched(now, right, home(now, right, Kind::line)) == with(once, "at: [0.17, 0.12]", "at: [0.16, 0.13]"));
    const SetField here = change(now, "dot", "radius", 0.036);
    CHECK(patched(now, here, home(now, here, Kind::line)) == with(once, "radius: bloom}", "radius: 0.036}"));
}

TEST_CASE("a copy that is turned about a point goes where it is dragged, and the others with it") {
    const Reading now = read(once);
    const SetField pop = change(now, "pop.2", "at", Vec2(0.2, 0.7));
    const auto out = patch_home(now, pop, home(now, pop, Kind::line));
    REQUIRE(out);
    CHECK(length(out->reading.scene.find("pop.2")->get<Vec2>("at") - Vec2(0.2, 0.7)) < 1e-8);
    const double r = length(Vec2(0.2, 0.7) - Vec2(0.26, 0.75));
    for (const char* other : {"pop.1", "pop.3"}) CHECK(length(out->reading.scene.find(other)->get<Vec2>("at") - Vec2(0.26, 0.75)) == Approx(r));
}

TEST_CASE("here only: what made the node is written out, and the tests follow its names") {
    const Reading now = read(once);
    const SetField flip = change(now, "flip.right", "rest", -25.0);
    const auto out = patch_home(now, flip, home(now, flip, Kind::own));
    if (!out) FAIL(out.error().message);
    const Scene& scene = out->reading.scene;
    REQUIRE(scene.find("flip_right"));
    CHECK(scene.find("flip_right")->get<double>("rest") == -25);
    CHECK(scene.find("flip_left")->get<double>("rest") == -30);
    CHECK(scene.find("flip_right")->id == now.scene.find("flip.right")->id);
    CHECK_THAT(out->reading.source().text(), Catch::Contains("flip_left.hits == 0, escaped == 0"));
    const SetField lane = change(now, "lane.2", "radius", 0.006);
    const std::string text = patched(now, lane, home(now, lane, Kind::own));
    CHECK_THAT(text, Catch::Contains("# a row") && Catch::Contains("# where it begins") && !Catch::Contains("copies: {count: 3, step"));
    const SetField held = change(now, "held.tooth", "turn", 3.0);
    CHECK_THAT(patched(now, held, home(now, held, Kind::own)), Catch::Contains("children: [group: {id: held, children: [") && Catch::Contains("turn: 3"));
}

TEST_CASE("a turn that only its row gives a copy is added to, not taken for the item's own") {
    const std::string row = R"(pinfield: 1
scene:
  - box: {id: blade, at: [0.26, 0.8], size: [5mm, 20mm], copies: {count: 4, around: [0.26, 0.75]}}
)";
    const Reading now = read(row);
    INFO(told(now));
    REQUIRE(now.ok());
    const double turned = now.scene.find("blade.2")->get<double>("turn");
    REQUIRE(std::fabs(turned) == Approx(90));
    const SetField more = change(now, "blade.2", "turn", turned + 5);
    CHECK(patched(now, more, home(now, more, Kind::line)) == with(row, "0.75]}}", "0.75]}, turn: 5}"));
}

TEST_CASE("a line that an anchor lends to a node elsewhere is not changed under that node's hands") {
    const Reading now = read(R"(pinfield: 1
templates:
  gear:
    nodes:
      - box: {id: tooth, size: &tooth [5mm, 1cm]}
scene:
  - use: {template: gear, id: large, at: [0.2, 0.6]}
  - box: {id: plain, at: [0.3, 0.3], size: *tooth}
)");
    INFO(told(now));
    REQUIRE(now.ok());
    const SetField tooth = change(now, "large.tooth", "size", Vec2(0.005, 0.012));
    const auto out = patch_home(now, tooth, home(now, tooth, Kind::line));
    REQUIRE_FALSE(out);
    CHECK(out.error().message == "the value is shared by 2 places of the file; edit the text");
}

// Random fields of every made node and every expression of all good tables, at every home they have.
TEST_CASE("at whatever home a value is changed, it has the value that is due, comments stay, and what does not come from there stays") {
    CounterRng rng(31);
    int done = 0, refused = 0, of_kind[4] = {};
    auto tables = good_tables();
    tables.emplace_back("once", once);
    tables.emplace_back("once, CRLF", [] {
        std::string out;
        for (const char c : once) out += c == '\n' ? std::string("\r\n") : std::string(1, c);
        return out;
    }());
    tables.emplace_back("moonrise", file_text(std::filesystem::path(test::source_dir()) / "tests/program/moonrise_once.yaml"));
    for (const auto& [name, text] : tables) {
        const Reading now = read(text);
        for (const NodeId id : now.scene.all()) {
            const Node& node = *now.scene.find(id);
            for (int trial = 0; trial < 3; ++trial) {
                const auto field = static_cast<int>(rng.next_u64() % node.fields.size());
                const FieldType& type = at(node.type->fields, field);
                SetField edit{id, field, another_value(type, at(node.fields, field).value, rng), true};
                if (auto* number = std::get_if<double>(&edit.value)) *number = std::round(*number * 1e4) / 1e4;
                if (auto* point = std::get_if<Vec2>(&edit.value)) *point = {std::round(point->x() * 1e4) / 1e4, std::round(point->y() * 1e4) / 1e4};
                if (why_invalid(type, edit.value)) continue;
                for (const ValueHome& home : homes_of(now, edit)) {
                    const Result<PatchedText> out = patch_home(now, edit, home);
                    INFO(name << ": " << now.scene.path(id) << "." << type.key << " " << home.told);
                    if (!out) {
                        ++refused;
                        CHECK_FALSE(out.error().message.empty());
                        continue;
                    }
                    ++done;
                    ++of_kind[static_cast<int>(home.kind)];
                    INFO(out->reading.source().text());
                    CHECK(off(at(out->reading.scene.find(id)->fields, field).value, edit.value) < 1e-5);
                    CHECK(comments_of(out->reading) == comments_of(now));
                    CHECK(out->reading.scene.all() == now.scene.all());
                    for (const NodeId other : now.scene.all()) {
                        const Node &was = *now.scene.find(other), &is = *out->reading.scene.find(other);
                        if (home.kind != Kind::own && (was.origin || other == id)) continue;
                        for (std::size_t i = 0; i < was.fields.size(); ++i) {
                            const bool is_name = was.type->fields[i].meta.meaning == Meaning::id;
                            if ((other == id && static_cast<int>(i) == field) || was.fields[i].written || is_name) continue;
                            CHECK(identical(was.fields[i].value, is.fields[i].value));
                        }
                    }
                }
            }
        }
    }
    INFO(done << " done, " << refused << " refused; line " << of_kind[0] << ", argument " << of_kind[1] << ", param " << of_kind[2] << ", own " << of_kind[3]);
    CHECK(done > 300);
    CHECK(refused < done);
    for (const int count : of_kind) CHECK(count > 5);
}
