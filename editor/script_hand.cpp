// The steps of a script that a hand does, through the window's own mouse and keys: each event is seen by a frame of its own.
#include <fmt/format.h>

#include <cmath>

#include "editor/script.h"
#include "engine/core/numbers.h"

namespace pinfield::editor {
namespace {

constexpr int drag_frames = 12;
constexpr int frames_between_clicks = 24;  ///< more than a double click allows
constexpr double double_click_pixels = 8;

int number_of(const std::string& button) { return button == "left" ? 0 : button == "right" ? 1 : 2; }

/// One code point of a UTF-8 text from byte `i` on; moves `i` behind it.
unsigned next_character(const std::string& text, std::size_t& i) {
    const auto byte = [&](std::size_t at) { return at < text.size() ? static_cast<unsigned char>(text[at]) : 0u; };
    const unsigned first = byte(i++);
    const int more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : 0;
    unsigned out = more == 0 ? first : first & (0x3fu >> more);
    for (int k = 0; k < more; ++k) out = out << 6 | (byte(i++) & 0x3fu);
    return out;
}

}  // namespace

ScriptRunner::Frame ScriptRunner::run_hand(const ScriptStep& step, const AppState& state, ScriptHost& host) {
    using Kind = ScriptStep::Kind;
    if (step.kind == Kind::click) return run_click(step, state, host);
    if (step.kind == Kind::drag) return run_drag(step, state, host);
    if (step.kind == Kind::scroll) return run_scroll(step, state, host);
    return step.kind == Kind::type ? run_type(step, host) : run_key(step, host);
}

bool ScriptRunner::find(const ScriptPoint& point, const AppState& state, const ScriptHost& host, Vec2& pixel) {
    if (!point.place) {
        const std::optional<Vec2> found = host.find_words(point.words, point.panel);
        if (!found) {
            const std::string where = point.panel.empty() ? "on the screen" : "in the " + point.panel;
            return fail(fmt::format("nothing {} reads \"{}\"", where, point.words)), false;
        }
        pixel = *found;
        return true;
    }
    pixel = state.view.pixel_from_world(*point.place);
    if (Box2{state.view.origin, state.view.origin + state.view.size}.contains(pixel)) return true;
    return fail(fmt::format("[{}, {}] is not in the viewport", to_text(point.place->x()), to_text(point.place->y()))), false;
}

bool ScriptRunner::hold(const ScriptStep& step, ScriptHost& host, bool down) {
    for (const std::string& key : step.with)
        if (!host.press_key(key, down))
            return fail(fmt::format("there is no key {}; keys are named as in inputs: Z, Space, LeftShift", key)), false;
    return true;
}

/// Hover, then press and release as often as is wanted.
ScriptRunner::Frame ScriptRunner::run_click(const ScriptStep& step, const AppState& state, ScriptHost& host) {
    if (frame_ == 0) {
        if (!find(step.from, state, host, from_)) return {};
        const bool near = length(from_ - clicked_) < double_click_pixels;
        if (near && frames_since_click_ < frames_between_clicks) {
            frame_ = -1;  // counted as the first frame once more
            return 0;
        }
        if (!hold(step, host, true)) return {};
        host.move_mouse(from_);
        return host.ticks_per_frame();
    }
    const int half = frame_ - 1, halves = 2 * step.times;
    if (half < halves) host.press_mouse(number_of(step.button), half % 2 == 0);
    if (half == halves) hold(step, host, false);
    if (half < halves + 2) return host.ticks_per_frame();
    clicked_ = from_;
    frames_since_click_ = 0;
    return {};
}

/// Hover, press, move, rest, release.
ScriptRunner::Frame ScriptRunner::run_drag(const ScriptStep& step, const AppState& state, ScriptHost& host) {
    if (frame_ == 0) {
        if (!find(step.from, state, host, from_) || !find(step.to, state, host, to_) || !hold(step, host, true)) return {};
        host.move_mouse(from_);
        return host.ticks_per_frame();
    }
    const int moves = frame_ - 1;
    if (moves == 0)
        host.press_mouse(number_of(step.button), true);
    else if (moves <= drag_frames)
        host.move_mouse(from_ + static_cast<double>(moves) / drag_frames * (to_ - from_));
    else if (moves == drag_frames + 2)
        host.press_mouse(number_of(step.button), false);
    else if (moves == drag_frames + 4)
        hold(step, host, false);
    else if (moves == drag_frames + 5)
        return {};
    return host.ticks_per_frame();
}

ScriptRunner::Frame ScriptRunner::run_scroll(const ScriptStep& step, const AppState& state, ScriptHost& host) {
    if (frame_ == 0) {
        if (!find(step.from, state, host, from_) || !hold(step, host, true)) return {};
        host.move_mouse(from_);
        return host.ticks_per_frame();
    }
    const int notches = static_cast<int>(std::ceil(std::fabs(step.by)));
    if (frame_ <= notches)
        host.scroll(step.by / notches);
    else if (frame_ == notches + 1)
        hold(step, host, false);
    else
        return {};
    return host.ticks_per_frame();
}

ScriptRunner::Frame ScriptRunner::run_type(const ScriptStep& step, ScriptHost& host) {
    std::size_t i = 0;
    for (int skipped = 0; skipped < frame_ && i < step.value.size(); ++skipped) next_character(step.value, i);
    if (i >= step.value.size()) return {};
    host.type(next_character(step.value, i));
    return host.ticks_per_frame();
}

/// The frame after the release takes no ticks: it only lets the window see it.
ScriptRunner::Frame ScriptRunner::run_key(const ScriptStep& step, ScriptHost& host) {
    if (frame_ == 0) {
        if (!hold(step, host, true)) return {};
        if (!host.press_key(step.name, true))
            return fail(fmt::format("there is no key {}; keys are named as in inputs: Z, Space, LeftShift", step.name));
    }
    if (const Frame frame = run_wait(std::max(step.ticks, 1), host)) return frame;
    if (std::exchange(released_, !released_)) return {};
    host.press_key(step.name, false);
    hold(step, host, false);
    return 0;
}

}  // namespace pinfield::editor
