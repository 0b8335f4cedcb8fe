// A parameter edit without recompiling.
#pragma once
#include "engine/program/program.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

namespace pinfield {

/// The program of `scene`, in which one field of `node` has just changed, given the program from before: equal to compile(scene)
/// bit for bit. Null when the edit is structural (or fails to compile) and needs compile().
ProgramPtr patch(const Program& before, const Scene& scene, NodeId node, int field);

}  // namespace pinfield
