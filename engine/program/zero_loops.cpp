#include "engine/program/zero_loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "engine/core/at.h"
#include "engine/program/evaluate.h"
#include "engine/program/gradient_fan.h"
#include "engine/program/tree.h"

namespace pinfield {
namespace {

constexpr double zero = 1e-11;    // in sizes of the solid: far below what tracing promises, far above rounding
constexpr double flattest = 1e-6;  // slope of a field that still has a direction: bounds are flatter than distances by factors, not millions
constexpr double half_diagonal = 0.7072;  // of a square, rounded up
/// Across the window: the largest cells that are linked, and as small as they get where something may hide: so small a share of the window,
/// and no more than what matters to a ball, metres. (However far one point of a path lies, balls meet what is near.)
constexpr int coarsest = 128, least_finest = 8192, most_finest = 1 << 26;
constexpr double matters = 1e-4;
/// Tables take a few thousand; shapes that abut under a blend, along whose seam nothing is certain, up to 50 000. Beyond, a solid stays a tree.
constexpr int most_cells = 150000;

/// A node of the finest lattice; its row comes first in order.
struct LatticeNode {
    int i = 0, j = 0;
    auto operator<=>(const LatticeNode& b) const { return j != b.j ? j <=> b.j : i <=> b.i; }
    bool operator==(const LatticeNode&) const = default;
};

struct HashOfNode {
    std::size_t operator()(const LatticeNode& node) const {
        return (static_cast<std::size_t>(static_cast<unsigned>(node.j)) << 32 | static_cast<unsigned>(node.i)) * 0x9E3779B97F4A7C15u >> 20;
    }
};

/// From its left or lower end to the other, with no node between.
struct LatticeEdge {
    LatticeNode from, to;
    auto operator<=>(const LatticeEdge&) const = default;
};

struct Cell {
    int i = 0, j = 0, size = 1;
};

/// Walks the cells that the line crosses (Lorensen and Cline, "Marching cubes", 1987, in the plane) and links their edges. Cells are as small
/// as it takes to be sure that the line runs through each at most once (a quadtree, as Keeter, "Massively parallel rendering of complex
/// closed-form implicit surfaces", 2020, prunes one); one that has smaller neighbours has their nodes on its sides, too.
class Lattice {
public:
    Lattice(const Field& field, int op, const Box2& window)
        : field_(field), op_(op), fans_(field), origin_(window.lo), size_(window.size().maxCoeff()),
          lipschitz_(at(field.ops, op).exactness.lipschitz) {
        while (finest_ < most_finest && size_ / finest_ > matters) finest_ *= 2;
        step_ = size_ / finest_;
    }

    /// False when there is too much that may hide something.
    bool link_cells() {
        if (!visit({0, 0, finest_})) return false;
        for (bool again = true; again;) {
            again = false;
            for (const Cell& cell : std::exchange(cells_, {})) {
                if (cell.size == 1 || leaving(ring_of(cell)) < 2) {
                    cells_.push_back(cell);
                    continue;
                }
                again = true;
                if (!split(cell)) return false;
            }
        }
        for (const Cell& cell : cells_) link(cell);
        return true;
    }

    std::optional<ZeroLoops> loops() {
        ZeroLoops out{.loops = {}, .complete = complete_};
        while (!next_.empty()) {
            std::vector<ZeroPoint> loop;
            const LatticeEdge first = next_.begin()->first;
            LatticeEdge edge = first;
            do {
                const auto link = next_.find(edge);
                if (link == next_.end()) return std::nullopt;  // it ran out of the window
                const std::optional<ZeroPoint> point = crossing(edge);
                if (!point) return std::nullopt;
                loop.push_back(*point);
                edge = link->second;
                next_.erase(link);
            } while (!(edge == first));
            out.loops.push_back(std::move(loop));
        }
        return out;
    }

private:
    Vec2 place(double i, double j) const { return origin_ + step_ * Vec2(i, j); }
    Vec2 place(const LatticeNode& node) const { return place(node.i, node.j); }
    Vec2 middle_of(const Cell& cell) const { return place(cell.i + 0.5 * cell.size, cell.j + 0.5 * cell.size); }

    double value(const LatticeNode& node) {
        const auto [known, is_new] = values_.try_emplace(node, 0.0);
        if (is_new) known->second = tree_value(field_, op_, place(node));
        return known->second;
    }
    bool is_solid(const LatticeNode& node) { return value(node) < 0; }

    /// Down to cells that the line cannot reach, or runs through once.
    bool visit(const Cell& cell) {
        const double radius = half_diagonal * cell.size * step_;
        if (std::fabs(tree_value(field_, op_, middle_of(cell))) > lipschitz_ * radius) return true;
        if (cell.size > finest_ / coarsest) return visit_quarters(cell);
        if (++visited_ > most_cells) return false;
        if (fans_.fan(op_, middle_of(cell), radius).is_wide()) {
            if (cell.size > 1) return split(cell);
            complete_ = false;
        }
        cells_.push_back(cell);
        return true;
    }
    bool visit_quarters(const Cell& cell) {
        const int half = cell.size / 2, i = cell.i, j = cell.j;
        const std::array<Cell, 4> quarters{Cell{i, j, half}, {i + half, j, half}, {i, j + half, half}, {i + half, j + half, half}};
        return std::all_of(quarters.begin(), quarters.end(), [&](const Cell& quarter) { return visit(quarter); });
    }
    /// Its neighbours get nodes on their sides.
    bool split(const Cell& cell) {
        const int half = cell.size / 2;
        for (const int i : {0, half, cell.size})
            for (const int j : {0, half, cell.size}) nodes_.insert({cell.i + i, cell.j + j});
        return visit_quarters(cell);
    }

    /// All nodes on a cell's sides, counter-clockwise.
    std::vector<LatticeNode> ring_of(const Cell& cell) const {
        const int far_i = cell.i + cell.size, far_j = cell.j + cell.size;
        const std::array<LatticeNode, 5> corners{LatticeNode{cell.i, cell.j}, {far_i, cell.j}, {far_i, far_j}, {cell.i, far_j}, {cell.i, cell.j}};
        std::vector<LatticeNode> ring;
        for (std::size_t k = 0; k < 4; ++k) add_side(corners[k], corners[k + 1], ring);
        return ring;
    }
    /// Without its end.
    void add_side(const LatticeNode& from, const LatticeNode& to, std::vector<LatticeNode>& ring) const {
        const LatticeNode middle{(from.i + to.i) / 2, (from.j + to.j) / 2};
        const bool has_middle = std::abs(to.i - from.i) + std::abs(to.j - from.j) > 1 && nodes_.contains(middle);
        if (!has_middle) return ring.push_back(from);
        add_side(from, middle, ring);
        add_side(middle, to, ring);
    }

    /// How often the solid ends, walking round.
    int leaving(const std::vector<LatticeNode>& ring) {
        int out = 0;
        for (std::size_t k = 0; k < ring.size(); ++k) out += is_solid(ring[k]) && !is_solid(ring[(k + 1) % ring.size()]);
        return out;
    }

    void link(const Cell& cell) {
        const std::vector<LatticeNode> ring = ring_of(cell);
        const std::size_t n = ring.size();
        const auto after = [&](std::size_t k) -> const LatticeNode& { return k + 1 < n ? ring[k + 1] : ring.front(); };
        std::vector<std::size_t> ends, begins;  // edges on which the solid ends and begins, in turns
        for (std::size_t k = 0; k < n; ++k) {
            const bool here = is_solid(ring[k]), there = is_solid(after(k));
            if (here && !there) ends.push_back(k);
            if (!here && there) begins.push_back(k);
        }
        if (ends.empty()) return;
        const auto edge = [&](std::size_t k) {
            const LatticeNode &a = ring[k], &b = after(k);
            return a < b ? LatticeEdge{a, b} : LatticeEdge{b, a};
        };
        // The line comes in where the solid ends. A saddle: where the middle is solid it cuts off what is not, and the other way round.
        const bool begins_first = begins[0] < ends[0];
        const bool cuts_off_gaps = ends.size() > 1 && tree_value(field_, op_, middle_of(cell)) < 0;
        for (std::size_t k = 0; k < ends.size(); ++k) {
            const std::size_t behind = begins_first ? k + 1 : k, before = begins_first ? k : k + ends.size() - 1;
            next_[edge(ends[k])] = edge(begins[(cuts_off_gaps ? behind : before) % ends.size()]);
        }
    }

    /// Between the two nodes of an edge, which lie on either side: false position in its Illinois form. Where the field bends so sharply
    /// that it creeps, every eighth step halves instead; what 60 steps leave is the best that is known.
    std::optional<ZeroPoint> crossing(const LatticeEdge& edge) {
        Vec2 a = place(edge.from), b = place(edge.to), p = a;
        double at_a = value(edge.from), at_b = value(edge.to);
        int kept = 0;  // how often in a row b stayed where it is, or a: < 0
        for (int k = 0; k < 60; ++k) {
            p = k % 8 == 7 ? Vec2(0.5 * (a + b)) : Vec2(a + (at_a / (at_a - at_b)) * (b - a));
            const double here = tree_value(field_, op_, p);
            if (std::fabs(here) <= zero * size_) break;
            if ((here < 0) == (at_b < 0)) {
                b = p, at_b = here;
                kept = std::min(kept, 0) - 1;
                if (kept < -1) at_a *= 0.5;
            } else {
                a = p, at_a = here;
                kept = std::max(kept, 0) + 1;
                if (kept > 1) at_b *= 0.5;
            }
        }
        return zero_point_at(field_, op_, p);
    }

    const Field& field_;
    int op_;
    FanFinder fans_;
    Vec2 origin_;
    double size_;  ///< metres
    int finest_ = least_finest;
    double step_ = 0;  ///< metres between nodes
    double lipschitz_;
    std::unordered_map<LatticeNode, double, HashOfNode> values_;  // looked up only: no order of theirs matters
    std::unordered_set<LatticeNode, HashOfNode> nodes_;  ///< that split cells have, beside the corners of the coarsest
    std::vector<Cell> cells_;      ///< that the line may run through, none split
    std::map<LatticeEdge, LatticeEdge> next_;  ///< along the line
    int visited_ = 0;
    bool complete_ = true;
};

}  // namespace

std::optional<ZeroPoint> zero_point_at(const Field& field, int op, const Vec2& p) {
    const sdf::Sample sample = evaluate_tree(field, op, p);
    const double slope = length(sample.gradient);
    if (!(slope > flattest)) return std::nullopt;
    return ZeroPoint{p, perpendicular(sample.gradient) / slope, slope};
}

std::optional<ZeroPoint> zero_point_near(const Field& field, int op, const Vec2& p, double size) {
    Vec2 at = p;
    for (int i = 0; i < 10; ++i) {  // digits double: four steps from a hundredth to a rounding, where it settles at all
        const sdf::Sample sample = evaluate_tree(field, op, at);
        const double slope = length(sample.gradient);
        if (!(slope > flattest)) return std::nullopt;
        if (std::fabs(sample.value) <= zero * size) return ZeroPoint{at, perpendicular(sample.gradient) / slope, slope};
        at -= (sample.value / (slope * slope)) * sample.gradient;
    }
    return std::nullopt;
}

/// Of what the field is all round p, the two planes that differ most are those of its two sides; the corner is where both are 0.
std::optional<ZeroCorner> zero_corner_near(const Field& field, int op, const Vec2& p, double reach, double size) {
    constexpr double diagonal = 0.70710678118654752;
    const std::array<Vec2, 8> ways{Vec2(1, 0),  Vec2(diagonal, diagonal),   Vec2(0, 1),  Vec2(-diagonal, diagonal),
                                   Vec2(-1, 0), Vec2(-diagonal, -diagonal), Vec2(0, -1), Vec2(diagonal, -diagonal)};
    ZeroCorner out{p, 0};
    for (const double radius : {reach, 0.01 * reach}) {
        std::array<sdf::Sample, 8> around;
        for (std::size_t i = 0; i < 8; ++i) around[i] = evaluate_tree(field, op, out.at + radius * ways[i]);
        std::size_t a = 0, b = 0;
        double least = infinity;
        for (std::size_t i = 0; i < 8; ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (const double cosine = dot(around[i].gradient.normalized(), around[j].gradient.normalized()); cosine < least)
                    least = cosine, a = i, b = j;
        const Vec2 &u = around[a].gradient, &v = around[b].gradient;
        const double turn = cross(u, v);
        out.sine = std::fabs(turn) / (length(u) * length(v));
        if (!(out.sine > 1e-3)) return std::nullopt;  // blunter, and where the planes cross is a thousand times as uncertain as they are
        const double at_u = radius * dot(u, ways[a]) - around[a].value, at_v = radius * dot(v, ways[b]) - around[b].value;
        out.at += Vec2(at_u * v.y() - at_v * u.y(), u.x() * at_v - v.x() * at_u) / turn;
    }
    if (!(std::fabs(tree_value(field, op, out.at)) <= zero * size)) return std::nullopt;
    return out;
}

std::optional<ZeroLoops> zero_loops(const Field& field, int op, const Box2& window) {
    Lattice lattice(field, op, window);
    if (!lattice.link_cells()) return std::nullopt;
    return lattice.loops();
}

}  // namespace pinfield
