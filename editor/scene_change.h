// What an edit of the text changed in the scene, for the running table.
#pragma once
#include <vector>

#include "engine/scene/scene.h"

namespace pinfield::editor {

/// What changed in the scene since somebody last asked: one field each, or everything.
struct SceneChange {
    bool everything = false;
    NodeId node;
    int field = 0;
};

/// Between two readings whose nodes go by the same ids: the fields that differ where nothing else does, else everything. Never nothing:
/// where the scenes say the same, things may stand at other places of the text.
std::vector<SceneChange> changes_between(const Scene& before, const Scene& after);

}  // namespace pinfield::editor
