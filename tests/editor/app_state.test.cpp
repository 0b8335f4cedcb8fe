#include "editor/app_state.h"

#include <catch2/catch.hpp>

#include "editor/pick.h"
#include "engine/core/rng.h"
#include "engine/physics/free_place.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

/// A state with an unsaved edit.
AppState touched_state(const Folder& folder) {
    AppState state = opened_state(folder);
    REQUIRE(edit(state, change(state.document, "pop", "kick", 1.0), "Kick harder"));
    return state;
}

}  // namespace

TEST_CASE("the status line shows names from strangers without what hides in them") {
    const Folder folder;
    AppState state = opened_state(folder);
    say(state, "Opened a\x1b[31m\nb\u202e.yaml");
    CHECK(state.message == "Opened a\\x1b[31m\\nb\\u202e.yaml");
}

TEST_CASE("a clean table is left without a question") {
    const Folder folder;
    AppState state = opened_state(folder);
    SECTION("to quit") {
        run(state, "app.quit");
        CHECK(state.quit);
    }
    SECTION("for a new one") {
        run(state, "new.blank");
        CHECK(state.document.path().empty());
    }
    SECTION("to open another") {
        run(state, "file.open");
        CHECK(state.dialog_action == "file.open");
    }
    CHECK_FALSE(state.prompt);
}

TEST_CASE("unsaved work is asked about before it would be lost") {
    const Folder folder;
    AppState state = touched_state(folder);
    const std::string mine = state.document.source().text();
    const std::string action = GENERATE("app.quit", "new.blank", "file.open");
    const auto gone_on = [&] {
        return action == "app.quit"   ? state.quit
               : action == "new.blank" ? state.document.path().empty()
                                      : state.dialog_action == "file.open";
    };
    run(state, action);
    REQUIRE(state.prompt);
    CHECK_THAT(state.prompt->question, Catch::Contains("table.yaml"));
    CHECK_FALSE(gone_on());
    CHECK_FALSE(enabled(state, "edit.undo"));
    SECTION("cancel stays") {
        run(state, "prompt.cancel");
        CHECK_FALSE(state.prompt);
        CHECK_FALSE(gone_on());
        CHECK(state.document.source().text() == mine);
    }
    SECTION("discard goes on and writes nothing") {
        run(state, "prompt.discard");
        CHECK(gone_on());
        CHECK(folder.read("table.yaml") == pen);
    }
    SECTION("save writes and goes on") {
        run(state, "prompt.save");
        CHECK(gone_on());
        CHECK(folder.read("table.yaml") == mine);
    }
    SECTION("a save that fails stays") {
        folder.write("table.yaml", std::string(pen).replace(pen.find("kick: 0.8"), 9, "kick: 0.7"));
        run(state, "prompt.save");
        CHECK_FALSE(gone_on());
        CHECK(state.message_is_problem);
        CHECK(state.document.source().text() == mine);
    }
    CHECK_FALSE(state.prompt);
}

TEST_CASE("saving a table without a file asks for its path, and then goes on with what was asked") {
    const Folder folder;
    AppState state(catalog(), untitled());
    REQUIRE(edit(state, change(state.document, "pop", "kick", 2.0), "Kick harder"));
    run(state, "app.quit");
    run(state, "prompt.save");
    REQUIRE(state.dialog_action == "file.save_as");
    SECTION("named") {
        state.dialog_path = folder.file("new.yaml");
        run(state, "dialog.accept");
        CHECK(state.quit);
        CHECK(folder.read("new.yaml") == state.document.source().text());
    }
    SECTION("cancelled") {
        run(state, "dialog.cancel");
        CHECK_FALSE(state.quit);
        CHECK(state.document.dirty());
    }
    CHECK(state.dialog_action.empty());
}

TEST_CASE("opening a file replaces the table; one that is not there leaves it") {
    const Folder folder;
    AppState state = opened_state(folder);
    folder.write("other.yaml", "pinfield: 1\nscene:\n  - circle: {id: dot, radius: 5mm, at: [0.1, 0.1]}\n");
    open_file(state, folder.file("none.yaml"));
    CHECK(state.message_is_problem);
    CHECK(state.document.path() == folder.file("table.yaml"));
    state.selection.set(id_of(state.document, "pop"));
    open_file(state, folder.file("other.yaml"));
    CHECK(state.document.scene().find("dot"));
    CHECK(state.selection.empty());
    CHECK(state.session.program().fixed.solids.size() == 2);  // the dot and the table's edge
}

TEST_CASE("a refused edit becomes the message") {
    const Folder folder;
    AppState state = opened_state(folder);
    CHECK_FALSE(edit(state, change(state.document, "pop", "radius", -1.0), "Shrink"));
    CHECK_THAT(state.message, Catch::Contains("above 0"));
    CHECK(state.message_is_problem);
}

TEST_CASE("the selection survives an outside change, and goes when its node goes") {
    const Folder folder;
    AppState state = opened_state(folder);
    state.selection.set(id_of(state.document, "pop"));
    folder.write("table.yaml", pen + "# theirs\n");
    look_at_disk(state);
    advance(state, 1);
    CHECK(state.selection.primary() == id_of(state.document, "pop"));
    std::string without = pen;
    const std::size_t begin = without.find("  - bumper");
    without.erase(begin, without.find('\n', begin) + 1 - begin);
    folder.write("table.yaml", without);
    look_at_disk(state);
    advance(state, 1);
    CHECK(state.selection.empty());
}

TEST_CASE("a table broken outside keeps playing, and the message says so") {
    const Folder folder;
    AppState state = opened_state(folder);
    folder.write("table.yaml", "pinfield: 1\nscene: [circle");
    look_at_disk(state);
    CHECK(state.disk == DiskState::broken);
    CHECK(state.message_is_problem);
    const std::int64_t before = state.session.world().tick();
    advance(state, 10);
    CHECK(state.session.world().tick() == before + 10);
    CHECK(state.session.program().fixed.solids.size() > 2);
}

TEST_CASE("a file that is gone for good is reported, is unsaved work, and can be saved again") {
    const Folder folder;
    AppState state = opened_state(folder);
    std::filesystem::remove(folder.file("table.yaml"));
    look_at_disk(state);
    CHECK_FALSE(state.document.dirty());  // it may be being replaced
    folder.write("table.yaml", pen);
    look_at_disk(state);
    std::filesystem::remove(folder.file("table.yaml"));
    look_at_disk(state);
    look_at_disk(state);
    CHECK(state.disk == DiskState::missing);
    CHECK(state.message_is_problem);
    CHECK(state.document.dirty());
    REQUIRE(state.document.save());
    CHECK(folder.read("table.yaml") == pen);
    CHECK_FALSE(state.document.dirty());
    look_at_disk(state);
    CHECK(state.disk == DiskState::same);
}

TEST_CASE("a click finds the smallest solid under it, locked nodes and the domain never") {
    const Folder folder;
    const AppState state = opened_state(folder);
    const auto picked = [&](double x, double y, double slack = 0.0) { return state.document.scene().find(pick(state, {x, y}, slack)); };
    const auto name = [&](const Node* node) { return node ? node->name : std::string(); };
    CHECK(name(picked(0.25, 0.70)) == "pop");
    CHECK(name(picked(0.30, 0.305)) == "shelf");
    CHECK(name(picked(0.25 + 0.0245, 0.70)).empty());
    CHECK(name(picked(0.25 + 0.0245, 0.70, 0.001)) == "pop");
    CHECK(name(picked(0.001, 0.5)).empty());     // the domain's outside
    CHECK(name(picked(0.06, 0.16)).empty());     // the nail is locked
    CHECK(name(picked(0.25, 0.90)) == "start");  // a spawn by its place
    CHECK(name(picked(0.29, 0.02)) == "drain");  // a drain by its region
    // The bat at rest hangs 30 degrees below the horizontal.
    CHECK(name(picked(0.30 + 0.05 * 0.866, 0.15 - 0.05 * 0.5)) == "bat");
    CHECK(name(picked(0.35, 0.15)).empty());
    // Inside the turned and doubled group: post is at (0.1, 0.1) + 2 (-0.02, 0.01).
    CHECK(name(picked(0.06, 0.12)) == "post");
}

TEST_CASE("of overlapping solids the smaller is picked") {
    const Folder folder;
    const AppState state = opened_state(folder, "pinfield: 1\nscene:\n  - box: {id: big, at: [0.2, 0.2], size: [0.2, 0.2]}\n"
                                                "  - circle: {id: small, at: [0.22, 0.2], radius: 5mm}\n");
    CHECK(pick(state, {0.221, 0.2}, 0) == id_of(state.document, "small"));
    CHECK(pick(state, {0.15, 0.2}, 0) == id_of(state.document, "big"));
}

TEST_CASE("the bounds of a node hold it, with what its group places it in") {
    const Folder folder;
    const AppState state = opened_state(folder);
    const Box2 pop = bounds_of(state, id_of(state.document, "pop"));
    CHECK(pop.lo.x() == Approx(0.226));
    CHECK(pop.hi.y() == Approx(0.724));
    const Box2 corner = bounds_of(state, id_of(state.document, "corner"));
    CHECK(corner.contains({0.06, 0.12}));
    CHECK(corner.contains({0.06, 0.16}));
}

TEST_CASE("zooming out ends where the table is a tenth of what fits, and zooming in where a millimetre is 200 pixels") {
    const Folder folder;
    AppState state = opened_state(folder);
    state.view.size = {800, 600};
    run(state, "view.all");
    const double fits = state.view.pixels_per_metre;
    for (int i = 0; i < 200; ++i) run(state, "view.zoom_out");
    CHECK(state.view.pixels_per_metre == Approx(0.1 * fits));
    for (int i = 0; i < 200; ++i) run(state, "view.zoom_in");
    CHECK(state.view.pixels_per_metre == 200'000);
    run(state, "view.all");
    CHECK(state.view.pixels_per_metre == fits);
}

TEST_CASE("framing fits the table into the viewport, and zooming keeps the point under the hand") {
    const Folder folder;
    AppState state = opened_state(folder);
    state.view.origin = {200, 50};
    state.view.size = {800, 600};
    run(state, "view.all");
    const Box2 window = state.view.window();
    CHECK(window.contains({0, 0}));
    CHECK(window.contains({0.5, 1.0}));
    const Vec2 pixel(333, 222), world = state.view.world_from_pixel(pixel);
    state.view.zoom_at(pixel, 3);
    CHECK(length(state.view.pixel_from_world(world) - pixel) < 1e-6);
    state.selection.set(id_of(state.document, "pop"));
    run(state, "view.frame");
    CHECK(state.view.window().contains({0.25, 0.70}));
    CHECK(state.view.window().size().y() < 0.2);
}

TEST_CASE(
    "a message goes when the text it was about has changed; a problem also with the next thing done or selected, anything else after some "
    "seconds") {
    const Folder folder;
    AppState state = opened_state(folder);
    REQUIRE(edit(state, change(state.document, "pop", "kick", 3.0), "Change kick"));
    run(state, "edit.undo");
    advance(state, 0);
    CHECK(state.message == "Undone: Change kick");
    SECTION("another edit, of which nobody said anything") {
        state.document.edit(change(state.document, "pop", "kick", 2.0), "Change kick");
        advance(state, 0);
        CHECK(state.message.empty());
    }
    SECTION("time") {
        age_message(state, 2);
        CHECK(state.message == "Undone: Change kick");
        age_message(state, 20);
        CHECK(state.message.empty());
    }
    SECTION("a problem stays, however long it takes to read") {
        say(state, "no material is called rubbr", true);
        const int said = state.said;
        age_message(state, 100);
        advance(state, 10);
        CHECK(state.message == "no material is called rubbr");
        CHECK(state.said == said);
        SECTION("until something else is selected") {
            select(state, id_of(state.document, "bat"));
            advance(state, 0);
        }
        SECTION("until something else is done") { run(state, "play.pause"); }
        SECTION("until it is mended") {
            state.document.edit(change(state.document, "pop", "kick", 2.0), "Change kick");
            advance(state, 0);
        }
        CHECK(state.message.empty());
        CHECK_FALSE(state.message_is_problem);
        CHECK(state.said > said);
    }
}

TEST_CASE("no edit leaves a ball in a solid: it is moved to the nearest free place, and said so") {
    const Folder folder;
    AppState state = opened_state(folder);
    const auto overlap = [&] {
        double most = 0;
        for (const Ball& ball : state.session.world().balls())
            if (ball.layer == ground_layer) most = std::max(most, overlap_of(state.session.world(), ball));
        return most;
    };
    CounterRng random(2026);
    int moved = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec2 ball = state.session.world().balls()[0].position;
        const std::string node = i % 3 == 0 ? "shelf" : "pop";
        Vec2 to(random.in(0.05, 0.45), random.in(0.1, 0.9));
        if (i % 2 == 0) to = ball + Vec2(random.in(-0.03, 0.03), random.in(-0.03, 0.03));
        state.message.clear();
        if (i % 5 == 0)
            state.document.preview(change(state.document, node, "at", to));
        else if (state.document.edit(change(state.document, node, "at", to), "Move"))
            continue;
        advance(state, 0);
        CHECK(overlap() == 0);
        moved += state.message.starts_with("Moved a ball out of ");
        const Vec2 now = state.session.world().balls()[0].position;
        CHECK(length(now - ball) < 0.2);
        CHECK((now == ball) == state.message.empty());
        advance(state, 25);
        if (i % 7 == 0 && state.document.can_undo()) {
            state.document.undo();
            advance(state, 0);
            CHECK(overlap() == 0);
        }
    }
    CHECK(moved > 50);
}

TEST_CASE("a ball for which no place is free starts again") {
    const Folder folder;
    AppState state = opened_state(folder);
    // All of the table below the ball's start.
    for (int i = 0; i < 300 && state.session.world().balls()[0].position.y() > 0.55; ++i) advance(state, 10);
    REQUIRE(state.session.world().balls()[0].position.y() <= 0.55);
    REQUIRE(edit(state, change(state.document, "shelf", "size", Vec2(0.6, 1.14)), "Fill"));
    advance(state, 0);
    CHECK(state.session.world().balls()[0].position == Vec2(0.25, 0.90));
    CHECK(state.message.starts_with("Moved a ball out of shelf"));
}

TEST_CASE("a ball that is moved out is no faster, and not on its way back in") {
    const Folder folder;
    AppState state = opened_state(folder);
    advance(state, 300);
    const Ball before = state.session.world().balls()[0];
    REQUIRE(length(before.velocity) > 0.1);
    REQUIRE(edit(state, change(state.document, "pop", "at", Vec2(before.position + Vec2(0.004, -0.01))), "Over the ball"));
    advance(state, 0);
    const Ball after = state.session.world().balls()[0];
    CHECK(length(after.velocity) <= length(before.velocity));
    CHECK(dot(after.velocity, after.position - before.position) >= -1e-12);
}
