// What an edit changes of a picture: mostly little, so that a drag need not sample all of it again.
#pragma once
#include <optional>
#include <vector>

#include "engine/program/program.h"
#include "engine/program/raster.h"

namespace pinfield {

/// Boxes around the visible solids in which two fields differ, before and after. Nothing where the fields differ in more than their
/// solids' values, or where a solid's distance may be less than that to its box: then any pixel may have changed.
std::optional<std::vector<Box2>> changed_boxes(const Field& before, const Field& after);

/// Does a solid in one of the boxes never come nearer than what the raster holds, anywhere in these pixels (a margin included)?
bool is_out_of_reach(const Raster& raster, const PixelBox& pixels, const std::vector<Box2>& boxes);

}  // namespace pinfield
