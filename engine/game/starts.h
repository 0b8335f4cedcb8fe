// Balls that cannot start where a table has them start: for `check`, the editor's problems, and tests.
#pragma once
#include <optional>

#include "engine/core/diagnostic.h"
#include "engine/program/program.h"
#include "engine/scene/scene.h"

namespace pinfield {

/// What keeps a ball from starting at a place of the table at rest, said at `where` with a hint where it could; or nothing. All of
/// them are warnings: the table runs, and the ball is held back.
std::optional<Diagnostic> impossible_start(const Program& program, const Scene& scene, const Vec2& at, LayerMask layers, Place where);

/// All that is doubtful about a table that runs: warnings_of() its program, and starts of spawns and tests that are impossible.
Diagnostics doubts_of(const Program& program, const Scene& scene);

}  // namespace pinfield
