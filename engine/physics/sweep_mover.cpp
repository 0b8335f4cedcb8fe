// A part that stands or slides is met in its own frame by the sweep of a field at rest. A part that turns is met by
// conservative advancement with a second-order bound (Mirtich 1996; Tang, Kim, Manocha 2009 for the motion bounds): in its frame
// the ball's acceleration is at most A, so the gap to a tangent plane stays above gap + (n.x') t - A t^2 / 2.
#include "engine/physics/sweep_mover.h"

#include <algorithm>

#include "engine/core/at.h"
#include "engine/core/trig.h"
#include "engine/program/evaluate.h"

namespace pinfield {

namespace {

constexpr int most_evaluations = 64;  // of one sweep: the next goes on from where this one is certified to be clear
/// Of a stretch, whose bounds of speed and acceleration hold for all of it: over a longer one they would be too wide to step by, and the
/// tip of a flipper takes several ticks for this much.
constexpr double largest_turn = pi / 4;
/// Tolerances. ContactBand::floor_below() leaves a ball that touches an eighth to creep: half of that, so that where it starts is not yet
/// where it has arrived.
constexpr double touching_accepted = 0.0625;

/// What a rotating part looks like from a point in its frame: the nearest surface, and a certified time without contact.
struct View {
    FieldHit hit;              ///< nearest of the surfaces that are reached and closing; none: solid < 0
    double gap = infinity;     ///< to the nearest of all
    double closing = 0;        ///< rate of that gap
    double safe_time = infinity;
};

struct Rotation {
    const SweptField& swept;
    const Mover& mover;
    double q, rate, acceleration;

    Pose pose_at(double t) const { return pose_of(mover, q + rate * t + 0.5 * acceleration * t * t); }
    double top_rate(double t, double end) const {
        return std::max(std::fabs(rate + acceleration * t), std::fabs(rate + acceleration * end));
    }
};

/// Bounds on the motion of the ball relative to the part over some stretch of time.
struct Bounds {
    double speed = 0, acceleration = 0;
};

Bounds bounds_over(const Rotation& r, const Motion& ball, double t, double end) {
    const Motion from = ball.from(t);
    const double turn = r.top_rate(t, end), speed = from.top_speed(end - t);
    const double arm = length(from.position - r.mover.pivot) + from.travel(end - t);
    return {speed + turn * std::min(arm, r.mover.bounding_radius),
            length(ball.acceleration) + 2 * turn * speed + turn * turn * arm + std::fabs(r.acceleration) * arm};
}

double plane_step(double spare, double closing, double acceleration) {
    return spare < 0 && closing <= 0 ? 0.0 : first_zero(std::max(spare, 0.0), closing, -acceleration);
}

/// From the place x in the part's frame, moving with velocity v there, wanting to keep `level` between ball and part.
/// A surface counts as reached at `level` + `accepted`.
View look(const Rotation& r, const Vec2& x, const Vec2& v, const Bounds& bounds, double radius, double level, double accepted,
          LayerMask layers) {
    View view;
    double reached = level + accepted;
    const Field& field = r.swept.field();
    const auto consider = [&](double distance, double certified, const FieldHit& hit) {
        const double gap = distance - radius, closing = dot(hit.normal, v);
        view.safe_time = std::min(view.safe_time, certified);
        if (gap <= reached && closing <= 0) {
            reached = gap;
            view.hit = hit;
        }
        if (gap < view.gap) {
            view.gap = gap;
            view.closing = closing;
        }
    };
    const auto lipschitz = [&](double distance) {
        const double spare = distance - radius - level;
        return spare <= 0 ? 0.0 : bounds.speed > 0 ? spare / bounds.speed : infinity;
    };
    for (std::size_t i = 0; i < r.swept.pieces().size(); ++i) {
        const SweepPiece& piece = r.swept.pieces()[i];
        const Solid& solid = at(field.solids, piece.solid);
        if ((solid.layers & layers) == 0) continue;
        const Foot foot = nearest_on(piece, x);
        double certified = lipschitz(foot.distance);
        if (piece.turn == 0 || at(field.ops, solid.root).kernels->convex) {
            certified = std::max(certified, plane_step(foot.distance - radius - level, dot(foot.normal, v), bounds.acceleration));
        } else if (piece.turn > 0) {  // an arc is part of a disc, which is convex
            const Vec2 out = x - piece.centre;
            const double far = length(out);
            if (far > piece.radius)
                certified = std::max(certified, plane_step(far - piece.radius - radius - level, dot(out, v) / far, bounds.acceleration));
        }
        consider(foot.distance, certified, {0, foot.normal, foot.concave_radius, piece.solid, piece.leaf, static_cast<int>(i)});
    }
    for (const int solid : field.tree_solids) {
        if ((at(field.solids, solid).layers & layers) == 0) continue;
        const Nearest n = nearest_of_solid(field, solid, x);
        double certified = lipschitz(n.distance);
        if (n.certified && at(field.ops, at(field.solids, solid).root).kernels->convex)
            certified = std::max(certified, plane_step(n.distance - radius - level, dot(n.gradient, v), bounds.acceleration));
        consider(n.distance, certified, {0, n.gradient, 0, solid, n.leaf, -1});
    }
    return view;
}

MoverHit sweep_rotating(const Rotation& r, const Motion& ball, double duration, double radius, const ContactBand& band,
                        LayerMask layers, SweepStats& stats) {
    MoverHit out;
    double t = 0, end = 0, level = band.target(), accepted = band.accepted();
    Bounds bounds;
    int evaluations = 0;
    ++stats.sweeps;
    while (evaluations < most_evaluations) {
        if (t >= end) {  // the next stretch that turns by less than the cap
            const double turn = r.top_rate(t, duration);
            end = turn * (duration - t) > largest_turn ? t + largest_turn / turn : duration;
            bounds = bounds_over(r, ball, t, end);
        }
        const Pose pose = r.pose_at(t);
        const Vec2 x = pose.place_from_world(ball.at(t));
        const Vec2 v = pose.from_world(ball.velocity_at(t) - velocity_of(r.mover, r.rate + r.acceleration * t, ball.at(t)));
        View view = look(r, x, v, bounds, radius, level, accepted, layers);
        if (evaluations == 0 && view.gap <= band.touching()) {
            level = view.closing > 0 ? std::min(level, view.gap) : band.floor_below(view.gap);
            accepted = touching_accepted * band.tolerance;
            view = look(r, x, v, bounds, radius, level, accepted, layers);
        }
        ++evaluations;
        if (view.hit.solid >= 0) {
            out.hit = view.hit;
            out.hit.time = t;
            out.hit.normal = pose.to_world(view.hit.normal);
            break;
        }
        t = std::min(t + view.safe_time, end);
        if (t >= duration) break;
    }
    stats.evaluations += evaluations;
    stats.most_evaluations = std::max(stats.most_evaluations, evaluations);
    if (evaluations == most_evaluations && out.hit.time == infinity && t < duration) {
        out.clear_until = t;
        ++stats.capped;
    }
    return out;
}

}  // namespace

MoverHit sweep_mover(const SweptField& swept, const Mover& mover, const MoverState& state, const Motion& ball, double duration,
                     double radius, const ContactBand& band, LayerMask layers, SweepStats& stats) {
    const double way = mover.slides ? std::fabs(state.q) + std::fabs(state.rate) * duration : 0.0;
    const double gap = length(ball.position - mover.pivot) - mover.bounding_radius - radius - way;
    if (gap > ball.travel(duration) + band.tolerance) return {};
    const bool still = state.rate == 0 && state.acceleration == 0;
    if (!mover.slides && !still)
        return sweep_rotating({swept, mover, state.q, state.rate, state.acceleration}, ball, duration, radius, band, layers, stats);
    const Pose pose = pose_of(mover, state.q);
    Motion seen{pose.place_from_world(ball.position), pose.from_world(ball.velocity), pose.from_world(ball.acceleration)};
    if (mover.slides) {
        seen.velocity -= pose.from_world(state.rate * mover.axis);
        seen.acceleration -= pose.from_world(state.acceleration * mover.axis);
    }
    const FieldSweep at_rest = swept.sweep(seen, duration, radius, band, layers, 2 * band.tolerance, stats);
    MoverHit out{at_rest.hit, at_rest.clear_until};
    if (out.hit.time < infinity) out.hit.normal = pose.to_world(at_rest.hit.normal);
    return out;
}

}  // namespace pinfield
