// Fields that several nodes have in common: which they are, and that a change of them is a change of each, in one step.
#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

#include "editor/edit_tools.h"
#include "editor/scrub.h"
#include "engine/core/at.h"
#include "engine/core/rng.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

constexpr const char* row_of_pins = R"(pinfield: 1
materials:
  rubber: {restitution: 0.8}  # soft
scene:
  - circle: {id: a, at: [0.1, 0.2], radius: 10mm}  # first
  - circle: {id: b, at: [0.2, 0.2], radius: 2cm, material: rubber}
  - box: {id: c, at: [0.3, 0.2], size: [10mm, 20mm]}  # third
  - bumper: {id: d, at: [0.4, 0.2], radius: 30mm, material: rubber}
)";

std::vector<NodeId> ids_of(const Document& document, std::initializer_list<std::string_view> names) {
    std::vector<NodeId> ids;
    for (const std::string_view name : names) ids.push_back(id_of(document, name));
    return ids;
}

std::vector<SharedField> shared_by(const Document& document, std::initializer_list<std::string_view> names) {
    const std::vector<NodeId> ids = ids_of(document, names);
    return shared_fields(document.scene(), ids.back(), ids);
}

std::string_view key_of(const Document& document, const SharedField& f) {
    return at(document.scene().find(f.front().node)->type->fields, f.front().field).key;
}

std::set<std::string_view> keys_of(const Document& document, std::initializer_list<std::string_view> names) {
    std::set<std::string_view> keys;
    for (const SharedField& f : shared_by(document, names)) keys.insert(key_of(document, f));
    return keys;
}

SharedField shared(const Document& document, std::initializer_list<std::string_view> names, std::string_view key) {
    for (const SharedField& f : shared_by(document, names))
        if (key_of(document, f) == key) return f;
    FAIL("they do not share " << key);
    return {};
}

const Value& value_of(const Document& document, const FieldOf& f) { return at(document.scene().find(f.node)->fields, f.field).value; }

}  // namespace

TEST_CASE("nodes share the fields of one name, kind and unit, and never their ids") {
    const Folder folder;
    const Document document = opened(folder, row_of_pins);
    const auto one = keys_of(document, {"a"}), discs = keys_of(document, {"a", "b"}), all = keys_of(document, {"a", "c", "d"});
    CHECK(one.contains("id"));
    CHECK(discs.contains("radius"));
    CHECK_FALSE(discs.contains("id"));
    CHECK_FALSE(all.contains("radius"));  // the box has none
    CHECK_FALSE(all.contains("size"));
    for (const char* key : {"at", "turn", "material"}) CHECK(all.contains(key));
    CHECK(keys_of(document, {"a", "d"}).contains("radius"));  // a shape's and a part's
    for (const SharedField& f : shared_by(document, {"a", "c", "d"})) CHECK(f.size() == 3);
}

TEST_CASE("a value that is set goes to all nodes, in one step that changes only their lines, and undo restores every byte") {
    const Folder folder;
    Document document = opened(folder, row_of_pins);
    const SharedField radius = shared(document, {"a", "b", "d"}, "radius");
    CHECK(is_mixed(document.scene(), radius));
    REQUIRE_FALSE(set_all_from_text(document, radius, "15mm"));
    for (const FieldOf& f : radius) CHECK(identical(value_of(document, f), Value(0.015)));
    CHECK_FALSE(is_mixed(document.scene(), radius));
    CHECK(document.undo_steps() == 1);
    CHECK(document.step_label(0) == "Change radius of 3 nodes");
    CHECK(changed_lines(document.source().text(), row_of_pins) == 3);
    document.undo();
    CHECK(document.source().text() == row_of_pins);
}

TEST_CASE("one number of a pair goes to all, the others stay") {
    const Folder folder;
    Document document = opened(folder, row_of_pins);
    const SharedField place = shared(document, {"a", "b", "c", "d"}, "at");
    CHECK(is_mixed(document.scene(), place, 0));
    CHECK_FALSE(is_mixed(document.scene(), place, 1));
    REQUIRE_FALSE(set_component_of_all(document, place, 1, 0.5));
    double x = 0.4;
    for (const FieldOf& f : place) {
        CHECK(identical(value_of(document, f), Value(Vec2(f.node == place.front().node ? x : std::get<Vec2>(value_of(document, f)).x(), 0.5))));
        CHECK(std::get<Vec2>(value_of(document, f)).y() == 0.5);
    }
    CHECK(document.undo_steps() == 1);
}

TEST_CASE("a value that one node does not take is taken by none, and the reason names that node") {
    const Folder folder;
    Document document = opened(folder, row_of_pins);
    const SharedField radius = shared(document, {"a", "b", "d"}, "radius");
    const auto why = set_all(document, radius, Value(-1.0));
    REQUIRE(why);
    CHECK_THAT(*why, Catch::Contains("d:"));
    CHECK(document.source().text() == row_of_pins);
    CHECK_FALSE(document.previewing());
    CHECK(document.undo_steps() == 0);
}

TEST_CASE("a number dragged in several nodes changes each by as much") {
    const Folder folder;
    Document document = opened(folder, row_of_pins);
    const SharedField radius = shared(document, {"a", "b", "d"}, "radius");
    std::vector<double> before;
    for (const FieldOf& f : radius) before.push_back(std::get<double>(value_of(document, f)));
    Scrub scrub;
    REQUIRE(scrub.begin(document, radius));
    scrub.update(document, 3);
    scrub.update(document, 7);
    REQUIRE_FALSE(scrub.end(document));
    const double by = std::get<double>(value_of(document, radius.front())) - before.front();
    CHECK(by > 0);
    for (std::size_t i = 0; i < radius.size(); ++i)
        CHECK(std::get<double>(value_of(document, radius[i])) - before[i] == Approx(by).margin(1e-9));
    CHECK(document.undo_steps() == 1);
    document.undo();
    CHECK(document.source().text() == row_of_pins);
}

TEST_CASE("the default goes to all that have a value of their own in the file") {
    const Folder folder;
    Document document = opened(folder, row_of_pins);
    const SharedField material = shared(document, {"a", "b", "d"}, "material");
    REQUIRE(any_explicit(document.scene(), material));
    REQUIRE_FALSE(reset_all(document, material));
    CHECK_FALSE(any_explicit(document.scene(), material));
    CHECK(document.source().text().find("material:") == std::string::npos);
    document.undo();
    CHECK(document.source().text() == row_of_pins);
}

TEST_CASE("who uses a material is found in the order of the file") {
    const Folder folder;
    const Document document = opened(folder, row_of_pins);
    CHECK(users_of(document.scene(), Meaning::material, "rubber") == ids_of(document, {"b", "d"}));
    CHECK(users_of(document.scene(), Meaning::material, "chalk").empty());
}

TEST_CASE("any fields that random nodes share can be set alike, and undone byte for byte") {
    const Folder folder;
    std::string table = "pinfield: 1\nscene:\n";
    for (const NodeType& type : catalog()->types())
        if (type.meta.kind == NodeKind::shape &&
            !std::any_of(type.fields.begin(), type.fields.end(), [](const FieldType& f) { return f.meta.required; }))
            table += "  - " + std::string(type.key()) + ": {id: the_" + std::string(type.key()) + "}  # kept\n";
    Document document = opened(folder, table);
    const std::vector<NodeId> nodes = document.scene().all();
    CounterRng rng(7);
    int set = 0, refused = 0;
    for (int trial = 0; trial < 400; ++trial) {
        std::vector<NodeId> some;
        for (int i = 0; i < 3; ++i) some.push_back(at(nodes, static_cast<int>(rng.in(0, static_cast<double>(nodes.size()) - 1e-9))));
        some.erase(std::unique(some.begin(), some.end()), some.end());
        const auto fields = shared_fields(document.scene(), some.back(), some);
        if (fields.empty()) continue;
        const SharedField& field = at(fields, static_cast<int>(rng.in(0, static_cast<double>(fields.size()) - 1e-9)));
        const FieldType& type = at(document.scene().find(field.front().node)->type->fields, field.front().field);
        if (type.meta.meaning == Meaning::id || type.meta.meaning == Meaning::material) continue;
        const std::string before = document.source().text();
        const std::size_t steps = document.undo_steps();
        const Value value = type.kind == FieldKind::number ? Value(rng.in(0.001, 0.05)) : value_of(document, field.back());
        INFO(type.key << " of " << field.size() << " nodes");
        if (set_all(document, field, value)) {
            ++refused;
            CHECK(document.source().text() == before);
            continue;
        }
        ++set;
        for (const FieldOf& f : field) CHECK(identical(value_of(document, f), value));
        CHECK(document.undo_steps() <= steps + 1);
        if (document.undo_steps() > steps) {
            document.undo();
            CHECK(document.source().text() == before);
        }
    }
    CHECK(set > 200);
    CHECK(refused < set);
}
