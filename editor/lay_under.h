// Laying a picture under the table, and keeping what is shown to what the table's aids say.
#pragma once
#include <optional>
#include <string>

#include "editor/app_state.h"

namespace pinfield::editor {

/// This picture from now on, all of it within the table, with the tool to bring it to size; or a word why not. Whether it was taken.
bool lay_under(AppState& state, const std::string& path);
/// Reads the picture that the table's aids name, where that is another than the one that was read; once a frame. One that cannot be read
/// is said, and stays with the table: it may be back the next time.
void follow_underlay(AppState& state);
/// The picture's size; none where there is none to be seen.
std::optional<Vec2> underlay_pixels(const AppState& state);
/// A file that was dropped onto the window: a picture goes under the table, all else is opened as a table.
void take_dropped_file(AppState& state, const std::string& path);

}  // namespace pinfield::editor
