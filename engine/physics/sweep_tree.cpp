// Conservative advancement (Mirtich 1996) over a CSG tree: each node answers with a certified safe time, and the tree's own
// formula, evaluated over Clearance values, combines them: the clear time of a union is the least of its children's, that of
// an intersection the greatest, and a complement swaps the sides.
#include "engine/physics/sweep_tree.h"

#include <algorithm>

#include "engine/core/at.h"
#include "engine/program/evaluate.h"

namespace pinfield {

namespace {

using sdf::Clearance;

constexpr int most_evaluations = 64;  // of one sweep: the next goes on from where this one is certified to be clear
/// Tolerances: what ContactBand::floor_below() leaves at least to a ball that touches and creeps closer. One that is on its way out has as
/// much, and moves by half of it where nothing else certifies a step.
constexpr double least_room = 0.125;

/// One question to a tree; `lip` below is the step that a Lipschitz constant certifies at any node.
struct Walk {
    const Field& field;
    double duration;
    int& evaluations;

    double lipschitz_step(double spare, double lipschitz, const Motion& motion) const {
        if (spare <= 0) return 0;
        const double speed = motion.top_speed(duration) * lipschitz;
        return speed > 0 ? spare / speed : infinity;
    }

    /// A leaf that is an exact distance to a convex set is a convex function: its tangent plane is a lower bound of it all
    /// along the path, and -f is concave along a line, so clear at both ends means clear between. A parabola strays from its
    /// chord by at most |a| duration^2 / 8.
    Clearance leaf(const Op& op, int index, const Motion& motion, double margin) const {
        const sdf::Sample here = evaluate_tree(field, index, motion.position);
        ++evaluations;
        const double outside = here.value - margin, inside = -here.value - margin;
        Clearance c{lipschitz_step(outside, op.exactness.lipschitz, motion), lipschitz_step(inside, op.exactness.lipschitz, motion)};
        if (!op.kernels->convex || op.exactness.lipschitz != 1) return c;
        const bool both_exact = op.exactness.outside == Side::exact && op.exactness.inside == Side::exact;
        if (outside > 0 && op.exactness.outside == Side::exact && (margin >= 0 || both_exact)) {
            const double plane = first_zero(outside, dot(here.gradient, motion.velocity), dot(here.gradient, motion.acceleration));
            c.outside = std::max(c.outside, plane);
        }
        if (inside > 0 && both_exact) {
            const double end = -evaluate_tree(field, index, motion.at(duration)).value - margin;
            ++evaluations;
            const double sag = length(motion.acceleration) * duration * duration / 8;
            if (std::min(inside, end) - sag > 0) c.inside = infinity;
            else if (sag == 0 && end < inside) c.inside = std::max(c.inside, duration * inside / (inside - end));
        }
        return c;
    }

    Clearance fold(const Op& op, const Motion& motion, double margin) const {
        const double* params = field.params.data() + op.params;
        const sdf::Slack slack = op.kernels->slack(params);
        const double wider = margin + (op.child_count - 1) * std::max(slack.below, slack.above) * op.scale;
        Clearance all = of(at(field.links, op.first_link), motion, wider);
        for (int i = 1; i < op.child_count; ++i)
            all = op.kernels->combine_clearance(params, all, of(at(field.links, op.first_link + i), motion, wider));
        return all;
    }

    Clearance modify(const Op& op, const Motion& motion, double margin) const {
        const sdf::Affine change = op.kernels->affine(field.params.data() + op.params);
        const double offset = change.offset * op.scale;
        const int child = at(field.links, op.first_link);
        const Clearance outer = of(child, motion, margin - offset);  // f > margin  <=>  sign d > margin - offset
        if (change.absolute) {
            const Clearance inner = of(child, motion, margin + offset);  // |d| < -offset - margin, on both sides
            return {std::max(outer.outside, outer.inside), std::min(inner.inside, inner.outside)};
        }
        const Clearance inner = offset == 0 ? outer : of(child, motion, margin + offset);
        return change.sign > 0 ? Clearance{outer.outside, inner.inside} : Clearance{outer.inside, inner.outside};
    }

    Clearance images(const Op& op, const Motion& motion, double margin) const {
        Clearance all{infinity, 0};
        const int child = at(field.links, op.first_link);
        for (int i = 0; i < op.image_count; ++i) {
            const Similarity child_from_field = at(field.images, op.first_image + i).inverse();
            const Motion seen{child_from_field * motion.position, child_from_field.direction(motion.velocity),
                              child_from_field.direction(motion.acceleration)};
            all = sdf::min(all, of(child, seen, margin));
        }
        return all;
    }

    /// What the value and its Lipschitz constant alone certify: all there is to say of a warp, whose paths are not parabolas.
    Clearance by_value(const Op& op, int index, const Motion& motion, double margin) const {
        const double value = evaluate_tree(field, index, motion.position).value;
        ++evaluations;
        return {lipschitz_step(value - margin, op.exactness.lipschitz, motion),
                lipschitz_step(-value - margin, op.exactness.lipschitz, motion)};
    }

    Clearance of(int index, const Motion& motion, double margin) const {
        const Op& op = at(field.ops, index);
        if (op.kernels->form == sdf::Form::shape) return leaf(op, index, motion, margin);
        if (op.kernels->form == sdf::Form::warp) return by_value(op, index, motion, margin);
        Clearance c = op.kernels->form == sdf::Form::fold     ? fold(op, motion, margin)
                      : op.kernels->form == sdf::Form::modify ? modify(op, motion, margin)
                                                              : images(op, motion, margin);
        if (op.kernels->form == sdf::Form::fold) {  // what the children lost to the slack, the value itself may know
            const Clearance own = by_value(op, index, motion, margin);
            c = {std::max(c.outside, own.outside), std::max(c.inside, own.inside)};
        }
        return c;
    }
};

}  // namespace

sdf::Clearance clearance(const Field& field, int op, const Motion& motion, double duration, double margin, int& evaluations) {
    return Walk{field, duration, evaluations}.of(op, motion, margin);
}

TreeSweep sweep_tree(const Field& field, int solid, const Motion& motion, double duration, double radius,
                     const ContactBand& band, int& evaluations) {
    TreeSweep out;
    const int root = at(field.solids, solid).root;
    const auto truth_at = [&](double t) {
        ++evaluations;
        return nearest_of_solid(field, solid, motion.at(t));
    };
    const Nearest start = truth_at(0);
    const double lipschitz = std::max(1.0, start.certified ? 1.0 : at(field.ops, root).exactness.lipschitz);
    out.start_distance = start.distance / lipschitz;
    double gap = start.distance - radius, t = 0, level = band.target();
    if (gap / lipschitz > motion.travel(duration) + band.tolerance) return out;
    bool touching = gap <= band.touching();
    const double rate = dot(start.gradient, motion.velocity);
    if (touching && rate > 0) level = std::min(level, gap - least_room * band.tolerance);
    else if (touching) level = band.floor_below(gap);
    Nearest here = start;
    for (int i = 0; i < most_evaluations; ++i) {
        const Motion rest = motion.from(t);
        const double left = duration - t, closing = dot(here.gradient, rest.velocity);
        const bool arrived = gap <= (touching ? level : band.touching());
        if (arrived && (closing < 0 || (closing == 0 && dot(here.gradient, rest.acceleration) < 0))) {
            out.time = touching && rate <= 0 ? 0 : t;
            out.normal = here.gradient / length(here.gradient);
            out.leaf = here.leaf;
            return out;
        }
        if (arrived && rest.top_speed(left) > 0) {  // at an edge of the tree the surface that closes may not be the one it names
            const Nearest ahead = truth_at(std::min(duration, t + band.tolerance / rest.top_speed(left)));
            if (ahead.distance < here.distance && dot(ahead.gradient, rest.velocity) < 0) {
                out.time = t;
                out.normal = ahead.gradient / length(ahead.gradient);
                out.leaf = ahead.leaf;
                return out;
            }
        }
        double step = clearance(field, root, rest, left, radius + level, evaluations).outside;
        const double speed = rest.top_speed(left);
        if (gap > level && speed > 0) step = std::max(step, (gap - level) / (lipschitz * speed));
        // Touching and on its way out, where nothing above can certify a step: the band itself is the room there is.
        if (arrived && speed > 0) step = std::max(step, 0.5 * least_room * band.tolerance / (lipschitz * speed));
        t += step;
        if (!(t < duration)) return out;
        here = truth_at(t);
        gap = here.distance - radius;
        if (touching && gap > band.touching()) {  // it left: from here on it counts like any other ball
            touching = false;
            level = band.target();
        }
    }
    out.clear_until = t;
    return out;
}

}  // namespace pinfield
