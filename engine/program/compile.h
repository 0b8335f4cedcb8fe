// Scene -> Program: the one way from what people wrote to what loops run.
#pragma once
#include <tl/expected.hpp>

#include "engine/core/diagnostic.h"
#include "engine/program/program.h"
#include "engine/scene/scene.h"

namespace pinfield {

/// Compiles a scene that the reader accepted. Fails with located diagnostics (spans into the scene's text), all of them.
tl::expected<ProgramPtr, Diagnostics> compile(const Scene& scene);

}  // namespace pinfield
