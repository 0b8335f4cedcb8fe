// When the editor draws, and what it says of the time it missed.
#include "editor/pace.h"

#include <catch2/catch.hpp>

#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

/// Frames that would be drawn in so many turns of the loop.
int frames(FramePace& pace, const Stir& stir, int turns) {
    int count = 0;
    for (int i = 0; i < turns; ++i)
        if (pace.due(stir)) {
            ++count;
            pace.drawn();
        }
    return count;
}

}  // namespace

TEST_CASE("an editor that nothing happens to draws a few frames and then none, and a few more after every event") {
    FramePace pace;
    const int first = frames(pace, {}, 100);
    CHECK(first >= 2);
    CHECK(first <= 10);
    CHECK(frames(pace, {}, 100) == 0);
    CHECK(frames(pace, {.events = true}, 1) == 1);
    const int settling = frames(pace, {}, 100);
    CHECK(settling >= 2);
    CHECK(settling <= 10);
}

TEST_CASE("a table that moves is drawn all the time, but not where nobody sees it; what happens to a hidden window is still handled") {
    FramePace pace;
    CHECK(frames(pace, {.table = true}, 100) == 100);
    CHECK(frames(pace, {.table = true, .hidden = true}, 100) == 0);
    CHECK(frames(pace, {.events = true, .table = true, .hidden = true}, 3) == 3);
    CHECK(frames(pace, {.table = true, .hidden = true}, 100) == 0);
    CHECK(frames(pace, {}, 100) > 0);
}

TEST_CASE("what is shown differs once a ball has moved by more than the eye sees, however slowly") {
    const Folder folder;
    AppState state = opened_state(folder);
    const World& world = state.session.world();
    ShownTable shown;
    CHECK(shown.differs(world, 1));
    shown.take(world);
    CHECK_FALSE(shown.differs(world, 0));
    // 10 mm/s, 0.01 mm a tick.
    advance(state, 1);
    CHECK(shown.differs(world, 1e-6));
    CHECK_FALSE(shown.differs(world, 1e-3));
    while (state.session.world().balls()[0].position.y() > 0.899) advance(state, 1);
    CHECK(shown.differs(world, 1e-4));
    shown.take(world);
    CHECK_FALSE(shown.differs(world, 0));
}

TEST_CASE("another program looks different, and so does a flipper that moves") {
    const Folder folder;
    AppState state = opened_state(folder);
    ShownTable shown;
    shown.take(state.session.world());
    REQUIRE(edit(state, change(state.document, "pop", "radius", 0.03), "Larger"));
    advance(state, 0);
    CHECK(shown.differs(state.session.world(), 1));
    shown.take(state.session.world());
    state.session.press("left", true);
    advance(state, 20);
    CHECK(shown.differs(state.session.world(), 0.02));
}

TEST_CASE("a stall is forgiven, missed real time is said after two seconds and forgotten after one without") {
    RealTime time;
    CHECK(time.share() == 1);
    const auto second = [&](double share) {
        for (int i = 0; i < 10; ++i) time.add(0.1, 0.1 * share);
        time.add(1e-9, 1e-9);  // whatever ten tenths are
    };
    second(1);
    second(0.5);
    CHECK(time.share() > 0.9);
    second(0.25);
    CHECK(time.share() == Approx(0.5).margin(0.06));
    second(0.25);
    CHECK(time.share() == Approx(0.25).margin(0.06));
    second(1);
    second(1);
    CHECK(time.share() > 0.9);
}
