// The user's preferences, read at the start and kept while they change.
#pragma once
#include <string>

#include "editor/app_state.h"

namespace pinfield::editor {

/// From now on the preferences are those of a folder's file, and kept there. What cannot be understood in it is said.
void load_preferences(AppState& state, const std::string& folder);
/// Writes what changed, or says why it cannot: now and then.
void keep_preferences(AppState& state);

}  // namespace pinfield::editor
