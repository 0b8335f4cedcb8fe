// Parameter edits without recompiling.
#pragma once
#include <span>

#include "engine/program/program.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

namespace pinfield {

/// One field of one node or record that took another value.
struct FieldChange {
    NodeId node;
    int field = 0;  ///< index into the node type's fields
};

/// The program of `scene`, in which these fields have just changed, given the program from before: equal to compile(scene) bit for bit.
/// Null when a change is structural (or fails to compile) and needs compile(). What several changes touch is compiled once.
ProgramPtr patch(const Program& before, const Scene& scene, std::span<const FieldChange> changes);

}  // namespace pinfield
