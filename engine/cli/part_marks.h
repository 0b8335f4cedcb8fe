// What a table does not show by itself: where balls start and drain, and how far flippers and plungers go.
#pragma once
#include <vector>

#include "engine/program/raster.h"

namespace pinfield::cli {

/// Drawn over a picture (3 bytes a pixel) of the raster's window: drains as tinted regions, spawns as rings of a ball's size with the way of
/// their first tenth of a second, movers' outlines at both end-stops.
void mark_parts(const Program& program, const Raster& picture, sdf::Isa isa, std::vector<unsigned char>& rgb);

}  // namespace pinfield::cli
