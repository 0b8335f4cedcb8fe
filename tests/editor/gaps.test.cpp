#include "editor/gaps.h"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <cmath>

#include "engine/core/rng.h"
#include "engine/core/trig.h"
#include "engine/program/evaluate.h"
#include "tests/editor/screen.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

constexpr double ball = 0.027;

AppState table_with(const Folder& folder, const std::string& nodes) {
    return opened_state(folder,
                        "pinfield: 1\ntable: {size: [1, 1]}\nscene:\n  - domain: {id: hall, children: [box: {id: room, size: [0.9, 0.9], "
                        "at: [0.5, 0.5]}]}\n" +
                            nodes);
}

std::string disc(const char* id, double x, double y, double radius) {
    return fmt::format("  - circle: {{id: {}, at: [{}, {}], radius: {}}}\n", id, x, y, radius);
}

}  // namespace

TEST_CASE("between two discs the gap is the distance of their middles without their radii, on the line of these") {
    CounterRng rng(1);
    int narrow = 0, touching = 0, wide = 0;
    for (int i = 0; i < 60; ++i) {
        const Folder folder;
        const double r = 0.02 + 0.06 * rng.uniform(), s = 0.02 + 0.06 * rng.uniform(), gap = -0.01 + 0.05 * rng.uniform(),
                     angle = two_pi * rng.uniform();
        const Vec2 a(0.5, 0.5), b = a + (r + s + gap) * Vec2(cosine(angle), sine(angle));
        const AppState state = table_with(folder, disc("a", a.x(), a.y(), r) + disc("b", b.x(), b.y(), s));
        const auto found = narrowest_gap(state, {id_of(state.document, "a")}, ball);
        INFO(r << ", " << s << ", " << gap);
        REQUIRE(found.has_value() == (gap > 1e-5 && gap < ball));
        if (!found) {
            ++(gap < 0 ? touching : wide);
            continue;
        }
        ++narrow;
        CHECK(found->width == Approx(gap).margin(1e-7));
        CHECK(length(found->a - a) == Approx(r).margin(1e-6));
        CHECK(length(found->b - b) == Approx(s).margin(1e-6));
        CHECK(found->other == id_of(state.document, "b"));
    }
    CHECK(narrow > 10);
    CHECK(touching > 3);
    CHECK(wide > 3);
}

TEST_CASE("the gap to the table's wall counts, and the narrowest of several is told") {
    const Folder folder;
    const AppState state = table_with(folder, disc("a", 0.1, 0.5, 0.03) + disc("b", 0.154, 0.5, 0.01));
    const auto found = narrowest_gap(state, {id_of(state.document, "a")}, ball);
    REQUIRE(found);
    CHECK(found->width == Approx(0.014).margin(1e-7));  // to b; to the wall it is 20 mm
    const auto alone = narrowest_gap(state, {id_of(state.document, "a"), id_of(state.document, "b")}, ball);
    REQUIRE(alone);  // b goes along
    CHECK(alone->width == Approx(0.02).margin(1e-7));
    CHECK(alone->other == id_of(state.document, "hall"));
}

TEST_CASE("random solids: no gap is told that brute force does not find, and none that it finds is missed") {
    CounterRng rng(2);
    int found_some = 0;
    for (int i = 0; i < 40; ++i) {
        const Folder folder;
        const auto uniform = [&](double lo, double hi) { return lo + (hi - lo) * rng.uniform(); };
        const std::string mine = i % 2 ? fmt::format("  - box: {{id: mine, at: [0.5, 0.5], size: [{}, {}], turn: {}}}\n",
                                                     uniform(0.04, 0.1), uniform(0.04, 0.1), uniform(0, 90))
                                       : fmt::format("  - ellipse: {{id: mine, at: [0.5, 0.5], radii: [{}, {}], turn: {}}}\n",
                                                     uniform(0.03, 0.06), uniform(0.02, 0.05), uniform(0, 90));
        const double angle = uniform(0, two_pi), away = uniform(0.06, 0.13);
        const std::string other =
            fmt::format("  - box: {{id: other, at: [{}, {}], size: [{}, {}], turn: {}}}\n", 0.5 + away * cosine(angle),
                        0.5 + away * sine(angle), uniform(0.03, 0.08), uniform(0.03, 0.08), uniform(0, 90));
        const AppState state = table_with(folder, mine + other);
        // Brute force: what is between two convex solids is least where the sum of the distances is.
        const Field& field = state.session.program().fixed;
        const auto distance_to = [&](const char* id, const Vec2& p) {
            for (std::size_t k = 0; k < field.solids.size(); ++k)
                if (field.solids[k].origin == id_of(state.document, id)) return nearest_of_solid(field, static_cast<int>(k), p).distance;
            return infinity;
        };
        double least = infinity, deepest = infinity;
        for (double x = 0.3; x <= 0.7; x += 0.002)
            for (double y = 0.3; y <= 0.7; y += 0.002) {
                const double a = distance_to("mine", {x, y}), b = distance_to("other", {x, y});
                deepest = std::min(deepest, std::max(a, b));
                if (a > 0 && b > 0) least = std::min(least, a + b);
            }
        const auto found = narrowest_gap(state, {id_of(state.document, "mine")}, ball);
        INFO(mine << other << least << ", " << deepest);
        if (deepest < -1e-3)
            CHECK_FALSE(found);
        else if (least < ball - 0.004 && deepest > 1e-3)
            REQUIRE(found);
        else if (least > ball + 0.004)
            CHECK_FALSE(found);
        if (!found) continue;
        ++found_some;
        CHECK(found->width <= least + 1e-7);
        CHECK(found->width >= least - 0.003);  // the brute force's own error: a cell's diagonal
    }
    CHECK(found_some > 5);
}

TEST_CASE("a corner that leads to a touch is no gap, and a third solid closes one") {
    const Folder folder;
    const AppState wedge = table_with(folder, "  - box: {id: mine, at: [0.08, 0.5], size: [100mm, 20mm], turn: 30}\n");
    CHECK_FALSE(narrowest_gap(wedge, {id_of(wedge.document, "mine")}, ball));  // it stands in the wall
    const AppState closed = table_with(
        folder, disc("a", 0.4, 0.5, 0.03) + disc("b", 0.48, 0.5, 0.03) + "  - box: {id: plug, at: [0.44, 0.5], size: [30mm, 60mm]}\n");
    CHECK_FALSE(narrowest_gap(closed, {id_of(closed.document, "a")}, ball));
}

TEST_CASE("where a way is free, and how far, is what closed forms say") {
    const Folder folder;
    const AppState state = table_with(folder, disc("a", 0.3, 0.5, 0.05) + disc("b", 0.6, 0.5, 0.1));
    const std::vector<FreeStretch> across = free_stretches(state.session.world(), {0, 0.5}, {1, 0.5});
    REQUIRE(across.size() == 3);
    CHECK(across[0].begin == Approx(0.05).margin(1e-7));
    CHECK(across[0].end == Approx(0.25).margin(1e-7));
    CHECK(across[1].begin == Approx(0.35).margin(1e-7));
    CHECK(across[1].length() == Approx(0.15).margin(1e-7));
    CHECK(across[2].length() == Approx(0.25).margin(1e-7));
    for (const FreeStretch& stretch : across) CHECK(stretch.closed);
    // From edge to edge it is closed, too; from the open it is not.
    const std::vector<FreeStretch> between = free_stretches(state.session.world(), {0.35, 0.5}, {0.5, 0.5});
    REQUIRE(between.size() == 1);
    CHECK(between[0].closed);
    const std::vector<FreeStretch> open = free_stretches(state.session.world(), {0.4, 0.5}, {0.7, 0.5});
    REQUIRE(open.size() == 1);
    CHECK_FALSE(open[0].closed);
    CHECK(open[0].length() == Approx(0.1).margin(1e-7));
    CHECK(free_stretches(state.session.world(), {0.3, 0.5}, {0.3, 0.5}).empty());
}

TEST_CASE("what is measured from is the middle near by, else the edge, else the grid") {
    const Folder folder;
    const AppState state = table_with(folder, disc("a", 0.3004, 0.5, 0.05));
    CHECK(length(measured_place(state, {0.302, 0.499}, 0.005, 0.001) - Vec2(0.3004, 0.5)) < 1e-12);
    const Vec2 edge = measured_place(state, {0.3004 + 0.052, 0.5}, 0.005, 0.001);
    CHECK(length(edge - Vec2(0.3504, 0.5)) < 1e-7);
    CHECK(length(measured_place(state, {0.4212, 0.5009}, 0.005, 0.001) - Vec2(0.421, 0.501)) < 1e-12);
    CHECK(length(measured_place(state, {0.302, 0.499}, 0, 0) - Vec2(0.302, 0.499)) < 1e-12);
}

TEST_CASE("the measure tool measures from edge to edge under the mouse, says what is narrow, and selects nothing") {
    class Desk : public Screen {
    public:
        explicit Desk(AppState& state) : Screen({800, 800}), state_(state) {
            for (int i = 0; i < 3; ++i) frame();
        }
        void frame() {
            frame_of([&] {
                viewport_panel(state_, ui_, {0, 0}, {800, 800});
                advance(state_, 0);
            });
        }
        void hand(const Vec2& world, bool down) {
            ui_.mouse = state_.view.pixel_from_world(world);
            ImGui::GetIO().MousePos = {static_cast<float>(ui_.mouse.x()), static_cast<float>(ui_.mouse.y())};
            frame();
            ImGui::GetIO().MouseDown[0] = down;
            frame();
        }
        bool shows(std::string_view words) const {
            return std::any_of(seen().begin(), seen().end(), [&](const ScreenText& t) { return t.text.find(words) != std::string::npos; });
        }

    private:
        AppState& state_;
    };
    const Folder folder;
    AppState state = table_with(folder, disc("a", 0.3, 0.5, 0.05) + disc("b", 0.42, 0.5, 0.05));
    state.session.play(false);
    run(state, "tool.measure");
    Desk desk(state);
    desk.hand({0.351, 0.5}, true);
    desk.hand({0.3695, 0.5}, true);
    CHECK(desk.shows("20.00 mm"));
    CHECK(desk.shows("20.00 mm: narrower than a ball"));
    desk.hand({0.3695, 0.5}, false);
    CHECK(desk.shows("20.00 mm: narrower than a ball"));
    CHECK(state.selection.empty());
    CHECK_FALSE(state.document.can_undo());
    CHECK(cancel_drag(state, desk.ui()));
    desk.frame();
    CHECK_FALSE(desk.shows("20.00 mm"));
    // And a drag of a node says so beside it.
    run(state, "tool.select");
    desk.hand({0.3, 0.5}, true);
    desk.hand({0.305, 0.5}, true);
    desk.frame();
    CHECK(desk.shows("15.00 mm: narrower than a ball"));
    run(state, "view.gaps");
    desk.frame();
    CHECK_FALSE(desk.shows("narrower than a ball"));
    cancel_drag(state, desk.ui());
    desk.hand({0.3, 0.5}, false);
}
