#include "tests/conformance/subject_enclosure.h"

namespace pinfield::conformance {
namespace {

using sdf::Interval;
using sdf::IntervalBox;
using sdf::IntervalSample;

/// The gradient seen from the frame that `m` maps to.
IntervalSample turned(const Similarity& m, const IntervalSample& s) {
    const Interval c(m.cosine), sine(m.sine), dy = m.mirrored ? -s.dy : s.dy;
    return {s.value, c * s.dx - sine * dy, sine * s.dx + c * dy};
}

void take_nearer(IntervalSample& best, const IntervalSample& s) {
    const sdf::IntervalMask nearer = s.value < best.value;
    best = {min(s.value, best.value), select(nearer, s.dx, best.dx), select(nearer, s.dy, best.dy)};
}

IntervalSample child_enclosure(const Subject& subject, std::size_t i, const IntervalBox& p) {
    const Subject& child = subject.children()[i];
    return enclosure(child, witness_of(child.kernels()), p);
}

IntervalSample nearest_image(const Subject& subject, const IntervalBox& p) {
    IntervalSample best{Interval(infinity), {}, {}};
    for (const Similarity& local_from_image : subject.kernels().images(subject.params()))
        take_nearer(best, turned(local_from_image, child_enclosure(subject, 0, local_from_image.inverse() * p)));
    return best;
}

/// Of a warp's child and, where it folds into a lattice, of its copies nearby.
IntervalSample nearest_of_neighbours(const Subject& subject, const IntervalBox& p) {
    if (!subject.kernels().lattice) return child_enclosure(subject, 0, p);
    IntervalSample best{Interval(infinity), {}, {}};
    for (const Vec2& offset : subject.neighbour_offsets())
        take_nearer(best, child_enclosure(subject, 0, {p.x - Interval(offset.x()), p.y - Interval(offset.y())}));
    return best;
}

IntervalSample warped(const Subject& subject, const Witness& witness, const IntervalBox& p) {
    const sdf::IntervalWarped to = witness.enclosures.warped(subject.params(), p);
    const IntervalSample s = nearest_of_neighbours(subject, {to.x.value, to.y.value});
    const Interval factor(subject.kernels().factor(subject.params()));
    return {factor * s.value + to.lift.value, factor * (to.x.dx * s.dx + to.y.dx * s.dy) + to.lift.dx,
            factor * (to.x.dy * s.dx + to.y.dy * s.dy) + to.lift.dy};
}

IntervalSample local_enclosure(const Subject& subject, const Witness& witness, const IntervalBox& p) {
    const sdf::Kernels& k = subject.kernels();
    const sdf::Enclosures& over = witness.enclosures;
    const double* params = subject.params();
    if (k.form == sdf::Form::shape) return over.sample(params, p);
    if (k.form == sdf::Form::images) return nearest_image(subject, p);
    if (k.form == sdf::Form::warp) return warped(subject, witness, p);
    IntervalSample sum = child_enclosure(subject, 0, p);
    if (k.form == sdf::Form::modify) {
        const IntervalSample f = over.modify(params, sum.value);
        return {f.value, f.dx * sum.dx, f.dx * sum.dy};
    }
    for (std::size_t i = 1; i < subject.children().size(); ++i) {
        const IntervalSample next = child_enclosure(subject, i, p), f = over.combine(params, sum.value, next.value);
        sum = {f.value, f.dx * sum.dx + f.dy * next.dx, f.dx * sum.dy + f.dy * next.dy};
    }
    return sum;
}

}  // namespace

IntervalSample enclosure(const Subject& subject, const Witness& witness, const IntervalBox& p) {
    const Similarity& parent_from_local = subject.parent_from_local();
    IntervalSample s = local_enclosure(subject, witness, parent_from_local.inverse() * p);
    s.value = s.value * Interval(parent_from_local.scale);
    return turned(parent_from_local, s);
}

}  // namespace pinfield::conformance
