// The source panel under a person's mouse and keys, in frames without a window.
#include <catch2/catch.hpp>

#include <algorithm>
#include <map>

#include "tests/editor/screen.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

/// The source to the left, the table to the right, a mouse and a keyboard.
class Desk : public Screen {
public:
    explicit Desk(const std::string& table = pen) : Screen({1400, 800}), state_(opened_state(folder_, table)) {
        for (int i = 0; i < 3; ++i) frame();
    }

    AppState& state() { return state_; }
    std::string text() const { return state_.document.source().text(); }
    std::string shown() const { return ui_.source.shown->text(); }
    NodeId id(std::string_view node) const { return id_of(state_.document, node); }

    void frame() {
        frame_of([&] {
            viewport_panel(state_, ui_, {900, 0}, {500, 800});
            source_panel(state_, ui_, {0, 0}, {900, 800});
            advance(state_, 1);
        });
    }
    void move_to(ImVec2 pixel) {
        ui_.mouse = {pixel.x, pixel.y};
        ImGui::GetIO().MousePos = pixel;
        frame();
    }
    void click(ImVec2 pixel) {
        move_to(pixel);
        for (const bool down : {true, false, false}) {
            ImGui::GetIO().MouseDown[0] = down;
            frame();
        }
    }
    void press(ImGuiKey key, bool control = false, bool shift = false) {
        ImGuiIO& io = ImGui::GetIO();
        io.KeyCtrl = control;
        io.KeyShift = shift;
        for (const bool down : {true, false}) {
            io.KeysDown[key] = down;
            frame();
        }
        io.KeyCtrl = io.KeyShift = false;
    }
    void type(const std::string& characters) {
        for (const char c : characters) {
            ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
            frame();
        }
    }
    void rest(int frames = 40) {
        for (int i = 0; i < frames; ++i) frame();
    }

    /// Where a word of the text stands on the screen; its first place, or behind it.
    ImVec2 place(std::string_view word, bool behind = false) const {
        const SourceText& source = *ui_.source.shown;
        std::size_t at = source.text().find(word);
        REQUIRE(at != std::string::npos);
        if (behind) at += word.size();
        const LineColumn where = source.line_column(at);
        const ScreenText number = on_screen(std::to_string(where.line), [](const ScreenText& t) { return t.at.x < 60; });
        const float advance = ui_.theme.mono->GetCharAdvance('0');
        const ScreenText first = *std::find_if(seen_.begin(), seen_.end(), [&](const ScreenText& t) { return t.at.y == number.at.y && t.at.x > 60; });
        const auto begins = static_cast<int>(source.line(where.line).find_first_not_of(" \xEF\xBB\xBF"));
        return {first.at.x + advance * static_cast<float>(where.column - 1 - begins) + 0.2f * advance, number.at.y + 6};
    }
    bool sees(std::string_view words) const {
        return std::any_of(seen_.begin(), seen_.end(), [&](const ScreenText& t) { return t.text.find(words) != std::string::npos; });
    }
    void choose(std::string_view words) {
        const ScreenText button = on_screen(words, [](const ScreenText& t) { return t.at.x < 900; });
        click({button.at.x + 5, button.at.y + 5});
    }

private:
    template <class Where>
    ScreenText on_screen(std::string_view words, Where where) const {
        const auto found = std::find_if(seen_.begin(), seen_.end(), [&](const ScreenText& t) { return t.text == words && where(t); });
        INFO(words);
        REQUIRE(found != seen_.end());
        return *found;
    }

    Folder folder_;
    AppState state_;
};

std::string replaced(std::string text, const std::string& words, const std::string& by) {
    return text.replace(text.find(words), words.size(), by);
}

/// With line breaks of two bytes, a byte order mark, and no break at its end.
std::string from_elsewhere(const std::string& text) {
    std::string out = "\xEF\xBB\xBF";
    for (const char c : text) out += c == '\n' ? "\r\n" : std::string(1, c);
    return out.substr(0, out.size() - 2);
}

}  // namespace

TEST_CASE("a click on a line selects its node and puts the cursor there; a line under the mouse lets its node glow") {
    Desk desk;
    desk.move_to(desk.place("shelf"));
    CHECK(desk.ui().hovered == desk.id("shelf"));
    CHECK(desk.state().selection.empty());
    desk.click(desk.place("24mm"));
    CHECK(desk.state().selection.nodes() == std::vector{desk.id("pop")});
    CHECK(desk.ui().source.cursor == cursor_at(desk.text().find("24mm")));
    CHECK(desk.ui().source.focused);
    desk.click(desk.place("10mm"));  // a child, in a line of its own
    CHECK(desk.state().selection.primary() == desk.id("post"));
    desk.click(desk.place("corner"));
    CHECK(desk.state().selection.primary() == desk.id("corner"));
    desk.move_to(desk.place("0.48, 0.98"));  // in one line with its parent
    CHECK(desk.ui().hovered == desk.id("domain[0]/box[0]"));
    CHECK_FALSE(desk.state().document.can_undo());
}

TEST_CASE("what is selected elsewhere is scrolled to, and what is under the mouse on the table has its lines marked") {
    std::string table = "pinfield: 1\ntable: {size: [1, 1]}\nscene:\n";
    for (int i = 0; i < 200; ++i)
        table += "  - circle: {id: n" + std::to_string(i) + ", at: [" + std::to_string(0.05 + 0.004 * i) + ", 0.5], radius: 1mm}\n";
    Desk desk(table);
    CHECK(desk.sees("n3,"));
    CHECK_FALSE(desk.sees("n150"));
    select(desk.state(), desk.id("n150"));
    desk.rest(3);
    CHECK(desk.sees("n150"));
    CHECK_FALSE(desk.sees("n3,"));
    desk.move_to({1395, 5});
    const auto tinted = [] {
        int rows = 0;
        for (const ImDrawVert& v : ImGui::GetDrawData()->CmdLists[0]->VtxBuffer) rows += v.col == ink(palette::field) ? 1 : 0;
        for (int l = 1; l < ImGui::GetDrawData()->CmdListsCount; ++l)
            for (const ImDrawVert& v : ImGui::GetDrawData()->CmdLists[l]->VtxBuffer) rows += v.col == ink(palette::field) ? 1 : 0;
        return rows;
    };
    const int before = tinted();
    const Vec2 pixel = desk.state().view.pixel_from_world({0.05 + 0.004 * 155, 0.5});
    desk.move_to({static_cast<float>(pixel.x()), static_cast<float>(pixel.y())});
    CHECK(desk.ui().hovered == desk.id("n155"));
    CHECK(tinted() == before + 4);
}

TEST_CASE("typing changes the running table as one step, and Ctrl+Z takes it back") {
    Desk desk;
    const Vec2 start = desk.state().session.world().balls().front().position;
    desk.rest();
    const Vec2 rolled = desk.state().session.world().balls().front().position;
    desk.click(desk.place("24mm", true));
    desk.press(ImGuiKey_LeftArrow);
    desk.press(ImGuiKey_LeftArrow);
    desk.press(ImGuiKey_Backspace);
    desk.press(ImGuiKey_Backspace);
    desk.type("31");
    CHECK(desk.text() == pen);  // not yet at rest
    desk.rest();
    CHECK(desk.text() == replaced(pen, "24mm", "31mm"));
    CHECK(desk.state().document.undo_steps() == 1);
    CHECK(length(desk.state().session.world().balls().front().position - start) > length(rolled - start));
    desk.press(ImGuiKey_Backspace);
    desk.type("2");
    desk.rest();
    CHECK(desk.text() == replaced(pen, "24mm", "32mm"));
    CHECK(desk.state().document.undo_steps() == 1);
    desk.press(ImGuiKey_Z, true);
    CHECK(desk.text() == pen);
    desk.press(ImGuiKey_Z, true, true);
    CHECK(desk.text() == replaced(pen, "24mm", "32mm"));
}

TEST_CASE("a broken text stands there with what is wrong, while the last good table plays; mended, it is taken") {
    Desk desk;
    desk.click(desk.place("circle: {id: post"));
    desk.press(ImGuiKey_RightArrow);
    desk.press(ImGuiKey_Delete);
    desk.rest();
    CHECK(desk.text() == pen);
    CHECK(desk.shown() == replaced(pen, "circle: {id: post", "crcle: {id: post"));
    CHECK(desk.sees("does not read"));
    CHECK(desk.sees("Line 16:"));
    CHECK(problems_of(desk.state()).count() == 1);
    const std::int64_t ticks = desk.state().session.world().tick();
    desk.rest();
    CHECK(desk.state().session.world().tick() > ticks);
    CHECK_FALSE(desk.sees("did you mean circle"));  // the mouse is there, but the hand is on the keys
    desk.move_to(desk.place("rcle"));
    desk.rest(2);
    CHECK(desk.sees("did you mean circle"));
    desk.type("i");
    desk.rest();
    CHECK(desk.shown() == pen);
    CHECK_FALSE(desk.sees("does not read"));
    CHECK(desk.state().document.undo_steps() == 0);
}

TEST_CASE("a broken text outlives what is done elsewhere, until it is tried again or discarded") {
    Desk desk;
    desk.click(desk.place("kick: 0.8", true));
    desk.type("x");
    desk.rest();
    desk.click({1300, 20});  // on the table
    REQUIRE_FALSE(desk.ui().source.focused);
    REQUIRE_FALSE(desk.state().document.edit(change(desk.state().document, "post", "radius", 0.012), "Change radius"));
    desk.rest();
    CHECK(desk.sees("The table was changed elsewhere meanwhile."));
    CHECK(desk.shown() == replaced(pen, "kick: 0.8", "kick: 0.8x"));
    desk.choose("Try again");
    CHECK(desk.shown() == replaced(replaced(pen, "kick: 0.8", "kick: 0.8x"), "10mm", "12mm"));
    CHECK_FALSE(desk.sees("elsewhere"));
    desk.choose("Discard");
    CHECK(desk.shown() == replaced(pen, "10mm", "12mm"));
    CHECK(desk.state().document.undo_steps() == 1);
}

TEST_CASE("bytes that were not typed at stay as they are, line breaks of two bytes among them") {
    const std::string table = from_elsewhere(pen);
    Desk desk(table);
    desk.click(desk.place("# the middle one", true));
    desk.press(ImGuiKey_Enter);
    desk.type("- circle: {id: new, at: [0.4, 0.4], radius: 5mm}");
    desk.rest();
    CHECK(desk.text() == replaced(table, "# the middle one", "# the middle one\r\n  - circle: {id: new, at: [0.4, 0.4], radius: 5mm}"));
    CHECK(desk.id("new"));
}

TEST_CASE("text is selected by mouse and keys, cut, and pasted") {
    Desk desk;
    desk.click(desk.place("# the middle one"));
    desk.press(ImGuiKey_End, false, true);
    desk.press(ImGuiKey_X, true);
    desk.rest();
    CHECK(desk.text() == replaced(pen, "# the middle one", ""));
    desk.click(desk.place("# bouncy", true));
    desk.press(ImGuiKey_V, true);
    desk.rest();
    CHECK(desk.text() == replaced(replaced(pen, "# the middle one", ""), "# bouncy", "# bouncy# the middle one"));
    const ImVec2 word = desk.place("shelf");
    desk.rest();
    desk.click(word);
    desk.click(word);
    CHECK(desk.ui().source.shown->slice(desk.ui().source.cursor.selected()) == "shelf");
}

TEST_CASE("Ctrl+E types at the selected node; Esc gives the keyboard back, and what was typed is read at once") {
    Desk desk;
    select(desk.state(), desk.id("shelf"));
    run(desk.state(), "edit.source");
    desk.frame();
    CHECK(desk.ui().source.focused);
    CHECK(desk.state().document.source().line_column(desk.ui().source.cursor.caret).line == 9);
    desk.press(ImGuiKey_End);
    desk.type("  # here");
    desk.press(ImGuiKey_Escape);
    CHECK_FALSE(desk.ui().source.focused);
    CHECK_THAT(desk.text(), Catch::Contains("0.02]}  # here\n"));
}

TEST_CASE("the line that is typed at stays in sight when what is wrong with it is said below") {
    std::string table = "pinfield: 1\ntable: {size: [1, 1]}\nscene:\n";
    for (int i = 0; i < 100; ++i) table += "  - circle: {id: n" + std::to_string(i) + ", at: [0.5, 0.5], radius: 1mm}\n";
    Desk desk(table);
    int last = 0;
    while (desk.sees("n" + std::to_string(last + 1) + ",")) ++last;
    desk.click(desk.place("circle: {id: n" + std::to_string(last - 1)));
    desk.type("x");
    desk.rest();
    CHECK(desk.sees("does not read"));
    CHECK(desk.sees("n" + std::to_string(last - 1) + ","));
}

TEST_CASE("lines that differ from the file are counted and marked, with what was saved under the mouse, until a save") {
    Desk desk;
    CHECK(desk.sees("as saved"));
    desk.click(desk.place("24mm"));
    desk.press(ImGuiKey_Delete);
    desk.type("3");
    desk.press(ImGuiKey_DownArrow);
    desk.press(ImGuiKey_Home);
    desk.type("# new");
    desk.press(ImGuiKey_Enter);
    desk.rest();
    CHECK(desk.sees("+2 -1"));
    desk.move_to({20, desk.place("34mm").y});
    desk.rest(2);
    CHECK(desk.sees("radius: 24mm"));
    desk.move_to({1300, 700});
    run(desk.state(), "view.changes");
    desk.rest(2);
    CHECK(desk.sees("changes"));
    run(desk.state(), "view.changes");
    CHECK(desk.state().document.save());
    desk.rest(2);
    CHECK(desk.sees("as saved"));
}

TEST_CASE("who leaves the table is asked about a text that does not read, and saving does not lose it") {
    Desk desk;
    desk.click(desk.place("kick: 0.8", true));
    desk.type("x");
    desk.rest();
    run(desk.state(), "app.quit");
    REQUIRE(desk.state().prompt);
    CHECK_THAT(desk.state().prompt->question, Catch::Contains("does not read"));
    run(desk.state(), "prompt.save");
    CHECK_FALSE(desk.state().quit);
    CHECK(desk.state().source.pending());
    run(desk.state(), "app.quit");
    run(desk.state(), "prompt.discard");
    CHECK(desk.state().quit);
}
