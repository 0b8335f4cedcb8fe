#include "engine/program/trace.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/at.h"
#include "engine/program/biarc.h"
#include "engine/program/evaluate.h"
#include "engine/program/tree.h"
#include "engine/program/zero_loops.h"
#include "engine/sdf/piece.h"

namespace pinfield {
namespace {

using sdf::Piece;

/// Metres. Shapes that have no outline of their own are known by samples, a 128th of the whole apart: what balls meet must not lie between.
/// (Of 400 random paths of 0.1 m, one point of which lies farther out, none lost an edge at 5 m, one did at 10 m and three at 50 m.)
constexpr double largest_traced = 4;
/// Of the tree, between points of the loops, and of the result: limits for rough zero lines, which arcs fit nowhere. The promised tolerance
/// takes 300 to 1250 pieces for the curved shapes and 2500 for a waved box; a solid that would take more than thrice that stays a tree.
constexpr int most_evaluations = 400000;
constexpr std::size_t most_pieces = 8000;

/// Fits lines and arcs to loops of zero points: a biarc over as many points as it fits, and where it fits over no two neighbours,
/// at corners, points found between these.
class Fit {
public:
    Fit(const Field& field, int op, double size) : field_(field), op_(op), size_(size) {}

    bool add(const std::vector<ZeroPoint>& loop) {
        const std::size_t n = loop.size();
        const auto point = [&](std::size_t i) -> const ZeroPoint& { return loop[i % n]; };
        const std::size_t first = out_.size();
        end_ = loop[0].at;
        std::size_t length = 8;
        for (std::size_t i = 0; i < n; i += length, length = std::min<std::size_t>(2 * length, 64)) {
            length = std::min(length, n - i);
            while (length > 1 && !spans(loop, i, length)) length /= 2;
            if (length == 1 && !between(point(i), point(i + 1), 0)) return false;
        }
        if (out_.size() > first) out_.back().piece.b = out_[first].piece.a;
        return out_.size() <= most_pieces;
    }

    std::vector<OwnedPiece> take() { return std::move(out_); }

private:
    /// A share of the tolerance. A piece that cuts a corner off misses it by more than it misses its sides: ten times as much where the
    /// sides meet at 11 degrees, 2 arcsin 0.1.
    static constexpr double at_corners = 0.1;
    double tolerance() const { return trace_tolerance * size_; }
    /// An arc that bulges by less is as good as straight: a thousandth of what is promised, and far above rounding.
    double flat() const { return 1e-3 * tolerance(); }

    /// Does the zero line run along the piece, as far as a share of the tolerance?
    bool holds(const Piece& piece, double slope, double share) {
        const double limit = share * tolerance() * slope;
        constexpr std::array shares{0.25, 0.5, 0.75};
        return std::all_of(shares.begin(), shares.end(), [&](double t) {
            ++evaluations_;
            return std::fabs(tree_value(field_, op_, point_at_share(piece, t))) <= limit;
        });
    }

    /// Whatever the line does over so short a way, it strays by less than anything else may.
    double short_way() const { return 0.01 * tolerance(); }

    /// Short pieces are left out, as their directions are those of roundings; the next one then begins where the last one ended.
    void push(Piece piece) {
        if (length(piece.b - end_) <= short_way()) return;
        piece.a = end_;
        end_ = piece.b;
        int leaf = op_;
        evaluate_tree(field_, op_, point_at_share(piece, 0.5), &leaf);
        out_.push_back({piece, leaf});
    }

    std::optional<std::array<Piece, 2>> fitting_biarc(const ZeroPoint& a, const ZeroPoint& b) {
        const auto pair = biarc(a.at, a.along, b.at, b.along, flat());
        const double slope = std::min(a.slope, b.slope);
        if (!pair || !holds((*pair)[0], slope, at_corners) || !holds((*pair)[1], slope, at_corners)) return std::nullopt;
        return pair;
    }

    /// One biarc over several steps of a loop.
    bool spans(const std::vector<ZeroPoint>& loop, std::size_t first, std::size_t steps) {
        const std::size_t n = loop.size();
        const ZeroPoint &a = loop[first], &b = loop[(first + steps) % n];
        const auto pair = biarc(a.at, a.along, b.at, b.along, flat());
        if (!pair) return false;
        const double limit = tolerance() * tolerance();
        for (std::size_t k = first + 1; k < first + steps; ++k) {
            const Vec2& p = loop[k % n].at;
            if (squared_distance_to_piece((*pair)[0], p) > limit && squared_distance_to_piece((*pair)[1], p) > limit) return false;
        }
        const double slope = std::min(a.slope, b.slope);
        if (!holds((*pair)[0], slope, 0.5) || !holds((*pair)[1], slope, 0.5)) return false;
        push((*pair)[0]);
        push((*pair)[1]);
        return true;
    }

    /// The way from a to b when there is nothing known between: at a corner one end's tangent may belong to the other side of it.
    bool between(const ZeroPoint& a, const ZeroPoint& b, int depth) {
        const double slope = std::min(a.slope, b.slope), apart = length(b.at - a.at);
        if (apart <= short_way()) {
            push(Piece::segment(a.at, b.at));
            return true;
        }
        if (const auto pair = fitting_biarc(a, b)) {
            push((*pair)[0]);
            push((*pair)[1]);
            return true;
        }
        for (const Piece& piece : {arc_along(a.at, a.along, b.at, flat()), arc_arriving(a.at, b.at, b.along, flat())})
            if (!piece.reflex && holds(piece, slope, at_corners)) {
                push(piece);
                return true;
            }
        if (depth > 60 || evaluations_ > most_evaluations) return false;  // 2^-60 of a cell is below rounding: it does not settle
        const std::optional<ZeroPoint> middle = point_between(a, b);
        if (!middle) return false;
        return between(a, *middle, depth + 1) && between(*middle, b, depth + 1);
    }

    /// Where the tangents meet, which is where a corner is, or next to it; else halfway.
    std::optional<ZeroPoint> point_between(const ZeroPoint& a, const ZeroPoint& b) {
        const auto useful = [&](const std::optional<ZeroPoint>& found) {
            return found && is_between(a.at, found->at, b.at, 2 * farthest(a, b));
        };
        const Vec2 chord = b.at - a.at, middle = 0.5 * (a.at + b.at);
        const double turn = cross(a.along, b.along);
        std::optional<ZeroPoint> found;
        if (std::fabs(turn) > 0.02) {  // a degree: tangents that turn by less meet about halfway, if anywhere
            const Vec2 to_corner = a.at + (cross(chord, b.along) / turn) * a.along - middle;
            if (length(to_corner) < farthest(a, b)) {
                evaluations_ += 4;
                if (useful(found = zero_point_near(field_, op_, middle + to_corner, size_))) return found;
                // In a narrow corner Newton's iteration goes to and fro between its sides.
                if (useful(found = crossing(middle, middle + 1.5 * to_corner))) return found;
            }
        }
        evaluations_ += 4;
        if (useful(found = zero_point_near(field_, op_, middle, size_))) return found;
        return crossing_beside(a.at, b.at);
    }

    /// How far the tangents may meet: where the line comes back the way it went there is a needle's tip, many chords away.
    static double farthest(const ZeroPoint& a, const ZeroPoint& b) { return (dot(a.along, b.along) < 0 ? 64 : 2) * length(b.at - a.at); }

    /// Well away from either end, so that the halving goes on (by ten-thousandths at worst), and not far aside.
    static bool is_between(const Vec2& a, const Vec2& p, const Vec2& b, double far) {
        const double to_a = length(p - a), to_b = length(p - b);
        return std::min(to_a, to_b) > 1e-4 * length(b - a) && std::max(to_a, to_b) < far;
    }

    /// On the perpendicular through the middle of the chord, as far as the chord is long: the nearest change of sign. A smooth line bulges
    /// by little, so the near places come first.
    std::optional<ZeroPoint> crossing_beside(const Vec2& a, const Vec2& b) {
        const Vec2 middle = 0.5 * (a + b), aside = perpendicular(b - a);
        for (const double reach : {1.0 / 512, 1.0 / 64, 1.0 / 8, 1.0})
            for (const double side : {reach, -reach})
                if (const auto found = crossing(middle, middle + side * aside)) return found;
        return std::nullopt;
    }

    /// The change of sign from one place to the other, by bisection; nothing where both are on the same side.
    std::optional<ZeroPoint> crossing(Vec2 from, Vec2 to) {
        evaluations_ += 2;
        const bool solid = tree_value(field_, op_, from) < 0;
        if ((tree_value(field_, op_, to) < 0) == solid) return std::nullopt;
        for (int i = 0; i < 50; ++i) {
            const Vec2 p = 0.5 * (from + to);
            ((tree_value(field_, op_, p) < 0) == solid ? from : to) = p;
        }
        evaluations_ += 50;
        return zero_point_at(field_, op_, from);
    }

    const Field& field_;
    int op_;
    double size_;
    std::vector<OwnedPiece> out_;
    Vec2 end_{0, 0};  ///< of the piece before
    int evaluations_ = 0;
};

Box2 around_images(const Field& field, const Op& op, const Box2& child) {
    Box2 out;
    for (int i = 0; i < op.image_count; ++i) out = out.merged(at(field.images, op.first_image + i) * child);
    return out;
}

/// A box around the zero line: the solid's, or, where the solid has no end, that of what is not solid.
Box2 box_of_zero_line(const Field& field, int index) {
    const Op& op = at(field.ops, index);
    if (op.bounds.is_finite() || op.bounds.is_empty()) return op.bounds;
    const double* params = field.params.data() + op.params;
    const auto child = [&](int i) { return box_of_zero_line(field, at(field.links, op.first_link + i)); };
    if (op.kernels->form == sdf::Form::modify) return child(0).grown(std::fabs(op.kernels->affine(params).offset) * op.scale);
    if (op.kernels->form == sdf::Form::images) return around_images(field, op, child(0));
    if (op.kernels->form != sdf::Form::fold || op.kernels->combine_hard != op.kernels->combine) return Box2::everything();
    Box2 all;
    for (int i = 0; i < op.child_count; ++i) all = all.merged(child(i));
    return all;
}

}  // namespace

TracedBoundary traced_boundary(const Field& field, int op) {
    const Box2 box = box_of_zero_line(field, op);
    if (box.is_empty() || !box.is_finite()) return {};
    const double size = box.size().maxCoeff();
    if (!(size > 0) || size > largest_traced) return {};
    // With margins of about 2 %, nearly three cells, and no two alike: the lattice stands off the solid's own axes and middle, where it is
    // likely to have its edges.
    const Vec2 lo = box.centre() - Vec2(0.5231, 0.5178) * size;
    const Box2 window{lo, lo + Vec2(1.0437, 1.0437) * size};
    const std::optional<ZeroLoops> found = zero_loops(field, op, window);
    if (!found) return {};
    if (found->loops.empty()) return {.pieces = {}, .error = 0, .nothing = found->complete && at(field.ops, op).bounds.is_finite()};
    Fit fit(field, op, size);
    for (const std::vector<ZeroPoint>& loop : found->loops)
        if (!fit.add(loop)) return {};
    return {fit.take(), trace_tolerance * size};
}

}  // namespace pinfield
