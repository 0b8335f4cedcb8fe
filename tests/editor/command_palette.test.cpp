// The command palette: what it finds, and how keys and mouse take it.
#include <catch2/catch.hpp>

#include <algorithm>

#include "tests/editor/screen.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

/// Titles found, best first.
std::vector<std::string> titles(const AppState& state, std::string_view query, std::size_t most = 3) {
    const std::vector<Command> commands = all_commands(state);
    std::vector<std::string> out;
    for (const FoundCommand& found : find_commands(commands, query))
        if (out.size() < most) out.push_back(commands[found.index].title);
    return out;
}
using Titles = std::vector<std::string>;

class Desk : public Screen {
public:
    Desk() : Screen({1000, 800}), state_(opened_state(folder_)) {
        run(state_, "view.command_palette");
        for (int i = 0; i < 3; ++i) frame();
    }

    AppState& state() { return state_; }
    void frame() {
        frame_of([&] {
            viewport_panel(state_, ui_, {0, 0}, {1000, 800});
            command_palette(state_, ui_);
            advance(state_, 0);
        });
    }
    void type(const std::string& characters) {
        for (const char c : characters) {
            ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
            frame();
        }
    }
    void press(ImGuiKey key) {
        for (const bool down : {true, false}) {
            ImGui::GetIO().KeysDown[key] = down;
            frame();
        }
    }
    bool sees(std::string_view words) const {
        return std::any_of(seen_.begin(), seen_.end(), [&](const ScreenText& t) { return t.text.find(words) != std::string::npos; });
    }
    void click(std::string_view words) {
        // The last one: what is drawn above the rest.
        const auto found = std::find_if(seen_.rbegin(), seen_.rend(), [&](const ScreenText& t) { return t.text.starts_with(words); });
        REQUIRE(found != seen_.rend());
        ImGui::GetIO().MousePos = {found->at.x + 5, found->at.y + 5};
        frame();
        for (const bool down : {true, false}) {
            ImGui::GetIO().MouseDown[0] = down;
            frame();
        }
    }

private:
    Folder folder_;
    AppState state_;
};

}  // namespace

TEST_CASE("every action but the answers to open questions is a command, and so is every node") {
    const Folder folder;
    const AppState state = opened_state(folder);
    const std::vector<Command> commands = all_commands(state);
    for (const Action& action : all_actions()) {
        const bool there = std::any_of(commands.begin(), commands.end(), [&](const Command& c) { return c.action == action.name; });
        INFO(action.name);
        const bool answer = action.menu.empty() && action.shortcut.empty() && !enabled(state, action.name) && !action.name.starts_with("source.");
        CHECK(there != answer);
    }
    for (const NodeId node : state.document.scene().all())
        CHECK(std::count_if(commands.begin(), commands.end(), [&](const Command& c) { return c.node == node; }) == 1);
    CHECK(find_commands(commands, "").size() == commands.size());
}

TEST_CASE("a few letters find commands, ids, types and places") {
    const Folder folder;
    const AppState state = opened_state(folder);
    CHECK(titles(state, "undo", 1) == Titles{"Undo"});
    CHECK(titles(state, "save as", 1) == Titles{"Save As..."});
    CHECK(titles(state, "dup", 1) == Titles{"Duplicate"});
    CHECK(titles(state, "post", 1) == Titles{"post"});
    CHECK(titles(state, "bumper", 2) == Titles{"Add bumper", "pop"});
    CHECK(titles(state, "circle corner") == Titles{"post", "nail"});
    CHECK(titles(state, "domain box", 1) == Titles{"domain[0]/box[0]"});
    CHECK(titles(state, "rubber", 1) == Titles{"rubber"});
    CHECK(titles(state, "qqq").empty());
}

TEST_CASE("letters and Enter run a command; the keyboard is there at once") {
    Desk desk;
    select(desk.state(), id_of(desk.state().document, "pop"));
    desk.frame();
    desk.type("dupl");
    CHECK(desk.sees("Ctrl+D"));
    desk.press(ImGuiKey_Enter);
    CHECK(desk.state().document.scene().find("pop_2"));
    CHECK_FALSE(desk.state().show_command_palette);
    desk.frame();
    CHECK_FALSE(desk.sees("Ctrl+D"));
}

TEST_CASE("letters that come before the field has the keyboard are not lost") {
    Desk desk;
    desk.press(ImGuiKey_Escape);
    run(desk.state(), "view.command_palette");
    desk.type("isolines");
    CHECK(desk.ui().commands.query == "isolines");
    for (const char c : std::string("x")) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
    desk.frame();
    CHECK(desk.ui().commands.query == "isolinesx");
}

TEST_CASE("arrows go through what was found, and a node that is chosen is selected and shown") {
    Desk desk;
    desk.state().view.centre = {5, 5};
    desk.type("circle corner");
    desk.press(ImGuiKey_DownArrow);
    desk.press(ImGuiKey_Enter);
    CHECK(desk.state().selection.nodes() == std::vector{id_of(desk.state().document, "nail")});
    CHECK(desk.state().view.window().contains(Vec2(0.06, 0.16)));
    run(desk.state(), "view.command_palette");
    for (int i = 0; i < 3; ++i) desk.frame();
    CHECK(desk.ui().commands.query.empty());
    desk.type("circle corner");
    desk.press(ImGuiKey_UpArrow);  // round to the last
    CHECK(desk.ui().commands.chosen == 1);
    desk.press(ImGuiKey_DownArrow);
    desk.press(ImGuiKey_Enter);
    CHECK(desk.state().selection.nodes() == std::vector{id_of(desk.state().document, "post")});
}

TEST_CASE("what cannot be done now is there but does nothing, and Esc leaves") {
    Desk desk;
    desk.type("undo");
    desk.press(ImGuiKey_Enter);
    CHECK(desk.state().show_command_palette);
    CHECK(desk.state().message.empty());
    desk.press(ImGuiKey_Escape);
    CHECK_FALSE(desk.state().show_command_palette);
    desk.frame();
    CHECK_FALSE(desk.sees("Ctrl+Z"));
}

TEST_CASE("a click takes a row, a click elsewhere leaves") {
    Desk desk;
    desk.type("isolines");
    desk.click("Isolines");
    CHECK(desk.state().view.style == ViewStyle::isolines);
    CHECK_FALSE(desk.state().show_command_palette);
    run(desk.state(), "view.command_palette");
    for (int i = 0; i < 3; ++i) desk.frame();
    ImGui::GetIO().MousePos = {20, 780};
    desk.frame();
    for (const bool down : {true, false}) {
        ImGui::GetIO().MouseDown[0] = down;
        desk.frame();
    }
    CHECK_FALSE(desk.state().show_command_palette);
}

TEST_CASE("a few letters add a node, put what is selected into an operator, and make it one of another type") {
    const Folder folder;
    AppState state = opened_state(folder);
    const auto take_first = [&](std::string_view query) {
        const std::vector<Command> commands = all_commands(state);
        run(state, commands[find_commands(commands, query).at(0).index]);
    };
    take_first("add star");
    CHECK(state.document.scene().find(state.selection.primary())->type->key() == "star");
    select(state, id_of(state.document, "shelf"));
    take_first("put in smooth union");
    CHECK(state.document.scene().find(state.selection.primary())->type->key() == "smooth_union");
    select(state, id_of(state.document, "shelf"));
    take_first("change to ellipse");
    CHECK(state.document.scene().find(id_of(state.document, "shelf"))->type->key() == "ellipse");
    CHECK(state.document.undo_steps() == 3);
}
