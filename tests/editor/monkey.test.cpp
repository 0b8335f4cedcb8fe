// Somebody who knows nothing, with a mouse and a keyboard: whatever is done, the text reads, the table that runs is the one it says, and undo
// leads back to the beginning. PINFIELD_MONKEY asks for another number of actions than usual, PINFIELD_MONKEY_SEED for another monkey.
#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <deque>
#include <ranges>

#include "editor/actions.h"
#include "editor/keyboard.h"
#include "engine/core/keys.h"
#include "engine/core/numbers.h"
#include "engine/core/rng.h"
#include "engine/io/same_content.h"
#include "engine/program/compile.h"
#include "tests/editor/screen.h"
#include "tests/editor/support.h"
#include "tests/program/same_program.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

namespace fs = std::filesystem;

std::int64_t asked(const char* variable, std::int64_t usually) {
    const char* const text = std::getenv(variable);
    return text ? static_cast<std::int64_t>(parse_number(text).value_or(static_cast<double>(usually))) : usually;
}

/// What it saves under any name goes into a folder of its own.
class Inside {
public:
    explicit Inside(const Folder& folder) { fs::current_path(folder.file("")); }
    ~Inside() { fs::current_path(before_); }
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;

private:
    fs::path before_ = fs::current_path();
};

/// All of the editor but its window.
class Editor : public Screen {
public:
    explicit Editor(AppState state) : Screen({1200, 800}), state_(std::move(state)) { frame(); }

    AppState& state() { return state_; }
    Keyboard& keyboard() { return keyboard_; }
    void frame() {
        frame_of([&] {
            draw_panels(state_, ui_);
            advance(state_, 4);
        });
    }

private:
    AppState state_;
    Keyboard keyboard_;
};

class Monkey {
public:
    Monkey(Editor& editor, std::uint64_t seed) : editor_(editor), rng_(seed) {}

    /// One thing that a person might do, and a frame or some.
    void act() {
        const double what = rng_.uniform();
        if (what < 0.35) click();
        else if (what < 0.50) drag();
        else if (what < 0.58) note("scroll"), ImGui::GetIO().MouseWheel = static_cast<float>(rng_.in(-2, 2)), editor_.frame();
        else if (what < 0.75) press();
        else if (what < 0.83) type();
        else if (what < 0.97) run_action();
        else rest();
    }
    std::string story() const {
        std::string out;
        for (const std::string& step : steps_) out += step + "\n";
        return out;
    }

private:
    template <class List>
    const auto& any_of(const List& list) {
        return list[rng_.next_u64() % std::size(list)];
    }
    void note(std::string step) {
        steps_.push_back(std::move(step));
        if (steps_.size() > 40) steps_.pop_front();
    }
    bool chance(double share) { return rng_.uniform() < share; }

    /// On some word mostly, as people do; else anywhere.
    ImVec2 somewhere() {
        if (!editor_.seen().empty() && chance(0.6)) {
            const ScreenText& text = any_of(editor_.seen());
            return {text.at.x + 4, text.at.y + 6};
        }
        return {static_cast<float>(rng_.in(0, 1200)), static_cast<float>(rng_.in(0, 800))};
    }
    void move_to(ImVec2 place) {
        ImGui::GetIO().MousePos = place;
        editor_.ui().mouse = {place.x, place.y};
        editor_.frame();
    }
    void button(int which, bool down) {
        ImGui::GetIO().MouseDown[which] = down;
        editor_.frame();
    }
    static void with_modifiers(bool control, bool shift, bool alt) {
        ImGuiIO& io = ImGui::GetIO();
        io.KeyCtrl = control, io.KeyShift = shift, io.KeyAlt = alt;
    }
    void click() {
        const ImVec2 place = somewhere();
        const int which = chance(0.15) ? 1 : 0;
        note(fmt::format("click {} at {}, {}", which, place.x, place.y));
        with_modifiers(chance(0.1), chance(0.15), chance(0.05));
        move_to(place);
        for (int times = chance(0.15) ? 2 : 1; times > 0; --times) button(which, true), button(which, false);
        with_modifiers(false, false, false);
    }
    void drag() {
        const ImVec2 from = somewhere(), to = somewhere();
        note(fmt::format("drag from {}, {} to {}, {}", from.x, from.y, to.x, to.y));
        with_modifiers(chance(0.1), chance(0.1), chance(0.1));
        move_to(from);
        button(0, true);
        for (const float share : {0.2f, 0.6f, 1.0f}) move_to({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
        if (chance(0.1)) key("Escape");
        button(0, false);
        with_modifiers(false, false, false);
    }
    void key(std::string_view name) {
        for (const bool down : {true, false}) turn_key(name, down);
        editor_.frame();
    }
    void turn_key(std::string_view name, bool down) {
        editor_.keyboard().take(editor_.state(), {name, down, false}, is_typing(editor_.state(), editor_.ui()), [&] { return cancel_drag(editor_.state(), editor_.ui()); });
    }
    void press() { chance(0.5) ? press_plain() : press_chord(); }
    void press_plain() {
        static constexpr std::string_view keys[] = {"Escape", "Enter", "Tab", "Delete", "Up", "Down", "Left", "Right", "F2", "Space", "Z", "Slash", "Q", "W", "E", "R"};
        const std::string_view name = any_of(keys);
        note(fmt::format("press {}", name));
        static constexpr std::pair<std::string_view, ImGuiKey> known[] = {{"Escape", ImGuiKey_Escape}, {"Enter", ImGuiKey_Enter}, {"Tab", ImGuiKey_Tab}, {"Delete", ImGuiKey_Delete},
                                                                          {"Up", ImGuiKey_UpArrow},    {"Down", ImGuiKey_DownArrow}, {"Left", ImGuiKey_LeftArrow}, {"Right", ImGuiKey_RightArrow}};
        for (const auto& [word, code] : known)
            if (word == name) ImGui::GetIO().KeysDown[code] = true;
        key(name);
        for (const auto& [word, code] : known) ImGui::GetIO().KeysDown[code] = false;
        editor_.frame();
    }
    /// The keys of any action that has some, whether or not it can be done just now.
    void press_chord() {
        const Action& action = any_of(all_actions());
        if (action.shortcut.empty() || action.name == "app.quit") return;
        note(fmt::format("press {}", action.shortcut));
        std::vector<std::string> keys;
        for (const auto part : std::views::split(action.shortcut, '+')) {
            const std::string_view name(part.begin(), part.end());
            keys.emplace_back(name == "Ctrl" || name == "Shift" || name == "Alt" ? fmt::format("Left{}", name == "Ctrl" ? "Control" : name) : name == "Esc" ? "Escape" : std::string(name));
        }
        for (const std::string& name : keys) turn_key(name, true);
        for (const std::string& name : keys | std::views::reverse) turn_key(name, false);
        editor_.frame();
    }
    void type() {
        static constexpr std::string_view words[] = {"0.3", "25mm", "1in", "26+4", "-1", "pop", "left", "x", "- circle: {}", "# c", "1e9", "nan", "\"", "{", "30deg"};
        const std::string_view word = any_of(words);
        note(fmt::format("type {}", word));
        for (const char c : word) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
        editor_.frame();
    }
    void run_action() {
        const Action& action = any_of(all_actions());
        if (action.name == "app.quit" || !enabled(editor_.state(), action.name)) return;
        note(fmt::format("run {}", action.name));
        run(editor_.state(), action.name);
        editor_.frame();
    }
    void rest() {
        note("rest");
        for (int i = 0; i < 30; ++i) editor_.frame();
    }

    Editor& editor_;
    CounterRng rng_;
    std::deque<std::string> steps_;
};

void check_state(AppState& state) {
    for (const Ball& ball : state.session.world().balls()) REQUIRE(std::isfinite(ball.position.x() + ball.position.y() + ball.velocity.x() + ball.velocity.y()));
    for (const NodeId node : state.selection.nodes()) REQUIRE(state.document.scene().find(node));
    if (state.document.previewing()) return;
    const Document& document = state.document;
    const Reading again = document.read(document.source().text());
    REQUIRE(again.ok() == document.reading().ok());
    REQUIRE(same_content(again.scene, document.scene()));
    if (const auto fresh = compile(document.scene())) REQUIRE(pinfield::test::difference(state.session.program(), **fresh).empty());
}

/// Undoes all there is, and does it again.
void check_history(Document& document, const std::string& beginning) {
    if (document.previewing()) return;
    const std::string now = document.source().text();
    std::size_t steps = 0;
    for (; document.can_undo(); ++steps) document.undo();
    REQUIRE(document.source().text() == beginning);
    for (; steps > 0; --steps) document.redo();
    REQUIRE(document.source().text() == now);
}

}  // namespace

TEST_CASE("whatever a monkey does, the text reads, what runs is what it says, and undo leads back") {
    const std::int64_t actions = asked("PINFIELD_MONKEY", 1'500), first_seed = asked("PINFIELD_MONKEY_SEED", 1);
    constexpr std::int64_t of_one = 500;
    for (std::int64_t done = 0; done < actions; done += of_one) {
        const auto seed = static_cast<std::uint64_t>(first_seed + done / of_one);
        const Folder folder;
        const Inside inside(folder);
        Editor editor(opened_state(folder));
        Monkey monkey(editor, seed);
        Document& document = editor.state().document;
        std::string beginning = pen;
        for (std::int64_t i = 0; i < of_one; ++i) {
            monkey.act();
            INFO("monkey " << seed << ", action " << i << "\n" << monkey.story());
            if (!document.can_undo() && !document.previewing()) beginning = document.source().text();  // it may have opened another
            if (i % 10 == 0) check_state(editor.state());
            editor.state().quit = false;
        }
        INFO("monkey " << seed << "\n" << monkey.story());
        check_state(editor.state());
        check_history(document, beginning);
    }
}
