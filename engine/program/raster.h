// The Program's field sampled into an image: what the editor and `pinfield render` color.
#pragma once
#include <vector>

#include "engine/program/program.h"

namespace pinfield {

/// width * height samples at pixel centres, row 0 at the top (largest y).
struct Raster {
    int width = 0, height = 0;
    Box2 window;                    ///< world, metres
    std::vector<float> distance;    ///< metres: the least of the solids' distances, each the true one where its boundary is known
    std::vector<std::int16_t> material;  ///< of the winning solid's leaf; -1 where nothing is in reach

    double metres_per_pixel() const { return window.size().x() / width; }
};

/// Pixels from left and top to right and bottom, those not included.
struct PixelBox {
    int left = 0, top = 0, right = 0, bottom = 0;
};

/// Samples the visible solids of a field. Quadtree over tiles: a tile keeps only solids that can win somewhere in it
/// (Lipschitz pruning), so most pixels evaluate one or two.
void rasterize(const Field& field, LayerMask layers, sdf::Isa isa, Raster& raster);

/// The same where the raster holds `before`, with the same layers: samples again only tiles that may have changed. Returns what encloses
/// them.
PixelBox rasterize_changes(const Field& before, const Field& field, LayerMask layers, sdf::Isa isa, Raster& raster);

/// Lays a mover, at its present place, over a raster of the static field (minimum of both).
void rasterize_over(const Mover& mover, const Similarity& world_from_mover, sdf::Isa isa, Raster& raster);

/// Its colors: 3 bytes a pixel, row 0 at the top.
std::vector<unsigned char> shaded_picture(const Raster& raster, const Program& program);
/// The distances themselves, in the colors of isolines.h; `spacing` in metres.
std::vector<unsigned char> isoline_picture(const Raster& raster, double spacing);

}  // namespace pinfield
