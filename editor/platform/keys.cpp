#include "editor/platform/keys.h"

#include <GLFW/glfw3.h>

#include <array>

namespace pinfield {

namespace {

struct NamedKey {
    std::string_view name;
    int code;
};

constexpr std::array named_keys = {
    NamedKey{"Space", GLFW_KEY_SPACE},
    NamedKey{"Apostrophe", GLFW_KEY_APOSTROPHE},
    NamedKey{"Comma", GLFW_KEY_COMMA},
    NamedKey{"Minus", GLFW_KEY_MINUS},
    NamedKey{"Period", GLFW_KEY_PERIOD},
    NamedKey{"Slash", GLFW_KEY_SLASH},
    NamedKey{"Semicolon", GLFW_KEY_SEMICOLON},
    NamedKey{"Equal", GLFW_KEY_EQUAL},
    NamedKey{"LeftBracket", GLFW_KEY_LEFT_BRACKET},
    NamedKey{"Backslash", GLFW_KEY_BACKSLASH},
    NamedKey{"RightBracket", GLFW_KEY_RIGHT_BRACKET},
    NamedKey{"GraveAccent", GLFW_KEY_GRAVE_ACCENT},
    NamedKey{"World1", GLFW_KEY_WORLD_1},
    NamedKey{"World2", GLFW_KEY_WORLD_2},
    NamedKey{"Escape", GLFW_KEY_ESCAPE},
    NamedKey{"Enter", GLFW_KEY_ENTER},
    NamedKey{"Tab", GLFW_KEY_TAB},
    NamedKey{"Backspace", GLFW_KEY_BACKSPACE},
    NamedKey{"Insert", GLFW_KEY_INSERT},
    NamedKey{"Delete", GLFW_KEY_DELETE},
    NamedKey{"Right", GLFW_KEY_RIGHT},
    NamedKey{"Left", GLFW_KEY_LEFT},
    NamedKey{"Down", GLFW_KEY_DOWN},
    NamedKey{"Up", GLFW_KEY_UP},
    NamedKey{"PageUp", GLFW_KEY_PAGE_UP},
    NamedKey{"PageDown", GLFW_KEY_PAGE_DOWN},
    NamedKey{"Home", GLFW_KEY_HOME},
    NamedKey{"End", GLFW_KEY_END},
    NamedKey{"CapsLock", GLFW_KEY_CAPS_LOCK},
    NamedKey{"Pause", GLFW_KEY_PAUSE},
    NamedKey{"KpDecimal", GLFW_KEY_KP_DECIMAL},
    NamedKey{"KpDivide", GLFW_KEY_KP_DIVIDE},
    NamedKey{"KpMultiply", GLFW_KEY_KP_MULTIPLY},
    NamedKey{"KpSubtract", GLFW_KEY_KP_SUBTRACT},
    NamedKey{"KpAdd", GLFW_KEY_KP_ADD},
    NamedKey{"KpEnter", GLFW_KEY_KP_ENTER},
    NamedKey{"LeftShift", GLFW_KEY_LEFT_SHIFT},
    NamedKey{"LeftControl", GLFW_KEY_LEFT_CONTROL},
    NamedKey{"LeftAlt", GLFW_KEY_LEFT_ALT},
    NamedKey{"LeftSuper", GLFW_KEY_LEFT_SUPER},
    NamedKey{"RightShift", GLFW_KEY_RIGHT_SHIFT},
    NamedKey{"RightControl", GLFW_KEY_RIGHT_CONTROL},
    NamedKey{"RightAlt", GLFW_KEY_RIGHT_ALT},
    NamedKey{"RightSuper", GLFW_KEY_RIGHT_SUPER},
    NamedKey{"Menu", GLFW_KEY_MENU},
};

constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
constexpr std::array<std::string_view, 10> digits = {"Key0", "Key1", "Key2", "Key3", "Key4",
                                                     "Key5", "Key6", "Key7", "Key8", "Key9"};
constexpr std::array<std::string_view, 10> pad_digits = {"Kp0", "Kp1", "Kp2", "Kp3", "Kp4",
                                                         "Kp5", "Kp6", "Kp7", "Kp8", "Kp9"};
constexpr std::array<std::string_view, 25> function_keys = {"F1",  "F2",  "F3",  "F4",  "F5",  "F6",  "F7",  "F8",  "F9",
                                                            "F10", "F11", "F12", "F13", "F14", "F15", "F16", "F17", "F18",
                                                            "F19", "F20", "F21", "F22", "F23", "F24", "F25"};

}  // namespace

int key_code(std::string_view name) {
    if (name.size() == 1) {
        // GLFW numbers printable keys by the ASCII of a US keyboard.
        constexpr std::string_view printable = "'-,./;=[\\]`0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ";
        return printable.find(name[0]) != std::string_view::npos ? static_cast<int>(name[0]) : -1;
    }
    for (const NamedKey& key : named_keys)
        if (key.name == name) return key.code;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (digits[i] == name) return GLFW_KEY_0 + static_cast<int>(i);
        if (pad_digits[i] == name) return GLFW_KEY_KP_0 + static_cast<int>(i);
    }
    for (std::size_t i = 0; i < function_keys.size(); ++i)
        if (function_keys[i] == name) return GLFW_KEY_F1 + static_cast<int>(i);
    return name == "Esc" ? GLFW_KEY_ESCAPE : -1;
}

std::string_view key_name(int code) {
    const auto at = [code](int first) { return static_cast<std::size_t>(code - first); };
    if (code >= GLFW_KEY_A && code <= GLFW_KEY_Z) return letters.substr(at(GLFW_KEY_A), 1);
    if (code >= GLFW_KEY_0 && code <= GLFW_KEY_9) return digits[at(GLFW_KEY_0)];
    if (code >= GLFW_KEY_KP_0 && code <= GLFW_KEY_KP_9) return pad_digits[at(GLFW_KEY_KP_0)];
    if (code >= GLFW_KEY_F1 && code <= GLFW_KEY_F25) return function_keys[at(GLFW_KEY_F1)];
    for (const NamedKey& key : named_keys)
        if (key.code == code) return key.name;
    return "";
}

}  // namespace pinfield
