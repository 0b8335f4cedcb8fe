// What holds between a formula over boxes and the same formula at points. Interval arithmetic knows nothing of what a node claims, so it
// is a witness of its own: it may be too vague to say anything, but what it does say is proved for every point of a box.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/core/rng.h"
#include "tests/conformance/laws.h"
#include "tests/conformance/subject_enclosure.h"

namespace pinfield::conformance {
namespace {

constexpr int boxes = 48;

/// Other boxes for each subject: its first point is random.
CounterRng rng_of(const Trial& trial) { return CounterRng(std::bit_cast<std::uint64_t>(trial.points[0].x())); }

/// Around one of the trial's points, which is returned too: from a millionth of the extent wide to all of it, on each axis by itself, and
/// every eighth time a line or the point alone.
struct BoxAround {
    Vec2 p;
    Box2 box;
};
BoxAround random_box(const Trial& trial, CounterRng& rng) {
    const Vec2& p = trial.points[std::min(static_cast<std::size_t>(rng.uniform() * static_cast<double>(trial.points.size())),
                                          trial.points.size() - 1)];
    BoxAround out{p, Box2::of(p, p)};
    for (const int axis : {0, 1}) {
        const double size = rng.uniform() < 0.125 ? 0 : trial.extent * std::pow(10, rng.in(-6, 0)), share = rng.uniform();
        out.box = out.box.including(out.p + (axis == 0 ? Vec2(-share * size, 0) : Vec2(0, -share * size)));
        out.box = out.box.including(out.p + (axis == 0 ? Vec2((1 - share) * size, 0) : Vec2(0, (1 - share) * size)));
    }
    return out;
}

Vec2 random_point(const Box2& box, CounterRng& rng) {
    const double x = rng.in(box.lo.x(), box.hi.x());
    return Vec2(x, rng.in(box.lo.y(), box.hi.y())).cwiseMax(box.lo).cwiseMin(box.hi);
}

std::string text(const sdf::Interval& a) { return fmt::format("[{}, {}]", a.lo, a.hi); }
std::string text(const sdf::Interval& x, const sdf::Interval& y) { return fmt::format("{} x {}", text(x), text(y)); }
std::string text(const Box2& box) { return text({box.lo.x(), box.hi.x()}, {box.lo.y(), box.hi.y()}); }

/// No number of an interval is nearer to 0.
double least_size(const sdf::Interval& a) { return std::max({a.lo, -a.hi, 0.0}); }

}  // namespace

/// Without any tolerance: interval and double do the same operations in the same order, and rounding keeps the order of numbers. A shape's
/// value alone and its value with the gradient are two instances of one formula; both are asked. At a crease the gradient is that of some
/// side, which the enclosure must hold as well.
void enclosures_hold_the_samples(const Trial& trial) {
    CounterRng rng = rng_of(trial);
    for (int i = 0; i < boxes; ++i) {
        const auto [p, box] = random_box(trial, rng);
        const sdf::IntervalSample found = enclosure(trial.subject, trial.witness, sdf::interval_box(box));
        for (const Vec2& q : {p, box.lo, box.hi, Vec2(box.lo.x(), box.hi.y()), Vec2(box.hi.x(), box.lo.y()), random_point(box, rng),
                              random_point(box, rng)}) {
            const sdf::Sample s = trial.subject.sample(q);
            const auto where = [&, &box = box] { return fmt::format("{} at ({}, {})", text(box), q.x(), q.y()); };
            if (!found.value.contains(s.value)) trial.report(fmt::format("{}: {} in {}", where(), s.value, text(found.value)));
            if (!found.dx.contains(s.gradient.x()) || !found.dy.contains(s.gradient.y()))
                trial.report(fmt::format("{}: gradient ({}, {}) in {}", where(), s.gradient.x(), s.gradient.y(), text(found.dx, found.dy)));
        }
        if (!trial.subject.is_shape()) continue;
        const sdf::Interval alone = trial.witness.enclosures.distance(trial.subject.params(), sdf::interval_box(box));
        const double value = trial.subject.kernels().distance(trial.subject.params(), p.x(), p.y());
        if (!alone.contains(value)) trial.report(fmt::format("{}: alone {} in {}", text(box), value, text(alone)));
    }
}

/// Where even the least gradient that the formula can have in a box is longer than the claim, the claim is false, whatever was sampled.
void enclosures_do_not_refute_the_lipschitz_constant(const Trial& trial) {
    CounterRng rng = rng_of(trial);
    const double limit = trial.exactness.lipschitz;
    for (int i = 0; i < boxes; ++i) {
        const Box2 box = random_box(trial, rng).box;
        const sdf::IntervalSample found = enclosure(trial.subject, trial.witness, sdf::interval_box(box));
        const double least = length(Vec2(least_size(found.dx), least_size(found.dy)));
        if (!(least <= limit * (1 + 1e-9))) trial.report(fmt::format("{}: |gradient| at least {}, above {}", text(box), least, limit));
    }
}

}  // namespace pinfield::conformance
