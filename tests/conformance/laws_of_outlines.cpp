// What holds of a field and the outline it belongs to.
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "tests/conformance/brute_force.h"
#include "tests/conformance/laws.h"

namespace pinfield::conformance {
namespace {

std::string at(const Vec2& p) { return fmt::format("at ({}, {})", p.x(), p.y()); }

/// Points of the children's outlines around which the sign of the whole changes: those of its own outline.
std::vector<Vec2> points_of_own_outline(const Trial& trial, double step) {
    sdf::Outline candidates;
    trial.subject.collect_outline({}, candidates);
    std::vector<Vec2> out;
    if (candidates.size() > 60) return out;
    const double side = 1e-6 * trial.extent;
    for (const sdf::Piece& piece : candidates) {
        const double l = piece.is_arc() ? 6.3 * piece.radius : length(piece.b - piece.a);
        for (const Vec2& q : points_along(piece, 2 + static_cast<int>(l / step))) {
            bool positive = false, negative = false;
            for (const Vec2& d : {Vec2(1, 0.1), Vec2(-0.1, 1), Vec2(-1, -0.1), Vec2(0.1, -1)}) {
                const double f = trial.subject.value(q + side * d);
                positive = positive || f > 0;
                negative = negative || f < 0;
            }
            if (positive && negative) out.push_back(q);
        }
    }
    return out;
}

void measure_operation(Trial& trial) {
    if (!trial.subject.keeps_outlines()) return;
    const double step = 0.01 * trial.extent;
    const std::vector<Vec2> samples = points_of_own_outline(trial, step);
    if (samples.empty()) return;
    for (const Vec2& p : trial.points) {
        double best = infinity;
        for (const Vec2& q : samples) best = std::min(best, (p - q).squaredNorm());
        trial.truth.distance.push_back(std::sqrt(best));
    }
    trial.truth.error = step;  // a corner may lie half a step beside the nearest sample
}

bool side_is_exact(const Exactness& e, double value) { return (value > 0 ? e.outside : e.inside) == Side::exact; }

}  // namespace

void measure_outline(Trial& trial) {
    const Subject& subject = trial.subject;
    const sdf::Kernels& k = subject.kernels();
    if (!subject.is_shape()) return measure_operation(trial);
    sdf::Outline pieces;
    Loop loop;
    if (k.outline) k.outline(subject.params(), pieces);
    const ParametricOutline parametric = trial.witness.parametric_outline;
    if (pieces.empty() && parametric) parametric(subject.params(), 2000, loop);
    if (pieces.empty() && loop.empty()) return;
    OutlineTruth& truth = trial.truth;
    const std::vector<Loop> chains = loop.empty() ? chords_of(pieces) : std::vector<Loop>(1, loop);
    for (const Vec2& p : trial.points) {
        truth.distance.push_back(loop.empty() ? distance_to_outline(p, pieces) : distance_to_loop(p, loop));
        truth.inside.push_back(is_inside(p, chains, !loop.empty()));
    }
    for (const Loop& chain : chains)
        for (const Vec2& p : chain) truth.box = truth.box.including(p);
    truth.error = (loop.empty() ? 1e-12 : 1e-8) * trial.extent;
}

void bounds_contain_the_solid(const Trial& trial) {
    const Box2 bounds = trial.subject.bounds(), box = bounds.grown(trial.rounding({0, 0}));
    for (std::size_t i = 0; i < trial.points.size(); ++i)
        if (trial.samples[i].value < 0 && !box.contains(trial.points[i]))
            trial.report(fmt::format("{}: solid, but outside the bounds", at(trial.points[i])));
    if (!bounds.is_finite() || bounds.is_empty()) return;
    const double gap = 1e-4 * trial.extent;
    for (int i = 0; i < 40; ++i) {  // just beyond each side of the box
        const Vec2 along = bounds.lo + (-0.2 + 1.4 * i / 39) * bounds.size(), lo = box.lo - Vec2(gap, gap), hi = box.hi + Vec2(gap, gap);
        for (const Vec2& p : {Vec2(along.x(), lo.y()), Vec2(along.x(), hi.y()), Vec2(lo.x(), along.y()), Vec2(hi.x(), along.y())})
            if (trial.subject.value(p) < 0) trial.report(fmt::format("{}: solid, but outside the bounds", at(p)));
    }
}

void bounds_of_a_shape_are_tight(const Trial& trial) {
    const Box2 &tight = trial.truth.box, box = trial.subject.bounds();
    if (tight.is_empty()) return;
    const double slack = std::max((box.lo - tight.lo).cwiseAbs().maxCoeff(), (box.hi - tight.hi).cwiseAbs().maxCoeff());
    if (slack > 1e-3 * trial.extent) trial.report(fmt::format("off by {}", slack));
}

void exact_sides_are_brute_force_distances(const Trial& trial) {
    for (std::size_t i = 0; i < trial.truth.distance.size(); ++i) {
        const double value = trial.samples[i].value, truth = trial.truth.distance[i];
        if (!side_is_exact(trial.exactness, value)) continue;
        if (!(std::fabs(std::fabs(value) - truth) < trial.truth.error + trial.rounding(trial.points[i])))
            trial.report(fmt::format("{}: {}, brute force {}", at(trial.points[i]), value, truth));
    }
}

void no_side_overestimates(const Trial& trial) {
    for (std::size_t i = 0; i < trial.truth.distance.size(); ++i) {
        const double value = trial.samples[i].value, truth = trial.truth.distance[i];
        if (!(std::fabs(value) <= truth + trial.truth.error + trial.rounding(trial.points[i])))
            trial.report(fmt::format("{}: {}, brute force {}", at(trial.points[i]), value, truth));
    }
}

void sign_tells_inside_from_outside(const Trial& trial) {
    for (std::size_t i = 0; i < trial.truth.inside.size(); ++i) {
        const double value = trial.samples[i].value;
        if (trial.truth.distance[i] > 1e-3 * trial.extent && (value < 0) != trial.truth.inside[i])
            trial.report(fmt::format("{}: {}, which is the wrong side", at(trial.points[i]), value));
    }
}

/// A small step to either side of a piece's middle, where no other piece is near: one in, one out. Which is which is what the lowering of
/// CSG trees goes by.
void solid_is_on_the_left_of_its_outline(const Trial& trial) {
    if (!trial.subject.is_shape() || !trial.subject.kernels().outline) return;
    sdf::Outline pieces;
    trial.subject.kernels().outline(trial.subject.params(), pieces);
    const double step = 1e-5 * trial.extent;
    for (std::size_t i = 0; i < pieces.size(); i += pieces.size() / 24 + 1) {
        const std::vector<Vec2> along = points_along(pieces[i], 41);
        const Vec2& p = along[20];
        const Vec2 chord = (pieces[i].turn < 0 ? -1 : 1) * (along[21] - along[19]);
        double room = length(chord);
        for (const sdf::Piece& other : pieces)
            if (&other != &pieces[i]) room = std::min(room, distance_to_piece(p, other));
        if (room < 4 * step) continue;
        const Vec2 left = step / length(chord) * perpendicular(chord);
        const double inside = trial.subject.value(p + left), outside = trial.subject.value(p - left);
        if (!(inside < 0 && outside > 0)) trial.report(fmt::format("{}: {} on the left, {} on the right", at(p), inside, outside));
        // ... and no corner or centre either: where the distance is exact it is that step.
        const double off = 1e-9 * trial.extent, nook = pieces[i].is_arc() ? std::min(room, pieces[i].radius) : room;
        if (nook < 4 * step) continue;
        if (trial.exactness.inside == Side::exact && !(std::fabs(inside + step) < off))
            trial.report(fmt::format("{}: {} inside it, {}", at(p), step, inside));
        if (trial.exactness.outside == Side::exact && !(std::fabs(outside - step) < off))
            trial.report(fmt::format("{}: {} outside it, {}", at(p), step, outside));
    }
}

/// In the middle of a piece of the outline, where rounding alone is left of the way to the foot, the gradient is the normal out of the
/// solid: what stands or rolls there goes by it.
void gradient_on_the_outline_points_out(const Trial& trial) {
    if (!trial.subject.is_shape() || trial.exactness.outside != Side::exact || trial.exactness.inside != Side::exact) return;
    const auto faces = [&](const Vec2& p, const Vec2& along) {
        const Vec2 right = -perpendicular(along) / length(along), gradient = trial.subject.sample(p).gradient;
        const bool is_thin = trial.subject.value(p - 1e-5 * trial.extent * right) >= 0;  // a collapsed triangle has no inside
        if (!is_thin && !(dot(gradient, right) > 0.999))
            trial.report(fmt::format("{} on the outline, which faces {}, {}: gradient {}, {}", at(p), right.x(), right.y(), gradient.x(),
                                     gradient.y()));
    };
    sdf::Outline pieces;
    if (trial.subject.kernels().outline) trial.subject.kernels().outline(trial.subject.params(), pieces);
    for (std::size_t i = 0; i < pieces.size(); i += pieces.size() / 24 + 1) {
        const std::vector<Vec2> along = points_along(pieces[i], 41);
        if (length(along[21] - along[19]) > 1e-6 * trial.extent) faces(along[20], (pieces[i].turn < 0 ? -1 : 1) * (along[21] - along[19]));
    }
    Loop loop;
    const ParametricOutline parametric = trial.witness.parametric_outline;
    if (pieces.empty() && parametric) parametric(trial.subject.params(), 200, loop);
    for (std::size_t i = 1; i + 1 < loop.size(); i += loop.size() / 48 + 1) {
        const Vec2 before = loop[i] - loop[i - 1], after = loop[i + 1] - loop[i];
        const bool bends = dot(before, after) < 0.9999 * length(before) * length(after);
        if (!bends && length(before) > 1e-6 * trial.extent) faces(loop[i], loop[i + 1] - loop[i - 1]);
    }
}

/// With |f(p) - f(q)| <= |p - q| this makes f the distance: the outline is no nearer than |f|, and the foot is that near.
void foot_point_is_on_the_outline_where_exact(const Trial& trial) {
    for (std::size_t i = 0; i < trial.random_count; ++i) {
        const sdf::Sample& s = trial.samples[i];
        if (!side_is_exact(trial.exactness, s.value)) continue;
        const Vec2& p = trial.points[i];
        const double at_foot = trial.subject.value(p - s.value * s.gradient);
        if (!(std::fabs(at_foot) < 1e-9 * std::max(trial.extent, length(p))))
            trial.report(fmt::format("{}: value {}, at its foot {}", at(p), s.value, at_foot));
    }
}

}  // namespace pinfield::conformance
