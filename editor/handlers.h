// What stands behind the table of actions: when each can run, and what it does. Files that do things have a list of their own.
#pragma once
#include <span>
#include <string_view>

#include "editor/app_state.h"

namespace pinfield::editor {

struct Handler {
    std::string_view action;
    bool (*enabled)(const AppState&);
    void (*run)(AppState&);
    bool (*on)(const AppState&) = nullptr;  ///< of a switch: whether it is on
};

inline bool always(const AppState&) { return true; }
inline bool has_selection(const AppState& s) { return !s.selection.empty() && !s.document.previewing(); }

/// What is done to selected nodes, and what is selected: edit_actions.cpp.
std::span<const Handler> edit_handlers();
/// Tools, alignment, mirroring: arrange.cpp.
std::span<const Handler> arrange_handlers();
/// The file and the document made one again: follow_disk.cpp.
std::span<const Handler> merge_handlers();
/// How the editor looks and works, and what it shows: preference_actions.cpp.
std::span<const Handler> preference_handlers();
/// Values that stand elsewhere in the text: home_actions.cpp.
std::span<const Handler> home_handlers();
/// Takes what was made of the text, and says so, or why not.
bool take_patched(AppState& state, Result<PatchedText> patched, const std::string& label);
/// Asks where to write what was refused for that alone, unless something else is asked.
void ask_for_home(AppState& state);
/// The picture beneath the table: underlay_actions.cpp.
std::span<const Handler> underlay_handlers();

}  // namespace pinfield::editor
