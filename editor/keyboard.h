// What a key means: to the table, or as the chord of an action. No window, no ImGui.
#pragma once
#include <functional>
#include <string_view>

#include "editor/app_state.h"

namespace pinfield::editor {

struct KeyPress {
    std::string_view key;  ///< its name, as in a table's inputs
    bool down = false;
    bool repeat = false;   ///< it has been down for a while and counts once more
};

class Keyboard {
public:
    /// `typing`: a text field has the keyboard, and leaves only chords with Ctrl. `cancel_drag`: ends a drag where there is one, and
    /// says so. A held key repeats the action that it ran, where that is one of those that repeat; never more.
    void take(AppState& state, const KeyPress& press, bool typing, const std::function<bool()>& cancel_drag);

private:
    void note_modifier(const KeyPress& press);
    const Action* chord_of(std::string_view key) const;

    bool control_ = false, shift_ = false, alt_ = false;
    const Action* ran_ = nullptr;  ///< by the key that went down last
};

}  // namespace pinfield::editor
