// The parts of the source panel: what is drawn of the text, and what keys do to it.
#pragma once
#include <string>
#include <vector>

#include "editor/panels/ui.h"

namespace pinfield::editor {

/// Something that is wrong in the text that is shown.
struct SourceMark {
    Span span;
    bool error = false;
    std::string text;  ///< with the hint
};

/// The lines in the current (scrolling) window: draws those that are seen, takes the mouse.
void source_lines(AppState& state, Ui& ui, const std::vector<SourceMark>& marks);
/// Lets the panel type: text, cursor, clipboard, undo. `page`: lines that are seen.
void source_keys(AppState& state, Ui& ui, int page);
/// Brings what the panel holds of the text up to date: its colors, and the cursor where other hands changed it.
void follow_text(const AppState& state, SourcePanel& panel);
float source_line_height(const Theme& theme);

}  // namespace pinfield::editor
