// Tiles with Lipschitz pruning: a solid whose value at a tile's centre exceeds the least one there by more than both can
// change across the tile wins nowhere in it (Duff, "Interval arithmetic and recursive subdivision", 1992, and Barbier et al.,
// "Lipschitz Pruning", 2025, tell the same story for general implicit surfaces).
#include "engine/program/raster.h"

#include <algorithm>
#include <array>

#include "engine/program/evaluate.h"

namespace pinfield {
namespace {

constexpr int leaf_tile = 32;  // pixels; 32 x 32 points are one block of packets

struct Tile {
    int x, y, size;  // pixels, the top left corner
};

class Tiler {
public:
    Tiler(const Field& field, sdf::Isa isa, Raster& raster) : field_(field), isa_(isa), raster_(raster) {
        pixel_ = raster.window.size().cwiseQuotient(Vec2(raster.width, raster.height));
    }

    void run(LayerMask layers) {
        std::vector<int> all;
        for (std::size_t i = 0; i < field_.solids.size(); ++i)
            if (field_.solids[i].visible && (field_.solids[i].layers & layers)) all.push_back(static_cast<int>(i));
        int size = leaf_tile;
        while (size < std::max(raster_.width, raster_.height)) size *= 2;
        values_.resize(all.size());
        split({0, 0, size}, all);
    }

private:
    Vec2 centre_of(const Tile& tile) const {
        return {raster_.window.lo.x() + (tile.x + 0.5 * tile.size) * pixel_.x(),
                raster_.window.hi.y() - (tile.y + 0.5 * tile.size) * pixel_.y()};
    }

    /// The solids that can be nearest somewhere in the tile.
    std::vector<int> survivors(const Tile& tile, const std::vector<int>& candidates) {
        const Vec2 centre = centre_of(tile);
        const double reach = 0.5 * tile.size * length(pixel_);
        double least = infinity;  // an upper bound of the union's value anywhere in the tile
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            const Solid& solid = field_.solids[static_cast<std::size_t>(candidates[i])];
            const double lipschitz = field_.ops[static_cast<std::size_t>(solid.root)].exactness.lipschitz;
            // The box bounds the solid, so its distance bounds an exact field from below: far ones need no evaluation.
            if (lipschitz == 1 && solid.bounds.distance(centre) - reach > least) {
                values_[i] = infinity;
                continue;
            }
            const double value = evaluate_tree(field_, solid.root, centre).value;
            values_[i] = value - lipschitz * reach;
            least = std::min(least, value + lipschitz * reach);
        }
        std::vector<int> kept;
        for (std::size_t i = 0; i < candidates.size(); ++i)
            if (values_[i] <= least) kept.push_back(candidates[i]);
        return kept;
    }

    void split(const Tile& tile, const std::vector<int>& candidates) {
        if (tile.x >= raster_.width || tile.y >= raster_.height) return;
        const std::vector<int> kept = survivors(tile, candidates);
        if (tile.size == leaf_tile) return sample(tile, kept);
        const int half = tile.size / 2;
        for (const int dy : {0, half})
            for (const int dx : {0, half}) split({tile.x + dx, tile.y + dy, half}, kept);
    }

    void sample(const Tile& tile, const std::vector<int>& candidates) {
        const int w = std::min(leaf_tile, raster_.width - tile.x), h = std::min(leaf_tile, raster_.height - tile.y);
        int n = 0;
        for (int j = 0; j < h; ++j) {
            const float y = static_cast<float>(raster_.window.hi.y() - (tile.y + j + 0.5) * pixel_.y());
            for (int i = 0; i < w; ++i, ++n) {
                x_[static_cast<std::size_t>(n)] = static_cast<float>(raster_.window.lo.x() + (tile.x + i + 0.5) * pixel_.x());
                y_[static_cast<std::size_t>(n)] = y;
            }
        }
        evaluate_packets(field_, candidates, x_.data(), y_.data(), n, distance_.data(), winner_.data(), isa_);
        n = 0;
        for (int j = 0; j < h; ++j)
            for (int i = 0; i < w; ++i, ++n) {
                const std::size_t to = static_cast<std::size_t>((tile.y + j) * raster_.width + tile.x + i);
                const int solid = winner_[static_cast<std::size_t>(n)];
                raster_.distance[to] = distance_[static_cast<std::size_t>(n)];
                raster_.material[to] = solid < 0 ? std::int16_t{-1} : material_of(solid);
            }
    }

    std::int16_t material_of(int solid) const {
        const int root = field_.solids[static_cast<std::size_t>(solid)].root;
        return static_cast<std::int16_t>(field_.ops[static_cast<std::size_t>(root)].material);
    }

    const Field& field_;
    sdf::Isa isa_;
    Raster& raster_;
    Vec2 pixel_;  // metres
    std::vector<double> values_;
    std::array<float, leaf_tile * leaf_tile> x_, y_, distance_;
    std::array<int, leaf_tile * leaf_tile> winner_;
};

}  // namespace

void rasterize(const Field& field, LayerMask layers, sdf::Isa isa, Raster& raster) {
    const std::size_t pixels = static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(raster.height);
    raster.distance.resize(pixels);
    raster.material.resize(pixels);
    Tiler(field, isa, raster).run(layers);
}

void rasterize_over(const Mover& mover, const Similarity& world_from_mover, sdf::Isa isa, Raster& raster) {
    const Similarity mover_from_world = world_from_mover.inverse();
    const Vec2 pixel = raster.window.size().cwiseQuotient(Vec2(raster.width, raster.height));
    const double reach = 0.5 * leaf_tile * length(pixel);
    std::vector<int> all;
    for (std::size_t i = 0; i < mover.field.solids.size(); ++i)
        if (mover.field.solids[i].visible) all.push_back(static_cast<int>(i));
    std::array<float, leaf_tile * leaf_tile> x, y, d;
    std::array<int, leaf_tile * leaf_tile> winner;
    for (int ty = 0; ty < raster.height; ty += leaf_tile) {
        for (int tx = 0; tx < raster.width; tx += leaf_tile) {
            const int w = std::min(leaf_tile, raster.width - tx), h = std::min(leaf_tile, raster.height - ty);
            const Vec2 centre(raster.window.lo.x() + (tx + 0.5 * w) * pixel.x(), raster.window.hi.y() - (ty + 0.5 * h) * pixel.y());
            const float there = raster.distance[static_cast<std::size_t>((ty + h / 2) * raster.width + tx + w / 2)];
            // Both fields change by at most `reach` from the centre to anywhere in the tile (twice, as the pixel is not the centre).
            if (length(centre - world_from_mover.offset) - mover.lever - 2 * reach > static_cast<double>(there) + 2 * reach) continue;
            std::size_t n = 0;
            for (int j = 0; j < h; ++j)
                for (int i = 0; i < w; ++i, ++n) {
                    const Vec2 world(raster.window.lo.x() + (tx + i + 0.5) * pixel.x(), raster.window.hi.y() - (ty + j + 0.5) * pixel.y());
                    const Vec2 p = mover_from_world * world;
                    x[n] = static_cast<float>(p.x());
                    y[n] = static_cast<float>(p.y());
                }
            evaluate_packets(mover.field, all, x.data(), y.data(), static_cast<int>(n), d.data(), winner.data(), isa);
            n = 0;
            for (int j = 0; j < h; ++j)
                for (int i = 0; i < w; ++i, ++n) {
                    const std::size_t to = static_cast<std::size_t>((ty + j) * raster.width + tx + i);
                    if (!(d[n] < raster.distance[to])) continue;
                    raster.distance[to] = d[n];
                    const Solid& solid = mover.field.solids[static_cast<std::size_t>(winner[n])];
                    raster.material[to] = static_cast<std::int16_t>(mover.field.ops[static_cast<std::size_t>(solid.root)].material);
                }
        }
    }
}

}  // namespace pinfield
