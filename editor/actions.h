// Everything a user can do by name: menus, shortcuts and scripts all read this one table. No ImGui.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace pinfield::editor {

/// A key chord such as "Ctrl+Shift+Z", "F5", "." ; keys have the names of InputBinding.
struct Action {
    std::string_view name;      ///< "file.save"
    std::string_view label;     ///< "Save"
    std::string_view menu;      ///< "File"; empty: in no menu
    std::string_view shortcut;  ///< may be empty
    std::string_view doc;       ///< one line, the tooltip and the shortcut sheet
};

/// The table, in menu order.
const std::vector<Action>& all_actions();
const Action* find_action(std::string_view name);

}  // namespace pinfield::editor
