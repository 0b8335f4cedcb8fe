// Handles: every node's own, found from its description; the outline goes through the hand.
#include "editor/handles.h"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "editor/edit_tools.h"
#include "engine/core/at.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

const std::string empty_table = "pinfield: 1\ntable: {size: [1, 1]}\nscene:\n  - circle: {id: first, at: [0.1, 0.1]}\n";

AppState table_with(const Folder& folder, const std::string& node) {
    AppState state = opened_state(folder, "pinfield: 1\ntable: {size: [1, 1]}\ninputs: {left: [Z]}\nscene:\n  - " + node + "\n");
    INFO(node);
    REQUIRE_FALSE(has_errors(state.document.diagnostics()));
    advance(state, 0);
    return state;
}

std::string names_of(const Scene& scene, NodeId id, const std::vector<Handle>& handles) {
    std::string out;
    for (const Handle& handle : handles) {
        if (handle.kind == HandleKind::gap) continue;
        const FieldType& field = at(scene.find(id)->type->fields, handle.field);
        out += fmt::format("{}{}{}", out.empty() ? "" : " ", field.key, handle.component ? fmt::format(".{}", handle.component) : "");
    }
    return out;
}

std::string names_in(const AppState& state, std::string_view node) {
    const Scene& scene = state.document.scene();
    const NodeId id = scene.find(node)->id;
    return names_of(scene, id, handles_of(scene, id));
}

const Handle& handle_named(const std::vector<Handle>& handles, const Node& node, std::string_view key, int component = 0) {
    for (const Handle& handle : handles)
        if (handle.kind != HandleKind::gap && at(node.type->fields, handle.field).key == key && handle.component == component)
            return handle;
    FAIL("no handle of " << key);
    return handles.front();
}

double value_now(const AppState& state, NodeId node, const Handle& handle) {
    return component(at(state.document.scene().find(node)->fields, handle.field).value, handle.component);
}

}  // namespace

TEST_CASE("the outline of every node goes through the hand that drags its handle, or says what keeps it") {
    int followed = 0, stopped = 0;
    for (const NodeType& type : catalog()->types()) {
        if (type.meta.kind == NodeKind::record || type.key() == "domain") continue;
        INFO(type.key());
        const Folder folder;
        AppState state = opened_state(folder, empty_table);
        add_node(state, type);
        const NodeId id = state.selection.primary();
        REQUIRE(state.document.scene().find(id)->type == &type);
        for (const Handle& handle : handles_of(state.document.scene(), id)) {
            if (handle.kind != HandleKind::outline) continue;
            INFO(at(type.fields, handle.field).key << "." << handle.component);
            CHECK(length(handle.normal) == Approx(1));
            for (const double way : {2e-3, -2e-3, 7e-4}) {
                HandleDrag drag;
                REQUIRE(drag.begin(state.document, id, handle, handle.at));
                const Vec2 hand = handle.at + way * handle.normal;
                CHECK_FALSE(drag.update(state.document, hand, square_grid(0)));
                const std::optional<LoneShape> shape = LoneNode(state.document.scene(), id).shape();
                REQUIRE(shape);
                INFO(way);
                if (drag.stopped_by()) {
                    ++stopped;
                } else {
                    ++followed;
                    // Numbers are rounded to a hundredth of their step.
                    const double step = scrub_step(at(type.fields, handle.field), value_now(state, id, handle));
                    CHECK(std::fabs(shape->distance(hand)) < 2e-5 + 0.01 * step * std::fabs(handle.speed));
                }
                drag.cancel(state.document);
            }
        }
    }
    CHECK(followed > 250);
    CHECK(15 * stopped < followed);  // mostly of numbers that begin at their least
}

TEST_CASE("every length of a shape has a handle") {
    for (const NodeType& type : catalog()->types()) {
        if (type.meta.kind != NodeKind::shape) continue;
        const Folder folder;
        AppState state = opened_state(folder, empty_table);
        add_node(state, type);
        const NodeId id = state.selection.primary();
        const Node& node = *state.document.scene().find(id);
        const std::vector<Handle> handles = handles_of(state.document.scene(), id);
        for (int i = 0; i < type.own_fields; ++i) {
            const FieldType& field = at(type.fields, i);
            if (field.meta.unit != Unit::metre || !node.has_use_for(static_cast<std::size_t>(i))) continue;
            INFO(type.key() << "." << field.key);
            CHECK(std::any_of(handles.begin(), handles.end(), [&](const Handle& handle) { return handle.field == i; }));
        }
    }
}

TEST_CASE("handles lie where a person looks for them") {
    const Folder folder;
    const auto of = [&](const std::string& text) { return table_with(folder, text); };
    const AppState box = of("box: {id: it, size: [80mm, 40mm]}");
    const Node& node = *box.document.scene().find("it");
    const std::vector<Handle> handles = handles_of(box.document.scene(), node.id);
    CHECK(length(handle_named(handles, node, "size", 0).at - Vec2(0.04, 0)) < 1e-6);
    CHECK(length(handle_named(handles, node, "size", 1).at - Vec2(0, 0.02)) < 1e-6);
    const AppState disc = of("circle: {id: it, radius: 30mm}");
    CHECK(length(handles_of(disc.document.scene(), id_of(disc.document, "it")).front().at - Vec2(0.03, 0)) < 1e-3);
    CHECK(names_in(of("segment: {id: it, a: [0, 0], b: [0.2, 0]}"), "it") == "a b thickness");
    CHECK(names_in(of("polygon: {id: it, points: [[0, 0], [0.1, 0], [0, 0.1]]}"), "it") == "points points.2 points.4");
    CHECK(names_in(of("flipper: {id: it, input: [left]}"), "it") == "length radius_pivot radius_tip rest swing");
    CHECK(names_in(of("plunger: {id: it, input: [left]}"), "it") == "size size.1 stroke");
    CHECK(names_in(of("spawn: {id: it, velocity: [0, 1]}"), "it") == "velocity");
    CHECK(names_in(of("group: {id: it, children: [circle: {}]}"), "it").empty());
    CHECK(names_in(of("smooth_union: {id: it, k: 20mm, children: [circle: {radius: 30mm}, circle: {at: [50mm, 0], radius: 30mm}]}"),
                   "it") == "k");
}

TEST_CASE("a handle's number stops where the contract ends, and says so") {
    const Folder folder;
    AppState state = table_with(folder, "star: {id: it, outer: 50mm, inner: 20mm}");
    const NodeId id = id_of(state.document, "it");
    const Node& node = *state.document.scene().find(id);
    const Handle handle = handle_named(handles_of(state.document.scene(), id), node, "inner");
    HandleDrag drag;
    REQUIRE(drag.begin(state.document, id, handle, handle.at));
    CHECK_FALSE(drag.update(state.document, 4 * handle.at, square_grid(default_grid)));
    REQUIRE(drag.stopped_by());
    CHECK(drag.stopped_by()->find("inner <= outer") != std::string::npos);
    CHECK(value_now(state, id, handle) == Approx(0.05));
    CHECK_FALSE(drag.end(state.document));
    CHECK(state.document.undo_steps() == 1);
    CHECK(*state.document.undo_label() == "Change inner of it");
}

TEST_CASE("a place follows the hand on the grid; a click on it changes nothing") {
    const Folder folder;
    AppState state = table_with(folder, "triangle: {id: it, at: [0.5, 0.5], turn: 30, scale: 2}");
    const std::string before = state.document.source().text();
    const NodeId id = id_of(state.document, "it");
    const Handle handle = handle_named(handles_of(state.document.scene(), id), *state.document.scene().find(id), "b");
    HandleDrag drag;
    REQUIRE(drag.begin(state.document, id, handle, handle.at + Vec2(1e-3, 0)));  // taken hold of a little beside
    drag.update(state.document, handle.at + Vec2(1e-3, 0), square_grid(default_grid));
    CHECK_FALSE(drag.end(state.document));
    CHECK(state.document.source().text() == before);
    REQUIRE(drag.begin(state.document, id, handle, handle.at + Vec2(1e-3, 0)));
    drag.update(state.document, handle.at + Vec2(0.0123, 0.0044), square_grid(default_grid));
    CHECK_FALSE(drag.end(state.document));
    const Vec2 now = state.document.scene().find(id)->get<Vec2>("b");
    CHECK(now.x() == Approx(handle.at.x() + 0.011).margin(1e-9));
    CHECK(now.y() == Approx(handle.at.y() + 0.004).margin(1e-9));
}

TEST_CASE(
    "a point put between two others leaves the shape, until it is dragged; points can be taken out again down to what the node needs") {
    const Folder folder;
    AppState state = table_with(folder, "polygon: {id: it, points: [[0, 0], [0.1, 0], [0, 0.1]]}");
    const NodeId id = id_of(state.document, "it");
    std::vector<Handle> gaps;
    for (const Handle& handle : handles_of(state.document.scene(), id))
        if (handle.kind == HandleKind::gap) gaps.push_back(handle);
    REQUIRE(gaps.size() == 3);
    CHECK(length(gaps[2].at - Vec2(0, 0.05)) < 1e-9);
    HandleDrag drag;
    REQUIRE(drag.begin(state.document, id, gaps[1], gaps[1].at));
    drag.update(state.document, gaps[1].at + Vec2(0.03, 0.03), square_grid(default_grid));
    CHECK_FALSE(drag.end(state.document));
    const int field = *state.document.scene().find(id)->type->find_field("points");
    const auto points = [&] { return state.document.scene().find(id)->get<std::vector<Vec2>>("points"); };
    REQUIRE(points().size() == 4);
    CHECK(length(points()[2] - Vec2(0.08, 0.08)) < 1e-9);
    select(state, id);
    state.point = PickedPoint{id, field, 0};
    run(state, "edit.delete");
    CHECK(points().size() == 3);
    CHECK(length(points()[0] - Vec2(0.1, 0)) < 1e-9);
    state.point = PickedPoint{id, field, 0};
    run(state, "edit.delete");
    CHECK(points().size() == 3);
    CHECK(state.message_is_problem);
    run(state, "edit.delete");
    CHECK_FALSE(state.document.scene().find(id));
}

TEST_CASE("what is locked, or lies in something locked, is not dragged by its handles") {
    const Folder folder;
    for (const char* locks : {"group: {locked: true, children: [circle: {id: it}]}", "circle: {id: it, locked: true}",
                              "group: {children: [circle: {id: it}]}"}) {
        AppState state = table_with(folder, locks);
        const NodeId id = id_of(state.document, "it");
        HandleDrag drag;
        const Handle handle = handles_of(state.document.scene(), id).front();
        CHECK(drag.begin(state.document, id, handle, handle.at) == (std::string_view(locks).find("locked") == std::string_view::npos));
    }
}

TEST_CASE("a path gets new points where they mean more of the same, and nowhere else") {
    const Folder folder;
    const auto gaps_of = [&](const std::string& text) {
        const AppState state = table_with(folder, text);
        int count = 0;
        for (const Handle& handle : handles_of(state.document.scene(), id_of(state.document, "it")))
            count += handle.kind == HandleKind::gap;
        return count;
    };
    CHECK(gaps_of("path: {id: it, points: [[0, 0], [0.1, 0], [0.1, 0.1]], pieces: [line]}") == 2);
    CHECK(gaps_of("path: {id: it, points: [[0, 0], [0.1, 0.1], [0.2, 0]], pieces: [arc]}") == 0);
    CHECK(gaps_of("path: {id: it, points: [[0, 0], [0, 0.1], [0.1, 0.1], [0.1, 0]], pieces: [cubic]}") == 0);
}

TEST_CASE("the arrow of a velocity shows the way of a tenth of a second") {
    const Folder folder;
    AppState state = table_with(folder, "spawn: {id: it, at: [0.5, 0.5], velocity: [0, 1]}");
    const NodeId id = id_of(state.document, "it");
    const Handle handle = handles_of(state.document.scene(), id).front();
    CHECK(length(handle.at - Vec2(0, 0.1)) < 1e-12);
    HandleDrag drag;
    REQUIRE(drag.begin(state.document, id, handle, handle.at));
    drag.update(state.document, Vec2(0.2, 0.1), square_grid(default_grid));
    CHECK_FALSE(drag.end(state.document));
    CHECK(length(state.document.scene().find(id)->get<Vec2>("velocity") - Vec2(2, 1)) < 1e-9);
}
