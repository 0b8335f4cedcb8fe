// A table as a few lines: its outlines, for thumbnails and the palette. No window, no ImGui.
#pragma once
#include <vector>

#include "engine/scene/scene.h"

namespace pinfield::editor {

struct Picture {
    std::vector<std::vector<Vec2>> lines;  ///< metres
    Box2 box;                              ///< around them; empty when there are none
};

/// Outlines of all solids, of movers where they rest, of regions, and a ring where balls start. What has no end is cut off at the table's
/// edge.
Picture picture_of(const Scene& scene);
/// Of a new node of this type, without a table around it.
Picture picture_of(const std::shared_ptr<const Catalog>& catalog, const NodeType& type);

}  // namespace pinfield::editor
