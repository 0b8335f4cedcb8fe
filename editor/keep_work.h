// Work that outlives the editor: kept while it is unsaved, offered at the next start.
#pragma once
#include <string>

#include "editor/app_state.h"

namespace pinfield::editor {

/// From now on unsaved work is kept in a folder of journals (empty: there is none, which is said once there is work), and what died editors
/// left there is offered; of other tables it is said that there is some.
void keep_work(AppState& state, const std::string& folder);
/// Writes what changed since it was called last: once a frame.
void keep_safe(AppState& state);

/// Offers what died editors left of this document.
void offer_work(AppState& state);
// The answers.
void restore_work(AppState& state);
void discard_work(AppState& state);
void put_work_off(AppState& state);

}  // namespace pinfield::editor
