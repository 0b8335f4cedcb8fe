// The picture of a node's example, as `pinfield render --mode isolines` draws it.
#pragma once
#include <memory>
#include <string>

#include "engine/core/result.h"
#include "engine/reflect/catalog.h"

namespace pinfield::conformance {

/// Draws a square table from its file into a PNG.
Result<bool> draw_example(const std::string& scene_path, const std::shared_ptr<const Catalog>& catalog, const std::string& png_path);

}  // namespace pinfield::conformance
