// The actions of the underlay, and the picture behind it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "editor/handlers.h"
#include "editor/lay_under.h"

namespace pinfield::editor {
namespace {

constexpr double opacity_step = 0.1;

bool has_underlay(const AppState& s) { return !s.aids.underlay.path.empty(); }
bool has_picture(const AppState& s) { return underlay_pixels(s).has_value(); }
bool may_move(const AppState& s) { return has_picture(s) && !s.aids.underlay.locked; }

void set_opacity(AppState& state, double by) {
    Underlay& underlay = state.aids.underlay;
    underlay.opacity = std::clamp(std::round(100 * (underlay.opacity + by)) / 100, least_opacity, 1.0);
    underlay.shown = true;
    say(state, fmt::format("Underlay at {:g} %", 100 * underlay.opacity));
}

void remove_underlay(AppState& state) {
    state.aids.underlay = {};
    if (state.tool == Tool::underlay) state.tool = Tool::select;
    say(state, "The underlay is gone; its file stays");
}

/// What was missing may be there by now.
void toggle_shown(AppState& state) {
    Underlay& underlay = state.aids.underlay;
    underlay.shown = !underlay.shown;
    if (underlay.shown && !state.underlay.bitmap) state.underlay = {};
}

void take_tool(AppState& state) {
    state.tool = Tool::underlay;
    state.aids.underlay.shown = true;
}

}  // namespace

std::optional<Vec2> underlay_pixels(const AppState& state) {
    if (!state.underlay.bitmap) return {};
    return Vec2(state.underlay.bitmap->width, state.underlay.bitmap->height);
}

bool lay_under(AppState& state, const std::string& path) {
    std::error_code unknown;
    const std::string whole = std::filesystem::absolute(path, unknown).lexically_normal().string();
    Result<Bitmap> picture = read_picture(whole);
    if (whole.find('\n') != std::string::npos) picture = failure("the picture's path has a line break in it: give it another name");
    if (!picture) return say(state, picture.error().message, true), false;
    state.underlay = {whole, std::make_shared<const Bitmap>(std::move(*picture))};
    state.aids.underlay = fitted_to({.path = whole}, *underlay_pixels(state), state.session.program().size);
    state.tool = Tool::underlay;
    say(state, "Click two points of the picture whose distance you know, or type its width");
    return true;
}

void follow_underlay(AppState& state) {
    const std::string& wanted = state.aids.underlay.path;
    if (wanted == state.underlay.path) return;
    state.underlay = {wanted, nullptr};
    if (wanted.empty() && state.tool == Tool::underlay) state.tool = Tool::select;
    if (wanted.empty()) return;
    Result<Bitmap> picture = read_picture(wanted);
    if (picture)
        state.underlay.bitmap = std::make_shared<const Bitmap>(std::move(*picture));
    else
        say(state, "No underlay: " + picture.error().message, true);
}

void take_dropped_file(AppState& state, const std::string& path) {
    if (!is_picture(path))
        open_file(state, path);
    else if (!asks(state))
        lay_under(state, path);
}

std::span<const Handler> underlay_handlers() {
    static constexpr Handler handlers[] = {
        {"underlay.open", always, [](AppState& s) { ask_path(s, "underlay.open"); }},
        {"tool.underlay", has_picture, take_tool, [](const AppState& s) { return s.tool == Tool::underlay; }},
        {"underlay.show", has_underlay, toggle_shown, [](const AppState& s) { return has_underlay(s) && s.aids.underlay.shown; }},
        {"underlay.lock", has_underlay, [](AppState& s) { s.aids.underlay.locked = !s.aids.underlay.locked; },
         [](const AppState& s) { return s.aids.underlay.locked; }},
        {"underlay.fainter", [](const AppState& s) { return has_picture(s) && s.aids.underlay.opacity > least_opacity; },
         [](AppState& s) { set_opacity(s, -opacity_step); }},
        {"underlay.stronger", [](const AppState& s) { return has_picture(s) && s.aids.underlay.opacity < 1; },
         [](AppState& s) { set_opacity(s, opacity_step); }},
        {"underlay.turn", may_move, [](AppState& s) { s.aids.underlay = turned_left(s.aids.underlay, *underlay_pixels(s)); }},
        {"underlay.fit", may_move,
         [](AppState& s) { s.aids.underlay = fitted_to(s.aids.underlay, *underlay_pixels(s), s.session.program().size); }},
        {"underlay.remove", has_underlay, remove_underlay},
    };
    return handlers;
}

}  // namespace pinfield::editor
