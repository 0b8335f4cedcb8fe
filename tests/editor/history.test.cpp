// The steps that were made, as a list to go along.
#include <catch2/catch.hpp>
#include <cmath>

#include "engine/core/at.h"
#include "tests/editor/screen.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

class HistoryScreen : public Screen {
public:
    explicit HistoryScreen(AppState& state) : Screen({320, 260}), state_(state) { frame(); }

    void frame() {
        frame_of([&] { history_panel(state_, ui_, {0, 0}, {320, 260}); });
    }
    const ScreenText* row(std::string_view words) const {
        const auto found = std::find_if(seen_.begin(), seen_.end(), [&](const ScreenText& t) { return t.text == words; });
        return found == seen_.end() ? nullptr : &*found;
    }
    void click(std::string_view words) {
        const ScreenText* found = row(words);
        INFO(words);
        REQUIRE(found);
        ImGui::GetIO().MousePos = {found->at.x + 3, found->at.y + 3};
        for (const bool down : {false, true, false}) {
            ImGui::GetIO().MouseDown[0] = down;
            frame();
        }
        frame();
    }

private:
    AppState& state_;
};

/// Kicks of 1, 2 ... steps / 10, each a step.
std::vector<std::string> texts_of_kicks(AppState& state, int steps) {
    std::vector<std::string> texts{state.document.source().text()};
    for (int i = 1; i <= steps; ++i) {
        REQUIRE(edit(state, change(state.document, "pop", "kick", 1 + i / 100.0), "Kick " + std::to_string(i)));
        texts.push_back(state.document.source().text());
    }
    return texts;
}

}  // namespace

TEST_CASE("a click in the history goes to that step, back or forth, and the text is what it was") {
    const Folder folder;
    AppState state = opened_state(folder);
    const std::vector<std::string> texts = texts_of_kicks(state, 4);
    HistoryScreen screen(state);
    for (const auto& [words, step] : {std::pair("Kick 2", 2), {"Kick 4", 4}, {"Opened", 0}, {"Kick 3", 3}}) {
        screen.click(words);
        CHECK(state.document.source().text() == at(texts, step));
        CHECK(state.document.undo_steps() == static_cast<std::size_t>(step));
        CHECK(state.document.steps() == 4);
    }
    CHECK(state.message == "At: Kick 3");
}

TEST_CASE("the history says where the file was saved, and how many steps ago") {
    const Folder folder;
    AppState state = opened_state(folder);
    texts_of_kicks(state, 2);
    run(state, "file.save");
    CHECK(state.document.saved_after() == 2u);
    REQUIRE(edit(state, change(state.document, "pop", "kick", 2.0), "Harder"));
    HistoryScreen screen(state);
    CHECK(screen.row("1 since it was saved"));
    REQUIRE(screen.row("saved"));
    CHECK(std::abs(screen.row("saved")->at.y - screen.row("Kick 2")->at.y) < 2);
    // Back before it and elsewhere: no step leads to what was saved any more.
    state.document.go_to(1);
    REQUIRE(edit(state, change(state.document, "pop", "kick", 3.0), "Another way"));
    screen.frame();
    CHECK_FALSE(screen.row("saved"));
    CHECK_FALSE(state.document.saved_after());
}

TEST_CASE("a long history shows the present step") {
    const Folder folder;
    AppState state = opened_state(folder);
    texts_of_kicks(state, 40);
    HistoryScreen screen(state);
    screen.frame();
    CHECK(screen.row("Kick 40"));
    state.document.go_to(3);
    screen.frame();
    screen.frame();
    CHECK(screen.row("Kick 3"));
    CHECK_FALSE(screen.row("Kick 40"));
}
