// Names of keys: GLFW's without prefix (Z, Slash, LeftShift, Space, Key1), as tables and shortcuts write them.
#pragma once
#include <string_view>

namespace pinfield {

/// GLFW key code, or -1. Also takes the character on a key ("." for Period, "1" for Key1) and "Esc".
int key_code(std::string_view name);
/// "" for a key without a name.
std::string_view key_name(int code);

}  // namespace pinfield
