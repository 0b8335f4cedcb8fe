// What keys do, by themselves and held, and that nothing goes on behind a question.
#include "editor/keyboard.h"

#include <catch2/catch.hpp>

#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

/// A keyboard whose keys repeat as a real one's do.
struct Hands {
    AppState& state;
    Keyboard keyboard{};
    bool typing = false;
    bool dragging = false;

    void down(std::string_view key) { take({key, true}); }
    void repeat(std::string_view key, int times) {
        for (int i = 0; i < times; ++i) take({key, true, true});
    }
    void up(std::string_view key) { take({key, false}); }
    void take(const KeyPress& press) {
        keyboard.take(state, press, typing, [this] { return std::exchange(dragging, false); });
    }
};

double x_of(const AppState& state, std::string_view node) { return state.document.scene().find(node)->get<Vec2>("at").x(); }

}  // namespace

TEST_CASE("an arrow that is held moves on by the grid, as one step of undo") {
    const Folder folder;
    AppState state = opened_state(folder);
    Hands hands{state};
    select(state, id_of(state.document, "pop"));
    hands.down("Right");
    const double once = x_of(state, "pop");
    CHECK(once > 0.25);
    hands.repeat("Right", 4);
    CHECK(x_of(state, "pop") == Approx(0.25 + 5 * (once - 0.25)));
    hands.up("Right");
    CHECK(state.document.undo_steps() == 1);
}

TEST_CASE("undo that is held goes back step by step, and stops at the first") {
    const Folder folder;
    AppState state = opened_state(folder);
    Hands hands{state};
    for (int i = 1; i <= 4; ++i) REQUIRE(edit(state, change(state.document, "pop", "kick", 1.0 + i), "Kick"));
    hands.down("LeftControl");
    hands.down("KeyZ");
    hands.repeat("KeyZ", 2);
    CHECK(state.document.undo_steps() == 1);
    hands.repeat("KeyZ", 5);
    CHECK(state.document.undo_steps() == 0);
    CHECK_FALSE(state.message_is_problem);
    CHECK(state.document.source().text() == pen);
}

TEST_CASE("no toggle repeats, and nothing that opens a question") {
    const Folder folder;
    AppState state = opened_state(folder);
    Hands hands{state};
    hands.down("F5");
    CHECK_FALSE(state.session.playing());
    hands.repeat("F5", 3);
    CHECK_FALSE(state.session.playing());
    for (const Action& action : all_actions())
        if (action.repeats) {
            INFO(action.name);
            const bool known = action.name.starts_with("edit.nudge") || action.name.starts_with("edit.move_") || action.name.starts_with("view.zoom") ||
                               action.name == "edit.undo" || action.name == "edit.redo" || action.name == "play.step" ||
                               action.name == "select.previous" || action.name == "select.next";
            CHECK(known);
        }
}

TEST_CASE("a key of the table does not repeat, not even into an action of the same key") {
    const Folder folder;
    std::string table = pen;
    table.replace(table.find("[Z, LeftShift]"), 14, "[Right]");
    AppState state = opened_state(folder, table);
    Hands hands{state};
    select(state, id_of(state.document, "pop"));
    hands.down("Right");
    const std::size_t presses = state.session.game().input_log().size();
    REQUIRE(presses == 1);
    state.session.release_all();  // the window lost the keyboard meanwhile
    hands.repeat("Right", 5);
    CHECK(x_of(state, "pop") == 0.25);
    CHECK(state.session.game().input_log().size() == presses + 1);
}

TEST_CASE("a key that took a drag back undoes nothing more while it is held") {
    const Folder folder;
    AppState state = opened_state(folder);
    Hands hands{state};
    REQUIRE(edit(state, change(state.document, "pop", "kick", 3.0), "Kick"));
    hands.dragging = true;
    hands.down("LeftControl");
    hands.down("KeyZ");
    hands.repeat("KeyZ", 5);
    CHECK_FALSE(hands.dragging);
    CHECK(state.document.undo_steps() == 1);
}

TEST_CASE("only the key that ran an action repeats it") {
    const Folder folder;
    AppState state = opened_state(folder);
    Hands hands{state};
    select(state, id_of(state.document, "pop"));
    hands.down("F5");
    hands.repeat("Right", 3);
    CHECK(x_of(state, "pop") == 0.25);
    hands.down("Right");
    hands.down("LeftShift");
    hands.repeat("Right", 3);  // another chord by now
    CHECK(x_of(state, "pop") < 0.252);
}

TEST_CASE("the table holds, and keys are nobody else's, while something asks; afterwards both go on") {
    const Folder folder;
    AppState state = opened_state(folder);
    Hands hands{state};
    const auto tick = [&] { return state.session.world().tick(); };
    REQUIRE(edit(state, change(state.document, "pop", "kick", 3.0), "Kick"));
    advance(state, 5);
    REQUIRE(tick() == 5);
    struct Question {
        const char* name;
        std::function<void()> ask, answer;
    };
    const Question questions[] = {
        {"unsaved changes", [&] { run(state, "app.quit"); }, [&] { run(state, "prompt.cancel"); }},
        {"a path", [&] { run(state, "file.save_as"); }, [&] { run(state, "dialog.cancel"); }},
        {"which table", [&] { run(state, "file.new"); }, [&] { run(state, "new.cancel"); }},
        {"found work", [&] { state.recovery = recovery_of({}, state.document); }, [&] { run(state, "recover.later"); }},
        {"the keys", [&] { run(state, "help.keys"); }, [&] { run(state, "help.keys"); }},
    };
    for (const Question& question : questions) {
        INFO(question.name);
        CHECK_FALSE(asks(state));
        const std::int64_t before = tick();
        question.ask();
        CHECK(asks(state));
        CHECK_FALSE(plays(state));
        CHECK(state.session.playing());
        advance(state, 100);
        hands.down("KeyZ");
        hands.down("F6");
        CHECK(tick() == before);
        CHECK(state.session.playing());
        question.answer();
        CHECK(plays(state));
        advance(state, 7);
        CHECK(tick() == before + 7);
    }
    CHECK(state.session.game().input_log().empty());
}
