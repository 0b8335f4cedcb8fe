#include "editor/preferences.h"

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <set>

#include "editor/keep_preferences.h"
#include "tests/editor/screen.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

Preferences read_from(const std::string& text) {
    Preferences preferences;
    static_cast<void>(read_preferences(text, preferences));
    return preferences;
}

/// All of them other than usual.
Preferences unusual() {
    Preferences p;
    p.theme = ThemeChoice::light;
    p.font_size = 17.5;
    p.snapping = !p.snapping;
    p.grid = 0.005;
    p.favourites = {"star", "chamfer_box"};
    p.show_source = !p.show_source;
    p.show_changes = !p.show_changes;
    p.show_palette = !p.show_palette;
    p.show_history = !p.show_history;
    p.show_rulers = !p.show_rulers;
    p.show_guides = !p.show_guides;
    p.lock_guides = !p.lock_guides;
    p.warn_of_gaps = !p.warn_of_gaps;
    p.left = 300, p.right = 301, p.source_width = 302, p.palette_height = 303, p.history_height = 304, p.problems_height = 305;
    return p;
}

}  // namespace

TEST_CASE("what was changed in one run is so in the next, and every preference has a line") {
    const Folder folder;
    std::vector<std::string> complaints;
    PreferencesFile file(folder.file("config/preferences.yaml"));
    CHECK(file.read(complaints) == Preferences{});
    CHECK_FALSE(file.keep(unusual()));
    CHECK(PreferencesFile(folder.file("config/preferences.yaml")).read(complaints) == unusual());
    CHECK(complaints.empty());
    for (const PreferenceField& field : preference_fields()) {
        CHECK(field.text(unusual()) != field.text(Preferences{}));
        CHECK(folder.read("config/preferences.yaml").find("\n" + std::string(field.key) + ": ") != std::string::npos);
    }
    CHECK_FALSE(file.keep(Preferences{}));
    CHECK(PreferencesFile(folder.file("config/preferences.yaml")).read(complaints) == Preferences{});
}

TEST_CASE("where nothing is changed nothing is written, and without a file nothing is kept") {
    const Folder folder;
    std::vector<std::string> complaints;
    PreferencesFile file(folder.file("preferences.yaml"));
    file.read(complaints);
    CHECK_FALSE(file.keep(Preferences{}));
    file.pass_over(unusual());
    CHECK_FALSE(file.keep(unusual()));
    CHECK_FALSE(std::filesystem::exists(folder.file("preferences.yaml")));
    CHECK_FALSE(PreferencesFile().keep(unusual()));
}

TEST_CASE("lines that are not understood are complained about and stay, with comments, order and line ends") {
    const std::string text =
        "# mine\r\ntheme:light   # at night\r\n\r\nwings: 4\r\nfont_size: enormous\nnonsense\ngrid: 2 # mm\n  snapping :  false";
    Preferences read;
    const std::vector<std::string> complaints = read_preferences(text, read);
    REQUIRE(complaints.size() == 4);
    CHECK(complaints[0] == "line 4: no preference is called wings");
    CHECK(complaints[1] == "line 5: font_size is a number from 8 to 48, not enormous");
    CHECK(complaints[2] == "line 6: no preference is called nonsense");
    CHECK(complaints[3] == "line 7: grid is a length up to 100mm, or off, not 2");
    CHECK(read.theme == ThemeChoice::light);
    CHECK_FALSE(read.snapping);
    Preferences now = read;
    now.theme = ThemeChoice::dark;
    now.snapping = true;
    now.show_history = true;
    CHECK(with_preferences(text, read, now) ==
          "# mine\r\ntheme:dark   # at night\r\n\r\nwings: 4\r\nfont_size: enormous\nnonsense\ngrid: 2 # mm\n  snapping :  "
          "true\nshow_history: true\n");
}

TEST_CASE("whatever the file holds, what is changed is read back and every other line stays") {
    CHECK(rc::check([] {
        const auto line =
            rc::gen::element<std::string>("theme: light", "theme: dark", "theme:", "theme", "font_size: 12 # x", "font_size:", "grid: off",
                                          "grid: -1mm", "left_width: 9e99", "left_width: 400", "# theme: light", "", "  ", "future: {a: b}",
                                          "\tsnapping:false", "snapping: false\r", ": 3", "show_source: true", "\xff\xfe:1");
        const auto lines = *rc::gen::container<std::vector<std::string>>(line);
        const bool ends = *rc::gen::arbitrary<bool>();
        std::string text;
        for (std::size_t i = 0; i < lines.size(); ++i) text += lines[i] + (i + 1 < lines.size() || ends ? "\n" : "");
        const Preferences before = read_from(text);
        Preferences now = before;
        if (*rc::gen::arbitrary<bool>()) now.theme = now.theme == ThemeChoice::dark ? ThemeChoice::light : ThemeChoice::dark;
        if (*rc::gen::arbitrary<bool>()) now.font_size = *rc::gen::inRange(8, 49);
        if (*rc::gen::arbitrary<bool>()) now.grid = *rc::gen::inRange(0, 101) / 1000.0;
        if (*rc::gen::arbitrary<bool>()) now.left = static_cast<float>(*rc::gen::inRange(60, 4001));
        if (*rc::gen::arbitrary<bool>()) now.snapping = !now.snapping;
        const std::string after = with_preferences(text, before, now);
        RC_ASSERT(read_from(after) == now);
        if (now == before) RC_ASSERT(after == text);
        std::multiset<std::string> old_lines, new_lines;
        const SourceText a("", text), b("", after);
        for (int i = 1; i <= a.line_count(); ++i) old_lines.insert(std::string(a.line(i)));
        for (int i = 1; i <= b.line_count(); ++i) new_lines.insert(std::string(b.line(i)));
        std::size_t gone = 0;
        for (const std::string& old_line : old_lines) gone += new_lines.count(old_line) < old_lines.count(old_line) ? 1 : 0;
        std::size_t changed = 0;
        for (const PreferenceField& field : preference_fields()) changed += field.text(now) != field.text(before) ? 1 : 0;
        RC_ASSERT(gone <= changed * lines.size());
        for (const std::string kept : {"# theme: light", "future: {a: b}", ": 3", "\xff\xfe:1", "theme"})
            RC_ASSERT(new_lines.count(kept) == old_lines.count(kept));
    }));
}

TEST_CASE("a file that is no text, too large or a folder is left alone, and the editor works on") {
    const Folder folder;
    const auto left_alone = [&](const std::string& name) {
        std::vector<std::string> complaints;
        PreferencesFile file(folder.file(name));
        CHECK(file.read(complaints) == Preferences{});
        CHECK(complaints.size() == 1);
        CHECK(file.keep(unusual()));
        CHECK_FALSE(file.keep(unusual()));  // said once
    };
    const std::string binary("theme: light\n\0\1", 15), large = std::string(70'000, '#') + "\ntheme: light\n";
    folder.write("binary", binary);
    folder.write("large", large);
    std::filesystem::create_directory(folder.file("folder"));
    for (const char* name : {"binary", "large", "folder"}) left_alone(name);
    CHECK(folder.read("binary") == binary);
    CHECK(folder.read("large") == large);
}

TEST_CASE("two editors that change different preferences both keep theirs") {
    const Folder folder;
    std::vector<std::string> complaints;
    PreferencesFile a(folder.file("p")), b(folder.file("p"));
    Preferences of_a = a.read(complaints), of_b = b.read(complaints);
    of_a.theme = ThemeChoice::light;
    of_b.font_size = 20;
    CHECK_FALSE(a.keep(of_a));
    CHECK_FALSE(b.keep(of_b));
    const Preferences both = PreferencesFile(folder.file("p")).read(complaints);
    CHECK(both.theme == ThemeChoice::light);
    CHECK(both.font_size == 20);
}

TEST_CASE("what is wrong with the preferences is said once, and they are kept by the actions that change them") {
    const Folder folder;
    folder.write("preferences.yaml", "theme: purple\nsnapping: false\n");
    AppState state = opened_state(folder);
    load_preferences(state, folder.file("").substr(0, folder.file("").size() - 1));
    CHECK(state.message_is_problem);
    CHECK(state.message.ends_with("preferences.yaml, line 1: theme is dark or light, not purple"));
    CHECK_FALSE(state.preferences.snapping);
    for (const char* action : {"theme.light", "font.larger", "grid.5mm", "view.history"}) run(state, action);
    CHECK(is_on(state, "theme.light"));
    CHECK_FALSE(is_on(state, "theme.dark"));
    CHECK(is_on(state, "grid.5mm"));
    keep_preferences(state);
    CHECK(folder.read("preferences.yaml") == "theme: light\nsnapping: false\nfont_size: 15\ngrid: 5mm\nshow_history: true\n");
    run(state, "preferences.usual");
    CHECK(state.preferences == Preferences{});
}

TEST_CASE("text grows and shrinks within bounds") {
    const Folder folder;
    AppState state = opened_state(folder);
    for (int i = 0; i < 100 && enabled(state, "font.larger"); ++i) run(state, "font.larger");
    CHECK(state.preferences.font_size == most_font_size);
    for (int i = 0; i < 100 && enabled(state, "font.smaller"); ++i) run(state, "font.smaller");
    CHECK(state.preferences.font_size == least_font_size);
    run(state, "font.usual");
    CHECK(state.preferences.font_size == 14);
}

TEST_CASE("favourites are the palette's first, by a click on a star or by the action, and are kept") {
    class Shelf : public Screen {
    public:
        explicit Shelf(AppState& state) : Screen({600, 600}), state_(state) { frame(), frame(); }
        void frame() {
            frame_of([&] { palette_panel(state_, ui_, {0, 0}, {300, 600}); });
        }
        /// Where the words begin; -1: nowhere.
        float y_of(std::string_view words) const {
            const auto found = std::find_if(seen().begin(), seen().end(), [&](const ScreenText& t) { return t.text == words; });
            return found == seen().end() ? -1 : found->at.y;
        }
        void click(ImVec2 place) {
            ImGui::GetIO().MousePos = place;
            frame();
            for (const bool down : {true, false}) ImGui::GetIO().MouseDown[0] = down, frame();
            frame();
        }

    private:
        AppState& state_;
    };
    const Folder folder;
    AppState state = opened_state(folder);
    Shelf shelf(state);
    CHECK(shelf.y_of("Favourites") < 0);
    // The first cell is 68 wide and begins at 8; its star is in its upper right corner.
    shelf.click({8 + 68 - 10, shelf.y_of("bumper") - 48 + 10});
    CHECK(state.preferences.favourites == std::vector<std::string>{"bumper"});
    CHECK(shelf.y_of("Favourites") >= 0);
    CHECK(shelf.y_of("Favourites") < shelf.y_of("Parts"));
    select(state, id_of(state.document, "shelf"));
    run(state, "edit.favourite");
    CHECK(is_on(state, "edit.favourite"));
    CHECK(state.preferences.favourites == std::vector<std::string>{"bumper", "box"});
    shelf.frame();
    shelf.click({8 + 68 - 10, shelf.y_of("bumper") - 48 + 10});
    CHECK(state.preferences.favourites == std::vector<std::string>{"box"});
    CHECK(read_from("favourites: [box, box, no_such_node]").favourites == std::vector<std::string>{"box", "no_such_node"});
    CHECK(read_from("favourites: []").favourites.empty());
    for (const char* bad : {"favourites: box", "favourites: [a b]", "favourites: [,]", "favourites: [", "favourites: [Box]"})
        CHECK(read_from(bad) == Preferences{});
}

TEST_CASE("arrow keys move by the preferred grid, and a drag goes by it") {
    const Folder folder;
    AppState state = opened_state(folder);
    select(state, id_of(state.document, "shelf"));
    const auto place = [&] { return state.document.scene().find("shelf")->get<Vec2>("at"); };
    run(state, "grid.5mm");
    run(state, "edit.nudge_right");
    run(state, "edit.nudge_right");
    CHECK(length(place() - Vec2(0.26, 0.3)) < 1e-12);
    run(state, "grid.1mm");
    run(state, "edit.nudge_right");
    CHECK(length(place() - Vec2(0.261, 0.3)) < 1e-12);
    run(state, "grid.off");  // an arrow must do something
    run(state, "edit.nudge_left");
    CHECK(length(place() - Vec2(0.26, 0.3)) < 1e-12);
}

TEST_CASE("the preferences are changed by keys and by mouse, and Esc closes them") {
    class Dialog : public Screen {
    public:
        explicit Dialog(AppState& state) : Screen({1200, 800}), state_(state) { frame(), frame(); }
        void frame() {
            frame_of([&] { preferences_dialog(state_, ui_); });
        }
        void press(ImGuiKey key) {
            for (const bool down : {true, false}) ImGui::GetIO().KeysDown[key] = down, frame();
        }
        void click(std::string_view words) {
            const auto found = std::find_if(seen().begin(), seen().end(), [&](const ScreenText& t) { return t.text == words; });
            REQUIRE(found != seen().end());
            ImGui::GetIO().MousePos = {found->at.x + 4, found->at.y + 6};
            frame();
            for (const bool down : {true, false}) ImGui::GetIO().MouseDown[0] = down, frame();
        }

    private:
        AppState& state_;
    };
    const Folder folder;
    AppState state = opened_state(folder);
    run(state, "edit.preferences");
    CHECK(asks(state));
    Dialog dialog(state);
    dialog.press(ImGuiKey_RightArrow);
    CHECK(state.preferences.theme == ThemeChoice::light);
    dialog.press(ImGuiKey_DownArrow);
    dialog.press(ImGuiKey_RightArrow);
    CHECK(state.preferences.font_size == 15);
    dialog.press(ImGuiKey_DownArrow);
    dialog.press(ImGuiKey_RightArrow);
    CHECK(state.preferences.grid == 0.002);
    dialog.press(ImGuiKey_DownArrow);
    dialog.press(ImGuiKey_Space);
    CHECK_FALSE(state.preferences.snapping);
    dialog.click("Dark");
    CHECK(state.preferences.theme == ThemeChoice::dark);
    dialog.press(ImGuiKey_Escape);
    CHECK_FALSE(state.show_preferences);
    CHECK_FALSE(asks(state));
}
