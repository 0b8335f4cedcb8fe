// The actions of the View menu and of the preferences: what is shown, and how; and the file that keeps it.
#include <fmt/format.h>

#include <algorithm>

#include "editor/edit_tools.h"
#include "editor/handlers.h"
#include "editor/keep_preferences.h"

namespace pinfield::editor {
namespace {

constexpr double font_step = 1;  ///< design pixels

void set_font_size(AppState& state, double size) {
    state.preferences.font_size = std::clamp(size, least_font_size, most_font_size);
    say(state, fmt::format("Text of {:g} pixels", state.preferences.font_size));
}

void reset_preferences(AppState& state) {
    state.preferences = {};
    say(state, "The usual preferences");
}

std::string_view selected_type(const AppState& state) {
    const Node* node = state.document.scene().find(state.selection.primary());
    return node && !node->is_record() ? node->type->key() : std::string_view();
}

bool may_add_guide(const AppState& state) { return state.aids.guides.size() < most_guides; }

void add_guide(AppState& state, int axis) {
    const Vec2 place = state.pointer.value_or(state.view.centre);
    state.aids.guides.push_back({axis, on_grid(place[axis], state.preferences.grid)});
    state.preferences.show_guides = true;
}

template <ThemeChoice theme>
constexpr Handler theme_handler(std::string_view action) {
    return {action, always, [](AppState& s) { s.preferences.theme = theme; },
            [](const AppState& s) { return s.preferences.theme == theme; }};
}

template <int micrometres>
constexpr Handler grid_handler(std::string_view action) {
    return {action, always, [](AppState& s) { s.preferences.grid = micrometres / 1e6; },
            [](const AppState& s) { return s.preferences.grid == micrometres / 1e6; }};
}

template <bool Preferences::*member>
constexpr Handler preference_switch(std::string_view action) {
    return {action, always, [](AppState& s) { s.preferences.*member = !(s.preferences.*member); },
            [](const AppState& s) { return s.preferences.*member; }};
}

template <ViewStyle style>
constexpr Handler style_handler(std::string_view action) {
    return {action, always, [](AppState& s) { s.view.style = style; }, [](const AppState& s) { return s.view.style == style; }};
}

}  // namespace

std::span<const Handler> preference_handlers() {
    static constexpr Handler handlers[] = {
        {"edit.preferences", always, [](AppState& s) { s.show_preferences = true; }},
        {"preferences.close", [](const AppState& s) { return s.show_preferences; }, [](AppState& s) { s.show_preferences = false; }},
        {"preferences.usual", always, reset_preferences},
        {"edit.favourite", [](const AppState& s) { return !selected_type(s).empty(); },
         [](AppState& s) { toggle_favourite(s.preferences, selected_type(s)); },
         [](const AppState& s) { return is_favourite(s.preferences, selected_type(s)); }},
        theme_handler<ThemeChoice::dark>("theme.dark"),
        theme_handler<ThemeChoice::light>("theme.light"),
        {"font.larger", [](const AppState& s) { return s.preferences.font_size < most_font_size; },
         [](AppState& s) { set_font_size(s, s.preferences.font_size + font_step); }},
        {"font.smaller", [](const AppState& s) { return s.preferences.font_size > least_font_size; },
         [](AppState& s) { set_font_size(s, s.preferences.font_size - font_step); }},
        {"font.usual", always, [](AppState& s) { set_font_size(s, Preferences{}.font_size); }},
        grid_handler<0>("grid.off"),
        grid_handler<100>("grid.tenth"),
        grid_handler<1000>("grid.1mm"),
        grid_handler<2000>("grid.2mm"),
        grid_handler<5000>("grid.5mm"),
        grid_handler<10000>("grid.10mm"),
        style_handler<ViewStyle::shaded>("view.shaded"),
        style_handler<ViewStyle::isolines>("view.isolines"),
        preference_switch<&Preferences::show_source>("view.source"),
        preference_switch<&Preferences::show_changes>("view.changes"),
        preference_switch<&Preferences::show_palette>("view.palette"),
        preference_switch<&Preferences::show_history>("view.history"),
        preference_switch<&Preferences::show_rulers>("view.rulers"),
        preference_switch<&Preferences::show_guides>("view.guides"),
        preference_switch<&Preferences::lock_guides>("view.lock_guides"),
        preference_switch<&Preferences::warn_of_gaps>("view.gaps"),
        {"guide.upright", may_add_guide, [](AppState& s) { add_guide(s, 0); }},
        {"guide.level", may_add_guide, [](AppState& s) { add_guide(s, 1); }},
        {"guide.clear", always, [](AppState& s) { s.aids.guides.clear(); }},
        {"view.panels", always, [](AppState& s) { s.show_panels = !s.show_panels; }, [](const AppState& s) { return !s.show_panels; }},
    };
    return handlers;
}

void load_preferences(AppState& state, const std::string& folder) {
    if (folder.empty()) return;
    state.preferences_file = PreferencesFile(folder + "/preferences.yaml");
    state.aids_folder = AidsFolder(folder + "/tables");
    state.aids = state.aids_folder.open(state.document.path());
    std::vector<std::string> complaints;
    state.preferences = state.preferences_file.read(complaints);
    if (complaints.empty()) return;
    const std::string more = complaints.size() > 1 ? fmt::format(", and {} more", complaints.size() - 1) : "";
    say(state, complaints.front() + more, true);
}

void keep_preferences(AppState& state) {
    state.aids_folder.keep(state.document.path(), state.aids);
    if (const auto why = state.preferences_file.keep(state.preferences)) say(state, *why, true);
}

}  // namespace pinfield::editor
