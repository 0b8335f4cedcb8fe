// Tiles with Lipschitz pruning: a solid whose value at a tile's centre exceeds the least one there by more than both
// can change across the tile wins nowhere in it (Duff, "Interval arithmetic and recursive subdivision", 1992, and
// Barbier et al., "Lipschitz Pruning", 2025, tell the same story for general implicit surfaces).
#include "engine/program/raster.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "engine/core/at.h"
#include "engine/program/drawn_solids.h"
#include "engine/program/evaluate.h"
#include "engine/program/raster_change.h"
#include "engine/program/tree.h"

namespace pinfield {
namespace {

constexpr int leaf_tile = 16;       // pixels
constexpr int leaves_a_side = 4;    // whose centres are asked together, in packets
constexpr int leaves = leaves_a_side * leaves_a_side;
constexpr int clump_tile = leaves_a_side * leaf_tile;

/// The material of a pixel whose solid is known: the same all over the solid, or decided leaf by leaf where its leaves
/// differ.
class Materials {
public:
    explicit Materials(const Field& field) : field_(field), of_solid_(field.solids.size(), mixed) {
        int first_op = 0;
        for (std::size_t i = 0; i < field.solids.size(); ++i) {
            bool found = false;
            for (int op = first_op; op <= field.solids[i].root; ++op) {
                const Op& leaf = at(field.ops, op);
                if (leaf.kernels->form != sdf::Form::shape) continue;
                of_solid_[i] = !found || of_solid_[i] == leaf.material ? leaf.material : mixed;
                if (of_solid_[i] == mixed) break;
                found = true;
            }
            first_op = field.solids[i].root + 1;
        }
    }

    /// `near`: at the surface or in the solid, where the color shows; elsewhere any leaf's will do.
    std::int16_t material(int solid, const Vec2& p, bool near) const {
        const int known = at(of_solid_, solid);
        if (known != mixed) return static_cast<std::int16_t>(known);
        const int root = at(field_.solids, solid).root;
        int leaf = root;
        if (near) evaluate_tree(field_, root, p, &leaf);
        return static_cast<std::int16_t>(at(field_.ops, leaf).material);
    }

    static constexpr int mixed = -1;
    /// The material that all of these solids are made of, or `mixed`.
    int shared_by(std::span<const PacketSolid> solids) const {
        const int first = at(of_solid_, solids[0].solid);
        const bool same = std::all_of(solids.begin(), solids.end(),
                                      [&](const PacketSolid& s) { return at(of_solid_, s.solid) == first; });
        return same ? first : mixed;
    }

private:
    const Field& field_;
    std::vector<int> of_solid_;
};

struct Tile {
    int x, y, size;  // pixels, the top left corner
};

class Tiler {
public:
    Tiler(const Field& field, sdf::Isa isa, Raster& raster)
        : field_(field), isa_(isa), raster_(raster), drawn_(field, raster.window), materials_(field) {
        pixel_ = raster.window.size().cwiseQuotient(Vec2(raster.width, raster.height));
    }

    /// `changed`: the boxes of what is new since the raster was filled; null: everything is.
    PixelBox run(LayerMask layers, const std::vector<Box2>* changed) {
        changed_ = changed;
        std::vector<int> all;
        for (std::size_t i = 0; i < field_.solids.size(); ++i)
            if (field_.solids[i].visible && (field_.solids[i].layers & layers)) all.push_back(static_cast<int>(i));
        int size = clump_tile;
        while (size < std::max(raster_.width, raster_.height)) size *= 2;
        column_x_.clear();
        for (int i = 0; i < size; ++i)
            column_x_.push_back(static_cast<float>(raster_.window.lo.x() + (i + 0.5) * pixel_.x()));
        values_.resize(all.size());
        leaf_values_.resize(all.size());
        clump_outlines_.resize(all.size());
        leaf_outlines_.resize(all.size());
        kept_ = all;
        split({0, 0, size}, 0);
        return sampled_;
    }

private:
    Vec2 centre_of(const Tile& tile) const {
        return {raster_.window.lo.x() + (tile.x + 0.5 * tile.size) * pixel_.x(),
                raster_.window.hi.y() - (tile.y + 0.5 * tile.size) * pixel_.y()};
    }

    /// Appends to kept_, of the solids listed there from `first` on, those that can be nearest somewhere in the tile.
    void keep_survivors(const Tile& tile, std::size_t first) {
        const Vec2 centre = centre_of(tile);
        const double reach = 0.5 * tile.size * length(pixel_);
        const std::size_t last = kept_.size();
        double least = infinity;  // an upper bound of the union's value anywhere in the tile
        std::size_t best = first;
        for (std::size_t i = first; i < last; ++i) {
            const Solid& solid = at(field_.solids, kept_[i]);
            const double lipschitz = drawn_.lipschitz(kept_[i]);
            // The box bounds the solid, so outside its distance bounds an exact field from below: far ones need no evaluation. In the
            // box nothing is known, the least value may lie below by any depth.
            const double outside = solid.bounds.distance(centre);
            if (drawn_.exceeds_box(kept_[i]) && outside > 0 && outside - reach > least) {
                values_[i - first] = infinity;
                continue;
            }
            const double value = drawn_.value(kept_[i], centre);
            values_[i - first] = value - lipschitz * reach;
            if (value + lipschitz * reach < least) least = value + lipschitz * reach, best = i;
        }
        // The best comes first in the tiles below too: it prunes the rest there unevaluated.
        if (last > first && values_[best - first] <= least) kept_.push_back(kept_[best]);
        for (std::size_t i = first; i < last; ++i)
            if (i != best && values_[i - first] <= least) kept_.push_back(kept_[i]);
    }

    /// `first`: where the list of the tile's candidates begins in kept_, which ends with it.
    void split(const Tile& tile, std::size_t first) {
        if (tile.x >= raster_.width || tile.y >= raster_.height) return;
        const PixelBox pixels{tile.x, tile.y, std::min(tile.x + tile.size, raster_.width), std::min(tile.y + tile.size, raster_.height)};
        if (tile.size == clump_tile && changed_ && is_out_of_reach(raster_, pixels, *changed_)) return;
        const std::size_t mine = kept_.size();
        keep_survivors(tile, first);
        if (tile.size == clump_tile) {
            sample_leaves(tile, std::span(kept_).subspan(mine));
            sampled_ = merged(sampled_, pixels);
        } else {
            const int half = tile.size / 2;
            for (const int dy : {0, half})
                for (const int dx : {0, half}) split({tile.x + dx, tile.y + dy, half}, mine);
        }
        kept_.resize(mine);
    }

    /// The leaves of a clump, and their centres as packets take them.
    struct Leaves {
        std::array<Tile, leaves> tiles;
        std::array<float, leaves> x, y;
    };
    Leaves leaves_of(const Tile& clump) const {
        Leaves out;
        for (int k = 0; k < leaves; ++k) {
            const auto i = static_cast<std::size_t>(k);
            out.tiles[i] = {clump.x + k % leaves_a_side * leaf_tile, clump.y + k / leaves_a_side * leaf_tile, leaf_tile};
            const Vec2 centre = centre_of(out.tiles[i]);
            out.x[i] = static_cast<float>(centre.x());
            out.y[i] = static_cast<float>(centre.y());
        }
        return out;
    }
    double leaf_reach() const { return 0.5 * leaf_tile * length(pixel_); }

    /// Of the union of the candidates, an upper bound of its values in each leaf; lower bounds of each candidate's
    /// own go to leaf_values_. By values at the leaves' centres.
    std::array<float, leaves> bound_values(const Tile& clump, const Leaves& in, std::span<const int> candidates) {
        // A packet's value is a float's: it may err by some roundings of the coordinates, and of itself.
        const double far = std::max(length(raster_.window.lo), length(raster_.window.hi));
        const double reach = leaf_reach(), doubt = 1e-5 * far + 1e-3 * reach;
        std::array<float, leaves> least;
        least.fill(std::numeric_limits<float>::infinity());
        const Vec2 centre = centre_of(clump);
        for (std::size_t c = 0; c < candidates.size(); ++c) {
            auto& low = leaf_values_[c];
            PacketSolid solid{candidates[c]};
            if (drawn_.by_boundary(candidates[c])) {
                keep_near(drawn_.outline(candidates[c]), centre, leaves_a_side * reach, clump_outlines_[c]);
                solid.outline = clump_outlines_[c].data();
            }
            evaluate_packets(field_, std::span(&solid, 1), in.x.data(), in.y.data(), leaves, low.data(), nullptr, isa_);
            const double lipschitz = drawn_.lipschitz(candidates[c]);
            const auto margin = static_cast<float>(lipschitz * reach + doubt);
            for (std::size_t k = 0; k < leaves; ++k) {
                least[k] = std::min(least[k], low[k] + margin);
                low[k] -= margin;
            }
        }
        return least;
    }

    /// Into near_leaf_: the candidates that can be nearest somewhere in leaf k, where none is farther than `least`.
    void keep_near_leaf(std::size_t k, const Tile& leaf, float least, std::span<const int> candidates) {
        near_leaf_.clear();
        for (std::size_t c = 0; c < candidates.size(); ++c) {
            if (!(leaf_values_[c][k] <= least)) continue;
            PacketSolid solid{candidates[c]};
            if (drawn_.by_boundary(candidates[c])) {
                OutlineBlock& outline = leaf_outlines_[near_leaf_.size()];
                keep_near(clump_outlines_[c], centre_of(leaf), leaf_reach(), outline);
                solid.outline = outline.data();
            }
            near_leaf_.push_back(solid);
        }
    }

    /// Prunes once more for every leaf of a clump, and samples them.
    void sample_leaves(const Tile& clump, std::span<const int> candidates) {
        const Leaves in = leaves_of(clump);
        const std::array<float, leaves> least = bound_values(clump, in, candidates);
        for (std::size_t k = 0; k < leaves; ++k) {
            if (in.tiles[k].x >= raster_.width || in.tiles[k].y >= raster_.height) continue;
            keep_near_leaf(k, in.tiles[k], least[k], candidates);
            sample(in.tiles[k], k / leaves_a_side * leaf_tile * clump_tile + k % leaves_a_side * leaf_tile, near_leaf_);
        }
        write_clump(clump);
    }

    /// `at`: where the leaf's first pixel stands in the clump's. Pixels beyond the picture's edges are sampled too.
    void sample(const Tile& leaf, std::size_t at, std::span<const PacketSolid> candidates) {
        for (int j = 0; j < leaf_tile; ++j) {
            std::memcpy(x_.data() + j * leaf_tile, column_x_.data() + leaf.x, leaf_tile * sizeof(float));
            std::fill_n(y_.begin() + j * leaf_tile, leaf_tile,
                        static_cast<float>(raster_.window.hi.y() - (leaf.y + j + 0.5) * pixel_.y()));
        }
        const int uniform = candidates.empty() ? -1 : materials_.shared_by(candidates);
        const bool is_uniform = uniform != Materials::mixed || candidates.empty();
        evaluate_packets(field_, candidates, x_.data(), y_.data(), leaf_tile * leaf_tile, distance_.data(),
                         is_uniform ? nullptr : winner_.data(), isa_);
        for (std::size_t j = 0; j < leaf_tile; ++j) {
            std::memcpy(clump_distance_.data() + at + j * clump_tile, distance_.data() + j * leaf_tile, leaf_tile * sizeof(float));
            std::int16_t* material = clump_material_.data() + at + j * clump_tile;
            if (is_uniform)
                std::fill_n(material, leaf_tile, static_cast<std::int16_t>(uniform));
            else
                write_materials(j * leaf_tile, material);
        }
    }

    void write_materials(std::size_t first, std::int16_t* to) const {
        const double near = 2 * length(pixel_);
        for (std::size_t k = first; k < first + leaf_tile; ++k) {
            const Vec2 p(static_cast<double>(x_[k]), static_cast<double>(y_[k]));
            *to++ = materials_.material(winner_[k], p, static_cast<double>(distance_[k]) < near);
        }
    }

    /// Into the picture: whole stretches of its rows at once, which lie kilobytes apart.
    void write_clump(const Tile& clump) {
        const int w = std::min(clump_tile, raster_.width - clump.x), h = std::min(clump_tile, raster_.height - clump.y);
        for (int j = 0; j < h; ++j) {
            const std::ptrdiff_t to = static_cast<std::ptrdiff_t>(clump.y + j) * raster_.width + clump.x;
            std::copy_n(clump_distance_.begin() + j * clump_tile, w, raster_.distance.begin() + to);
            std::copy_n(clump_material_.begin() + j * clump_tile, w, raster_.material.begin() + to);
        }
    }

    static PixelBox merged(const PixelBox& a, const PixelBox& b) {
        if (a.left >= a.right) return b;
        return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right), std::max(a.bottom, b.bottom)};
    }

    const Field& field_;
    sdf::Isa isa_;
    Raster& raster_;
    const std::vector<Box2>* changed_ = nullptr;
    PixelBox sampled_;
    DrawnSolids drawn_;
    Materials materials_;
    Vec2 pixel_;  // metres
    std::vector<int> kept_;  // solids: the lists of the tiles on the way down, one behind the other
    std::vector<double> values_;
    std::vector<std::array<float, leaves>> leaf_values_;
    std::vector<OutlineBlock> clump_outlines_, leaf_outlines_;
    std::vector<PacketSolid> near_leaf_;
    std::vector<float> column_x_;
    std::array<float, leaf_tile * leaf_tile> x_, y_, distance_;
    std::array<int, leaf_tile * leaf_tile> winner_;
    std::array<float, clump_tile * clump_tile> clump_distance_;
    std::array<std::int16_t, clump_tile * clump_tile> clump_material_;
};

}  // namespace

void rasterize(const Field& field, LayerMask layers, sdf::Isa isa, Raster& raster) {
    const std::size_t pixels = static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(raster.height);
    raster.distance.resize(pixels);
    raster.material.resize(pixels);
    Tiler(field, isa, raster).run(layers, nullptr);
}

PixelBox rasterize_changes(const Field& before, const Field& field, LayerMask layers, sdf::Isa isa, Raster& raster) {
    if (const auto changed = changed_boxes(before, field)) return Tiler(field, isa, raster).run(layers, &*changed);
    rasterize(field, layers, isa, raster);
    return {0, 0, raster.width, raster.height};
}

void rasterize_over(const Mover& mover, const Similarity& world_from_mover, sdf::Isa isa, Raster& raster) {
    const Similarity mover_from_world = world_from_mover.inverse();
    const Vec2 pixel = raster.window.size().cwiseQuotient(Vec2(raster.width, raster.height));
    const double reach = 0.5 * leaf_tile * length(pixel);
    const DrawnSolids drawn(mover.field, Box2::centred(mover.bounding_radius, mover.bounding_radius).grown(reach));
    std::vector<PacketSolid> all;
    for (int i = 0; i < static_cast<int>(mover.field.solids.size()); ++i)
        if (at(mover.field.solids, i).visible)
            all.push_back({i, drawn.by_boundary(i) ? drawn.outline(i).data() : nullptr});
    const Materials materials(mover.field);
    std::array<float, leaf_tile * leaf_tile> x, y, d;
    std::array<int, leaf_tile * leaf_tile> winner;
    for (int ty = 0; ty < raster.height; ty += leaf_tile) {
        for (int tx = 0; tx < raster.width; tx += leaf_tile) {
            const int w = std::min(leaf_tile, raster.width - tx), h = std::min(leaf_tile, raster.height - ty);
            const Vec2 centre(raster.window.lo.x() + (tx + 0.5 * w) * pixel.x(),
                              raster.window.hi.y() - (ty + 0.5 * h) * pixel.y());
            const float there = at(raster.distance, (ty + h / 2) * raster.width + tx + w / 2);
            // Both fields change by at most `reach` from the centre to anywhere in the tile (twice, as the pixel is not
            // the centre).
            if (length(centre - world_from_mover.offset) - mover.bounding_radius - 2 * reach >
                static_cast<double>(there) + 2 * reach)
                continue;
            std::size_t n = 0;
            for (int j = 0; j < h; ++j)
                for (int i = 0; i < w; ++i, ++n) {
                    const Vec2 world(raster.window.lo.x() + (tx + i + 0.5) * pixel.x(),
                                     raster.window.hi.y() - (ty + j + 0.5) * pixel.y());
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
                    const Vec2 p(static_cast<double>(x[n]), static_cast<double>(y[n]));
                    raster.material[to] = materials.material(winner[n], p, static_cast<double>(d[n]) < 2 * length(pixel));
                }
        }
    }
}

}  // namespace pinfield
