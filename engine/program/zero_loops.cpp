#include "engine/program/zero_loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "engine/core/at.h"
#include "engine/program/evaluate.h"
#include "engine/program/tree.h"

namespace pinfield {
namespace {

constexpr double zero = 1e-11;    // in sizes of the solid: far below what tracing promises, far above rounding
constexpr int probing_depth = 2;  // halvings of a cell that seems empty and may not be: tracing promises to see a quarter of one
constexpr double flattest = 1e-6;  // slope of a field that still has a direction: bounds are flatter than distances by factors, not millions
constexpr double half_diagonal = 0.7072;  // of a square, rounded up

/// Walks the cells that the line crosses (Lorensen and Cline, "Marching cubes", 1987, in the plane) and links their edges.
class Lattice {
public:
    Lattice(const Field& field, int op, const Box2& window, int cells)
        : field_(field), op_(op), origin_(window.lo), step_(window.size().maxCoeff() / cells), cells_(cells),
          lipschitz_(at(field.ops, op).exactness.lipschitz),
          values_(static_cast<std::size_t>(cells + 1) * static_cast<std::size_t>(cells + 1), std::numeric_limits<double>::quiet_NaN()) {}

    bool link_cells(bool settle) {
        settle_ = settle;
        return visit(0, 0, cells_);
    }

    std::optional<std::vector<std::vector<ZeroPoint>>> loops() {
        std::vector<std::vector<ZeroPoint>> out;
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
            out.push_back(std::move(loop));
        }
        return out;
    }

private:
    /// From node (i, j) to its right neighbour, or upward.
    struct LatticeEdge {
        int i = 0, j = 0;
        bool upward = false;
        bool operator==(const LatticeEdge&) const = default;
        bool operator<(const LatticeEdge& b) const { return j != b.j ? j < b.j : i != b.i ? i < b.i : upward < b.upward; }
    };

    Vec2 place(double i, double j) const { return origin_ + step_ * Vec2(i, j); }

    double value(int i, int j) {
        double& known = values_[static_cast<std::size_t>(j) * static_cast<std::size_t>(cells_ + 1) + static_cast<std::size_t>(i)];
        if (std::isnan(known)) known = tree_value(field_, op_, place(i, j));
        return known;
    }

    bool is_far(double value, double size) const { return std::fabs(value) > half_diagonal * lipschitz_ * size; }

    /// False when the lattice is too coarse.
    bool visit(int i, int j, int size) {
        if (size == 1) return link(i, j);
        const int half = size / 2;
        if (is_far(value(i + half, j + half), size * step_)) return true;
        return visit(i, j, half) && visit(i + half, j, half) && visit(i, j + half, half) && visit(i + half, j + half, half);
    }

    bool hides_something(double i, double j, double size, bool solid, int depth) const {
        const double middle = tree_value(field_, op_, place(i + 0.5 * size, j + 0.5 * size));
        if ((middle < 0) != solid) return true;
        if (depth == 0 || is_far(middle, size * step_)) return false;
        const double half = 0.5 * size;
        return hides_something(i, j, half, solid, depth - 1) || hides_something(i + half, j, half, solid, depth - 1) ||
               hides_something(i, j + half, half, solid, depth - 1) || hides_something(i + half, j + half, half, solid, depth - 1);
    }

    bool link(int i, int j) {
        const std::array<bool, 4> solid{value(i, j) < 0, value(i + 1, j) < 0, value(i + 1, j + 1) < 0, value(i, j + 1) < 0};
        const std::array<LatticeEdge, 4> edges{LatticeEdge{i, j, false}, LatticeEdge{i + 1, j, true}, LatticeEdge{i, j + 1, false},
                                               LatticeEdge{i, j, true}};
        int leaving = 0, last = 0;  // edges on which the solid ends, walking round the cell counter-clockwise
        for (int k = 0; k < 4; ++k)
            if (solid[corner(k)] && !solid[corner(k + 1)]) ++leaving, last = k;
        if (leaving == 0) return settle_ || !hides_something(i, j, 1, solid[0], probing_depth);
        if (leaving == 2) {
            if (!settle_) return false;
            // A saddle: the middle goes with one pair of opposite corners, and the line cuts off each of the other two.
            const int way = tree_value(field_, op_, place(i + 0.5, j + 0.5)) < 0 ? 1 : 3;
            for (const int k : {last, last + 2}) next_[edges[corner(k)]] = edges[corner(k + way)];
            return true;
        }
        for (int k = 0; k < 4; ++k)
            if (!solid[corner(k)] && solid[corner(k + 1)]) next_[edges[corner(last)]] = edges[corner(k)];
        return true;
    }

    /// Between the two nodes of an edge, which lie on either side: false position in its Illinois form. Where the field bends so sharply
    /// that it creeps, every eighth step halves instead; what 60 steps leave is the best that is known.
    std::optional<ZeroPoint> crossing(const LatticeEdge& edge) {
        Vec2 a = place(edge.i, edge.j), b = edge.upward ? place(edge.i, edge.j + 1) : place(edge.i + 1, edge.j), p = a;
        double at_a = value(edge.i, edge.j), at_b = edge.upward ? value(edge.i, edge.j + 1) : value(edge.i + 1, edge.j);
        int kept = 0;  // how often in a row b stayed where it is, or a: < 0
        for (int k = 0; k < 60; ++k) {
            p = k % 8 == 7 ? Vec2(0.5 * (a + b)) : Vec2(a + (at_a / (at_a - at_b)) * (b - a));
            const double here = tree_value(field_, op_, p);
            if (std::fabs(here) <= zero * cells_ * step_) break;
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

    static std::size_t corner(int k) { return static_cast<std::size_t>(k % 4); }

    const Field& field_;
    int op_;
    Vec2 origin_;
    double step_;
    int cells_;
    double lipschitz_;
    std::vector<double> values_;
    std::map<LatticeEdge, LatticeEdge> next_;
    bool settle_ = false;
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

std::optional<std::vector<std::vector<ZeroPoint>>> zero_loops(const Field& field, int op, const Box2& window, int cells, bool settle) {
    Lattice lattice(field, op, window, cells);
    if (!lattice.link_cells(settle)) return std::nullopt;
    return lattice.loops();
}

}  // namespace pinfield
