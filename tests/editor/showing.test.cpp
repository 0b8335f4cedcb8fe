// Copies that mirrors, repetitions and warps show of a node: places go in and come out, and handles are where the copy is.
#include "editor/showing.h"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "editor/handles.h"
#include "editor/pick.h"
#include "engine/core/at.h"
#include "engine/program/evaluate.h"
#include "tests/editor/desk.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

struct Case {
    const char* operation;  ///< with %s where its only child stands
    int copies;
};

constexpr const char* child = "circle: {id: it, at: [60mm, 20mm], radius: 15mm}";

/// What shows a child in one way or another, about (0.5, 0.5).
const std::vector<Case> cases{
    {"mirror: {id: op, at: [0.5, 0.5], children: [CHILD]}", 2},
    {"mirror: {id: op, at: [0.5, 0.5], turn: 30, across: y, children: [CHILD]}", 2},
    {"repeat: {id: op, at: [0.5, 0.5], count: [3, 2], step: [0.1, 0.12], children: [CHILD]}", 6},
    {"repeat_polar: {id: op, at: [0.5, 0.5], turn: 10, count: 5, children: [CHILD]}", 5},
    {"bend: {id: op, at: [0.5, 0.5], sag: 30mm, length: 0.3, children: [CHILD]}", 1},
    {"twist: {id: op, at: [0.5, 0.5], angle: 60, radius: 0.2, children: [CHILD]}", 1},
    {"stretch: {id: op, at: [0.5, 0.5], turn: 20, by: [1.5, 0.7], children: [CHILD]}", 1},
    {"mirror: {at: [0.5, 0.5], children: [bend: {turn: 15, scale: 1.2, sag: 20mm, length: 0.3, children: [CHILD]}]}", 2},
    {"repeat_polar: {at: [0.5, 0.5], count: 3, children: [mirror: {turn: 40, at: [0.1, 0], children: [union: {children: [CHILD]}]}]}", 6},
    {"circle: {at: [0.2, 0.2], radius: 10mm}\n  - group: {at: [0.1, 0.1], turn: 15, children: [mirror: {at: [0.3, 0.3], children: "
     "[CHILD]}]}",
     2},
};

std::string text_of(std::string scene) {
    scene.replace(scene.find("CHILD"), 5, child);
    return "pinfield: 1\ntable: {size: [1, 1]}\nscene:\n  - " + scene + "\n";
}

AppState table_of(const Folder& folder, const std::string& scene) {
    AppState state = opened_state(folder, text_of(scene));
    INFO(scene);
    REQUIRE_FALSE(has_errors(state.document.diagnostics()));
    advance(state, 0);
    return state;
}

/// Of the fixed table, but for its edge.
double distance_at(const AppState& state, const Vec2& world) {
    const Field& field = state.session.program().fixed;
    double least = infinity;
    for (std::size_t i = 0; i < field.solids.size(); ++i)
        if (!field.solids[i].is_domain) least = std::min(least, evaluate_tree(field, field.solids[i].root, world).value);
    return least;
}

/// Every copy that a grid of places finds.
std::vector<Copy> copies_in(const AppState& state, NodeId node) {
    std::vector<Copy> out;
    for (int x = 0; x < 200; ++x)
        for (int y = 0; y < 200; ++y) {
            const auto copy = copy_at(state, node, {0.005 * x, 0.005 * y}, 0);
            const auto same = [&](const Copy& other) { return other.images == copy->images; };
            if (copy && std::none_of(out.begin(), out.end(), same)) out.push_back(*copy);
        }
    return out;
}

}  // namespace

TEST_CASE("each copy of a node is found where it is seen, and the table is solid and ends there as the node does") {
    for (const Case& one : cases) {
        const Folder folder;
        const AppState state = table_of(folder, one.operation);
        INFO(one.operation);
        const NodeId node = id_of(state.document, "it");
        const std::vector<Copy> copies = copies_in(state, node);
        CHECK(copies.size() == static_cast<std::size_t>(one.copies));
        for (const Copy& copy : copies) {
            const Showing showing(state, node, copy);
            CHECK(length(showing.local_from_world(*copy.near)) <= 0.015 + 1e-9);
            for (int i = 0; i < 12; ++i) {
                const Vec2 way(std::cos(0.5 * i), std::sin(0.5 * i)), local = 0.015 * way;
                const std::optional<Vec2> world = showing.world_from_local(local);
                REQUIRE(world);
                CHECK(length(showing.local_from_world(*world) - local) < 1e-7);
                CHECK(std::fabs(distance_at(state, *world)) < 1e-6);
                CHECK(distance_at(state, *showing.world_from_local(0.5 * local)) < 0);
                CHECK(length(*showing.world_from_local(showing.local_from_world(*world + 0.002 * way)) - *world - 0.002 * way) < 1e-7);
            }
        }
    }
}

TEST_CASE("without a copy it is the node itself, wherever that is seen") {
    const Folder folder;
    for (const Case& one : cases) {
        const AppState state = table_of(folder, one.operation);
        INFO(one.operation);
        const NodeId node = id_of(state.document, "it");
        const Showing showing(state, node, {});
        const auto world = showing.world_from_local({0, 0});
        REQUIRE(world);
        CHECK(distance_at(state, *world) < 0);
        CHECK(copy_at(state, node, *world, 0));
        if (showing.is_similar() && one.copies != 6) CHECK(length(*world - shown_from_local(state, node).offset) < 1e-9);
        CHECK_FALSE(copy_at(state, node, {0.02, 0.98}, 0.001));
    }
    // Of what is in no operator, too.
    const AppState plain = opened_state(folder);
    for (const char* name : {"pop", "bat", "post", "start", "drain"}) {
        const NodeId node = id_of(plain.document, name);
        const Vec2 p(0.01, 0.02);
        const Showing showing(plain, node, {});
        CHECK(length(*showing.world_from_local(p) - shown_from_local(plain, node) * p) < 1e-12);
        CHECK(length(showing.local_from_world(shown_from_local(plain, node) * p) - p) < 1e-12);
    }
}

TEST_CASE("in every copy the handle is there, and the copy's outline goes through the hand that drags it") {
    for (const Case& one : cases) {
        Desk desk(text_of(one.operation));
        desk.state().preferences.grid = 0;
        INFO(one.operation);
        AppState& state = desk.state();
        const NodeId node = id_of(state.document, "it");
        for (const Copy& copy : copies_in(state, node)) {
            select(state, node);
            desk.move_to_world(*copy.near);
            desk.move_to_world(*Showing(state, node, copy).world_from_local({0, 0}));
            REQUIRE(desk.ui().handles.copy.images == copy.images);
            REQUIRE(desk.ui().handles.all.size() == 1);
            const Vec2 at = desk.ui().handles.all.front().at;
            const Vec2 from = *Showing(state, node, copy).world_from_local(at), to = *Showing(state, node, copy).world_from_local(1.2 * at);
            desk.move_to_world(from);
            REQUIRE(handle_under_mouse(state, desk.ui()) == 0);
            desk.button(true);
            desk.move_to_world(0.5 * (from + to));
            desk.move_to_world(to);
            desk.button(false);
            desk.frames(1);
            CHECK(state.document.scene().find(node)->get<double>("radius") == Approx(0.018).margin(2e-5));
            CHECK(std::fabs(distance_at(state, to)) < 5e-5);
            state.document.undo();
            desk.frames(30);
        }
    }
}
