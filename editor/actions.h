// Everything a user can do by name: menus, shortcuts and scripts all read this one table. No ImGui.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace pinfield::editor {

/// A shortcut is a chord such as "Ctrl+Shift+Z", "F5" or ".": a key by its name as in a table's inputs, or by the character on it.
struct Action {
    std::string_view name;      ///< "file.save"
    std::string_view label;     ///< "Save"
    std::string_view menu;      ///< "File"; empty: in no menu
    std::string_view shortcut;  ///< may be empty
    std::string_view doc;       ///< one line, the tooltip and the shortcut sheet
    bool repeats = false;       ///< again and again while its key is held
};

/// The table, in menu order.
const std::vector<Action>& all_actions();
const Action* find_action(std::string_view name);
/// The action of a chord, or null.
const Action* action_of(std::string_view shortcut);

}  // namespace pinfield::editor
