// Turning, scaling, aligning.
#include "editor/arrange.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "editor/pick.h"
#include "editor/transform.h"
#include "engine/core/rng.h"
#include "engine/program/evaluate.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

const std::string some = R"(pinfield: 1
table: {size: [1, 1]}
scene:
  - box: {id: a, at: [0.3, 0.7], size: [80mm, 40mm], turn: 20}
  - egg: {id: b, at: [0.5, 0.7], flip: x, turn: 30, scale: 1.2}
  - group:
      id: g
      at: [0.6, 0.3]
      flip: y
      children:
        - star: {id: c, at: [0.05, 0.02], turn: 10, flip: y}
        - heart: {id: d, at: [-0.05, 0.02]}
)";

AppState state_of(const Folder& folder, const std::string& text = some) {
    AppState state = opened_state(folder, text);
    REQUIRE_FALSE(has_errors(state.document.diagnostics()));
    advance(state, 0);
    return state;
}

std::vector<NodeId> ids(const AppState& state, std::initializer_list<std::string_view> names) {
    std::vector<NodeId> out;
    for (const std::string_view name : names) out.push_back(id_of(state.document, name));
    return out;
}

/// Signed distances of everything on the table at the points.
std::vector<double> field_at(const AppState& state, const std::vector<Vec2>& points) {
    std::vector<double> out;
    for (const Vec2& p : points) {
        double least = infinity;
        const Field& field = state.session.program().fixed;
        for (std::size_t i = 0; i < field.solids.size(); ++i)
            if (!field.solids[i].is_domain) least = std::min(least, nearest_of_solid(field, static_cast<int>(i), p).distance);
        out.push_back(least);
    }
    return out;
}

std::vector<Vec2> random_points(int count) {
    CounterRng rng(7);
    std::vector<Vec2> out;
    for (int i = 0; i < count; ++i) {
        const double x = rng.uniform(), y = rng.uniform();
        out.emplace_back(x, y);
    }
    return out;
}

}  // namespace

TEST_CASE("what is turned and scaled as a whole keeps its distances about the pivot") {
    const std::vector<Vec2> points = random_points(200);
    for (const TransformKind kind : {TransformKind::turn, TransformKind::scale}) {
        const Folder folder;
        AppState state = state_of(folder);
        const std::vector<double> before = field_at(state, points);
        const std::vector<NodeId> all = ids(state, {"a", "b", "c", "d"});
        const Vec2 pivot = pivot_of(state.document.scene(), all), hand = pivot + Vec2(0.1, 0);
        const double angle = 37 * 3.14159265358979323846 / 180;
        TransformDrag drag;
        REQUIRE(drag.begin(state.document, all, kind, pivot, hand));
        const bool turns = kind == TransformKind::turn;
        CHECK_FALSE(drag.update(state.document,
                                turns ? Vec2(pivot + 0.2 * Vec2(std::cos(angle), std::sin(angle))) : Vec2(pivot + Vec2(0, 0.07)), 0));
        CHECK(drag.amount() == Approx(turns ? 37 : 0.7));
        CHECK_FALSE(drag.end(state.document));
        CHECK(state.document.undo_steps() == 1);
        advance(state, 0);
        std::vector<Vec2> images;
        for (const Vec2& p : points) {
            const Vec2 arm = p - pivot;
            const Vec2 turned(std::cos(angle) * arm.x() - std::sin(angle) * arm.y(), std::sin(angle) * arm.x() + std::cos(angle) * arm.y());
            images.emplace_back(pivot + (turns ? turned : Vec2(0.7 * arm)));
        }
        const std::vector<double> after = field_at(state, images);
        for (std::size_t i = 0; i < points.size(); ++i) CHECK(after[i] == Approx((turns ? 1 : 0.7) * before[i]).margin(2e-5));
        state.document.undo();
        CHECK(state.document.source().text() == some);
    }
}

TEST_CASE("a single node turns on its place, in whole degrees, once round and further") {
    const Folder folder;
    AppState state = state_of(folder);
    const std::vector<NodeId> a = ids(state, {"a"});
    TransformDrag drag;
    const Vec2 pivot(0.3, 0.7);
    REQUIRE(drag.begin(state.document, a, TransformKind::turn, pivot, pivot + Vec2(0.1, 0)));
    for (int degrees = 0; degrees <= 450; degrees += 30) {
        const double angle = (degrees + 0.3) * 3.14159265358979323846 / 180;
        CHECK_FALSE(drag.update(state.document, pivot + 0.1 * Vec2(std::cos(angle), std::sin(angle)), 1));
    }
    CHECK(drag.amount() == 450);
    drag.end(state.document);
    CHECK(state.document.source().text().find("{id: a, at: [0.3, 0.7], size: [80mm, 40mm], turn: 470}") != std::string::npos);
}

TEST_CASE("mirrored nodes are the mirror image, and twice is as before") {
    const std::vector<Vec2> points = random_points(200);
    for (const int axis : {0, 1}) {
        const Folder folder;
        AppState state = state_of(folder);
        const std::vector<double> before = field_at(state, points);
        select(state, ids(state, {"a", "b", "g"}));
        Box2 box;
        for (const NodeId node : state.selection.nodes()) box = box.merged(bounds_of(state, node));
        flip_selection(state, axis);
        CHECK_FALSE(state.message_is_problem);
        advance(state, 0);
        std::vector<Vec2> images = points;
        for (Vec2& p : images) p[axis] = 2 * box.centre()[axis] - p[axis];
        const std::vector<double> after = field_at(state, images);
        for (std::size_t i = 0; i < points.size(); ++i) CHECK(after[i] == Approx(before[i]).margin(3e-5));
        CHECK(state.document.undo_steps() == 1);
        flip_selection(state, axis);
        advance(state, 0);
        const std::vector<double> again = field_at(state, points);
        for (std::size_t i = 0; i < points.size(); ++i) CHECK(again[i] == Approx(before[i]).margin(3e-5));
    }
}

TEST_CASE("aligned boxes share a line; evenly spaced ones have equal gaps") {
    const Folder folder;
    AppState state = state_of(folder);
    const std::vector<NodeId> nodes = ids(state, {"a", "b", "g"});
    const auto lines = [&](Align how, const Box2& box) {
        return how == Align::left     ? box.lo.x()
               : how == Align::right  ? box.hi.x()
               : how == Align::middle ? box.centre().x()
               : how == Align::top    ? box.hi.y()
               : how == Align::bottom ? box.lo.y()
                                      : box.centre().y();
    };
    for (const Align how : {Align::left, Align::middle, Align::right, Align::top, Align::centre, Align::bottom}) {
        select(state, nodes);
        align(state, how);
        advance(state, 0);
        for (const NodeId node : nodes)
            CHECK(lines(how, bounds_of(state, node)) == Approx(lines(how, bounds_of(state, nodes[0]))).margin(2e-5));
        state.document.undo();
        advance(state, 0);
        CHECK(state.document.source().text() == some);
    }
    select(state, nodes);
    distribute(state, 0);
    advance(state, 0);
    const Box2 a = bounds_of(state, nodes[0]), b = bounds_of(state, nodes[1]), g = bounds_of(state, nodes[2]);
    CHECK(b.lo.x() - a.hi.x() == Approx(g.lo.x() - b.hi.x()).margin(3e-5));
    select(state, ids(state, {"a", "b"}));
    distribute(state, 1);
    CHECK(state.message_is_problem);
}
