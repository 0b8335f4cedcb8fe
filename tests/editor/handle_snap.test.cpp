// Handles come in line with what is near by: a place with edges and middles, an outline with those that it faces.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "engine/core/at.h"
#include "tests/editor/desk.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

const std::string scene = R"(pinfield: 1
table: {size: [1, 1]}
scene:
  - box: {id: block, at: [0.6013, 0.4007], size: [0.1, 0.06]}   # from 0.5513 to 0.6513, and from 0.3707 to 0.4307
  - circle: {id: disc, at: [0.3, 0.7], radius: 40mm}
  - polygon: {id: tri, points: [[0.1, 0.1], [0.2, 0.12], [0.15, 0.25]]}
  - polygon: {id: leaning, at: [0.8, 0.8], turn: 30, points: [[0, 0], [0.1, 0], [0.05, 0.1]]}
  - mirror: {id: sides, at: [0.45, 0], children: [polygon: {id: sling, points: [[0.3, 0.52], [0.4, 0.52], [0.4, 0.6]]}]}
)";

/// The table, and a mouse that drags from one place of the world to another and holds there.
class SnapDesk : public Desk {
public:
    SnapDesk() : Desk(scene) {}
    const Node& node(const char* name) const { return *state_.document.scene().find(name); }
    Vec2 point(const char* name, std::size_t i) const { return node(name).get<std::vector<Vec2>>("points")[i]; }
    void hold(const char* name, const Vec2& from, const Vec2& to) {
        select(state_, node(name).id);
        move_to_world(from);
        REQUIRE(handle_under_mouse(state_, ui_) >= 0);
        button(true);
        move_to_world(0.5 * (from + to));
        move_to_world(to);
    }
    void let_go() {
        button(false);
        frames(40);
    }
    const std::vector<SnapLine>& lines() const { return ui_.magnets.lines; }
};

bool on_grid_of_1mm(double x) { return std::fabs(1000 * x - std::round(1000 * x)) < 1e-6; }

}  // namespace

TEST_CASE("a dragged point comes in line with edges and middles, its other coordinate keeps to the grid, and lines say why") {
    for (const double line : {0.5513, 0.6013, 0.6513}) {
        SnapDesk desk;
        desk.hold("tri", {0.2, 0.12}, {line + 0.003, 0.2006});
        REQUIRE(desk.lines().size() == 1);
        CHECK(desk.lines()[0].a.x() == Approx(line).margin(1e-12));
        CHECK(desk.lines()[0].a.x() == desk.lines()[0].b.x());
        CHECK(desk.lines()[0].a.y() == Approx(0.2006).margin(1e-3));  // from the point to the box
        CHECK(desk.lines()[0].b.y() == Approx(0.4307).margin(1e-9));
        desk.let_go();
        CHECK(desk.point("tri", 1).x() == Approx(line).margin(1e-9));
        CHECK(desk.point("tri", 1).y() == Approx(0.201).margin(1e-12));
        CHECK(desk.lines().empty());
        CHECK(desk.state().document.undo_steps() == 1);
    }
}

TEST_CASE("Ctrl leaves it out, and so does the switch") {
    for (const bool by_key : {true, false}) {
        SnapDesk desk;
        if (!by_key) run(desk.state(), "tool.snap");
        ImGui::GetIO().KeyCtrl = by_key;
        desk.hold("tri", {0.2, 0.12}, {0.5543, 0.2});
        CHECK(desk.lines().empty());
        desk.let_go();
        ImGui::GetIO().KeyCtrl = false;
        CHECK(desk.point("tri", 1).x() == Approx(by_key ? 0.5543 : 0.554).margin(2e-5));
    }
}

TEST_CASE("a point comes in line with guides, and with the other points of its own list") {
    SnapDesk desk;
    desk.state().aids.guides.push_back({1, 0.3333});
    desk.hold("tri", {0.2, 0.12}, {0.103, 0.331});
    CHECK(desk.lines().size() == 2);
    desk.let_go();
    CHECK(length(desk.point("tri", 1) - Vec2(0.1, 0.3333)) < 1e-9);
}

TEST_CASE("an outline stops where it faces an edge, to the last digit, and pays no heed to lines along its way") {
    SnapDesk desk;
    desk.hold("disc", {0.34, 0.7}, {0.5493, 0.7});
    REQUIRE(desk.lines().size() == 1);
    CHECK(desk.lines()[0].a.x() == desk.lines()[0].b.x());
    desk.let_go();
    CHECK(desk.node("disc").get<double>("radius") == Approx(0.2513).margin(1e-9));
    desk.state().document.undo();
    desk.hold("disc", {0.34, 0.7}, {0.42, 0.7});
    CHECK(desk.lines().empty());
    desk.let_go();
    CHECK(on_grid_of_1mm(desk.node("disc").get<double>("radius")));
}

TEST_CASE("in a node that leans, and at a copy under a mirror, what is seen comes in line") {
    SnapDesk desk;
    const double turned = 0.1 * std::cos(0.5235987755982988), up = 0.1 * std::sin(0.5235987755982988);
    desk.hold("leaning", {0.8 + turned, 0.8 + up}, {0.654, 0.9});
    REQUIRE_FALSE(desk.lines().empty());
    desk.let_go();
    const Vec2 local = desk.point("leaning", 1);
    CHECK(0.8 + std::cos(0.5235987755982988) * local.x() - std::sin(0.5235987755982988) * local.y() == Approx(0.6513).margin(2e-9));

    select(desk.state(), desk.node("sling").id);
    desk.move_to_world({0.08, 0.54});
    desk.hold("sling", {0.05, 0.6}, {0.148, 0.65});  // the copy's; in line with the first triangle's last point
    REQUIRE_FALSE(desk.lines().empty());
    desk.let_go();
    CHECK(0.45 - desk.point("sling", 2).x() == Approx(0.15).margin(1e-9));
    CHECK(desk.point("sling", 2).y() == Approx(0.65).margin(1e-9));
}
