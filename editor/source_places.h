// Which node of a scene stands where in the text, and the other way round.
#pragma once
#include <string_view>

#include "engine/scene/scene.h"

namespace pinfield::editor {

/// The innermost node whose text holds this place; none where there is none.
NodeId node_at(const Scene& scene, const Place& place);
/// The node that a line (from 1) of the scene's main text is about: the one whose text holds its first word, dashes aside.
NodeId node_of_line(const Scene& scene, int line);

/// Lines from 1, both included.
struct LineRange {
    int first = 1, last = 0;
    bool contains(int line) const { return first <= line && line <= last; }
};
LineRange lines_of(const SourceText& text, Span span);

}  // namespace pinfield::editor
