// What a table that plays waits for. No window, no ImGui.
#pragma once
#include <optional>
#include <string>

#include "editor/app_state.h"

namespace pinfield::editor {

/// A hint, and where it belongs, in the world.
struct PlayHint {
    std::string text;
    Vec2 at{0, 0};
};

/// "Hold Space to shoot" beside a ball that lies still before a part that slides and has a key; else nothing.
std::optional<PlayHint> play_hint(const AppState& state);

}  // namespace pinfield::editor
