#include "engine/core/keys.h"

#include <algorithm>
#include <array>

namespace pinfield {
namespace {

constexpr std::array keys{
    KeyboardKey{"Space", 32}, KeyboardKey{"Apostrophe", 39}, KeyboardKey{"Comma", 44}, KeyboardKey{"Minus", 45},
    KeyboardKey{"Period", 46}, KeyboardKey{"Slash", 47}, KeyboardKey{"Key0", 48}, KeyboardKey{"Key1", 49}, KeyboardKey{"Key2", 50},
    KeyboardKey{"Key3", 51}, KeyboardKey{"Key4", 52}, KeyboardKey{"Key5", 53}, KeyboardKey{"Key6", 54}, KeyboardKey{"Key7", 55},
    KeyboardKey{"Key8", 56}, KeyboardKey{"Key9", 57}, KeyboardKey{"Semicolon", 59}, KeyboardKey{"Equal", 61}, KeyboardKey{"A", 65},
    KeyboardKey{"B", 66}, KeyboardKey{"C", 67}, KeyboardKey{"D", 68}, KeyboardKey{"E", 69}, KeyboardKey{"F", 70}, KeyboardKey{"G", 71},
    KeyboardKey{"H", 72}, KeyboardKey{"I", 73}, KeyboardKey{"J", 74}, KeyboardKey{"K", 75}, KeyboardKey{"L", 76}, KeyboardKey{"M", 77},
    KeyboardKey{"N", 78}, KeyboardKey{"O", 79}, KeyboardKey{"P", 80}, KeyboardKey{"Q", 81}, KeyboardKey{"R", 82}, KeyboardKey{"S", 83},
    KeyboardKey{"T", 84}, KeyboardKey{"U", 85}, KeyboardKey{"V", 86}, KeyboardKey{"W", 87}, KeyboardKey{"X", 88}, KeyboardKey{"Y", 89},
    KeyboardKey{"Z", 90}, KeyboardKey{"LeftBracket", 91}, KeyboardKey{"Backslash", 92}, KeyboardKey{"RightBracket", 93},
    KeyboardKey{"GraveAccent", 96}, KeyboardKey{"World1", 161}, KeyboardKey{"World2", 162}, KeyboardKey{"Escape", 256},
    KeyboardKey{"Enter", 257}, KeyboardKey{"Tab", 258}, KeyboardKey{"Backspace", 259}, KeyboardKey{"Insert", 260},
    KeyboardKey{"Delete", 261}, KeyboardKey{"Right", 262}, KeyboardKey{"Left", 263}, KeyboardKey{"Down", 264}, KeyboardKey{"Up", 265},
    KeyboardKey{"PageUp", 266}, KeyboardKey{"PageDown", 267}, KeyboardKey{"Home", 268}, KeyboardKey{"End", 269},
    KeyboardKey{"CapsLock", 280}, KeyboardKey{"ScrollLock", 281}, KeyboardKey{"NumLock", 282}, KeyboardKey{"PrintScreen", 283},
    KeyboardKey{"Pause", 284}, KeyboardKey{"F1", 290}, KeyboardKey{"F2", 291}, KeyboardKey{"F3", 292}, KeyboardKey{"F4", 293},
    KeyboardKey{"F5", 294}, KeyboardKey{"F6", 295}, KeyboardKey{"F7", 296}, KeyboardKey{"F8", 297}, KeyboardKey{"F9", 298},
    KeyboardKey{"F10", 299}, KeyboardKey{"F11", 300}, KeyboardKey{"F12", 301}, KeyboardKey{"F13", 302}, KeyboardKey{"F14", 303},
    KeyboardKey{"F15", 304}, KeyboardKey{"F16", 305}, KeyboardKey{"F17", 306}, KeyboardKey{"F18", 307}, KeyboardKey{"F19", 308},
    KeyboardKey{"F20", 309}, KeyboardKey{"F21", 310}, KeyboardKey{"F22", 311}, KeyboardKey{"F23", 312}, KeyboardKey{"F24", 313},
    KeyboardKey{"F25", 314}, KeyboardKey{"Kp0", 320}, KeyboardKey{"Kp1", 321}, KeyboardKey{"Kp2", 322}, KeyboardKey{"Kp3", 323},
    KeyboardKey{"Kp4", 324}, KeyboardKey{"Kp5", 325}, KeyboardKey{"Kp6", 326}, KeyboardKey{"Kp7", 327}, KeyboardKey{"Kp8", 328},
    KeyboardKey{"Kp9", 329}, KeyboardKey{"KpDecimal", 330}, KeyboardKey{"KpDivide", 331}, KeyboardKey{"KpMultiply", 332},
    KeyboardKey{"KpSubtract", 333}, KeyboardKey{"KpAdd", 334}, KeyboardKey{"KpEnter", 335}, KeyboardKey{"KpEqual", 336},
    KeyboardKey{"LeftShift", 340}, KeyboardKey{"LeftControl", 341}, KeyboardKey{"LeftAlt", 342}, KeyboardKey{"LeftSuper", 343},
    KeyboardKey{"RightShift", 344}, KeyboardKey{"RightControl", 345}, KeyboardKey{"RightAlt", 346}, KeyboardKey{"RightSuper", 347},
    KeyboardKey{"Menu", 348},
};

}  // namespace

std::span<const KeyboardKey> keyboard_keys() { return keys; }

int key_code(std::string_view name) {
    // Printable keys are numbered by the ASCII of a US keyboard, letters by their capitals.
    constexpr std::string_view printable = "'-,./;=[\\]`0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ";
    if (name.size() == 1) return printable.find(name[0]) == std::string_view::npos ? -1 : static_cast<int>(name[0]);
    if (name == "Esc") name = "Escape";
    const auto found = std::find_if(keys.begin(), keys.end(), [&](const KeyboardKey& key) { return key.name == name; });
    return found == keys.end() ? -1 : found->code;
}

std::string_view key_name(int code) {
    const auto found = std::find_if(keys.begin(), keys.end(), [&](const KeyboardKey& key) { return key.code == code; });
    return found == keys.end() ? "" : found->name;
}

}  // namespace pinfield
