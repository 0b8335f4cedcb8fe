// The keys of a keyboard: the one table that tables are checked by, and that the window's key codes are named by.
#pragma once
#include <span>
#include <string_view>

namespace pinfield {

/// A key's name is GLFW's without prefix (Z, Key1, F5, Kp0, LeftShift, Space), its code GLFW's number, which is part of that library's
/// interface and the same on every system.
struct KeyboardKey {
    std::string_view name;
    int code;
};

/// All keys that have a name, each once.
std::span<const KeyboardKey> keyboard_keys();

/// The code behind a name, or -1. What a US keyboard prints on a key is a name too ("." for Period, "1" for Key1), and Esc for Escape.
int key_code(std::string_view name);
/// "" for a key without a name.
std::string_view key_name(int code);

}  // namespace pinfield
