// What is said where a path is asked for: by this window and by the desktop's own. No window, no ImGui.
#pragma once
#include <string>
#include <string_view>

namespace pinfield::editor {

struct PathQuestion {
    std::string_view action;  ///< that the path is for
    const char* title;        ///< "Open a table"
    const char* answer;       ///< the button's: "Open"
    const char* files;        ///< "Tables"
    const char* patterns;     ///< of their names: "*.yaml *.yml"
    const char* none;         ///< where a folder has none
    bool saves = false;       ///< the file may be a new one
};

/// That of an action which asks for one.
const PathQuestion& path_question(std::string_view action);

/// Whether a file is one of those that are asked for, by its name.
bool is_wanted(const PathQuestion& question, std::string_view name);

}  // namespace pinfield::editor
