#include "editor/keyboard.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace pinfield::editor {
namespace {

/// Actions name punctuation keys by the character on them.
std::string character_of(std::string_view key) {
    static constexpr std::pair<std::string_view, char> keys[] = {
        {"Period", '.'}, {"Comma", ','}, {"Slash", '/'}, {"Minus", '-'}, {"Equal", '='}, {"Semicolon", ';'},
        {"LeftBracket", '['}, {"RightBracket", ']'}, {"Apostrophe", '\''}, {"Backslash", '\\'}, {"GraveAccent", '`'}};
    for (const auto& [name, character] : keys)
        if (name == key) return std::string(1, character);
    if (key.starts_with("Key") && key.size() == 4) return std::string(key.substr(3));
    return key == "Escape" ? "Esc" : std::string(key);
}

/// F1 to F12, which no text takes.
bool is_function_key(std::string_view key) { return key.size() > 1 && key[0] == 'F' && key[1] >= '1' && key[1] <= '9'; }

/// Keys that with Ctrl are the text's in which somebody types.
bool edits_text(std::string_view key) {
    static constexpr std::string_view keys[] = {"A",     "C",  "V",    "X",    "Y",   "Z",         "Left",
                                                "Right", "Up", "Down", "Home", "End", "Backspace", "Delete"};
    return std::find(std::begin(keys), std::end(keys), key) != std::end(keys);
}

}  // namespace

void Keyboard::note_modifier(const KeyPress& press) {
    if (press.key == "LeftControl" || press.key == "RightControl") control_ = press.down;
    if (press.key == "LeftShift" || press.key == "RightShift") shift_ = press.down;
    if (press.key == "LeftAlt" || press.key == "RightAlt") alt_ = press.down;
}

const Action* Keyboard::chord_of(std::string_view key) const {
    std::string chord = control_ ? "Ctrl+" : "";
    if (alt_) chord += "Alt+";
    if (shift_) chord += "Shift+";
    const Action* action = action_of(chord + character_of(key));
    return action ? action : action_of(chord + std::string(key));
}

void Keyboard::take(AppState& state, const KeyPress& press, bool typing, const std::function<bool()>& cancel_drag) {
    note_modifier(press);
    const Action* const ran = press.down ? std::exchange(ran_, nullptr) : ran_;
    if (!press.down) {
        press_key(state, press.key, false);  // a key let go is let go, whoever has the keyboard by now
        return;
    }
    if (asks(state)) return;
    const bool plain = !control_ && !alt_;
    const bool is_text = plain ? !is_function_key(press.key) : !control_ || edits_text(press.key);
    if (typing && is_text) return;
    // The table's own keys come first: a game is to be played with whatever keys its author chose.
    if (plain && is_table_key(state, press.key)) {
        if (!press.repeat) press_key(state, press.key, true);
        return;
    }
    const Action* const action = chord_of(press.key);
    if (!action || (press.repeat && (action != ran || !action->repeats))) return;
    // During a drag, Esc and undo take the drag back and nothing more.
    if (action->name.starts_with("edit.") && cancel_drag()) return;
    ran_ = action;
    if (enabled(state, action->name)) run(state, action->name);
}

}  // namespace pinfield::editor
