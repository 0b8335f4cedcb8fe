#include "tests/conformance/sheet/measure.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "engine/core/rng.h"
#include "tests/conformance/brute_force.h"
#include "tests/conformance/packets.h"
#include "tests/conformance/parameters.h"
#include "tests/conformance/sheet/zero_line.h"

namespace pinfield::conformance {
namespace {

constexpr std::size_t random_points = 250;
constexpr double zero_line_tolerance = 3e-7;  // sizes

/// Distances of the trial's points from the subject's outline, however it is found; NaN where the outline's end is not known.
struct Truth {
    std::vector<double> distance;
    Reference reference;
};

/// Without the gradient where it can be had without: a trace asks often.
std::function<double(const Vec2&)> value_of(const Subject& subject) {
    if (!subject.is_shape()) return [&](const Vec2& p) { return subject.value(p); };
    return [&](const Vec2& p) { return subject.kernels().distance(subject.params(), p.x(), p.y()); };
}

Truth zero_line_truth(const Trial& trial) {
    const Box2 bounds = trial.subject.bounds();
    const double e = trial.extent;
    ZeroLineOptions options{.leaf = 0.008 * e, .tolerance = zero_line_tolerance * e, .lipschitz = trial.exactness.lipschitz};
    const bool endless = !bounds.is_finite();
    // An odd window, so that the edges of cells fall on no axis.
    const double reach = (trial.subject.kernels().lattice ? 2 : 8) * e;  // nothing is far from a lattice
    if (!bounds.is_empty()) options.window = endless ? Box2::centred(1.015 * reach, 1.009 * reach) : bounds.grown(0.0371 * e);
    const sdf::Outline chords = bounds.is_empty() ? sdf::Outline{} : zero_line(value_of(trial.subject), options);
    Truth truth{{}, Reference::zero_line};
    for (const Vec2& p : trial.points) {
        const double found = distance_to_outline(p, chords);
        const double known = endless ? reach - p.cwiseAbs().maxCoeff() : infinity;
        truth.distance.push_back(found < known ? found : std::nan(""));
    }
    return truth;
}

Truth truth_of(const Trial& trial) {
    if (!trial.subject.is_shape() || trial.truth.distance.empty()) return zero_line_truth(trial);
    return {trial.truth.distance, trial.subject.keeps_outlines() ? Reference::outline : Reference::curve};
}

/// A field that is 0 within its solid, as where two children of a union touch, is so on the inside.
bool is_inside(const Trial& trial, std::size_t i) {
    const Vec2& p = trial.points[i];
    if (std::fabs(trial.samples[i].value) > trial.rounding(p)) return trial.samples[i].value < 0;
    double highest = -infinity;
    for (const Vec2& d : {Vec2(1, 0.1), Vec2(-0.1, 1), Vec2(-1, -0.1), Vec2(0.1, -1)})
        highest = std::max(highest, trial.subject.value(p + 1e-3 * trial.extent * d));
    return highest < 0;
}

void add(const SideMeasure& one, std::vector<SideMeasure>& sides) {
    if (one.points == 0) return;
    const auto rank = [](const SideMeasure& side) { return std::pair(side.claimed, side.reference); };
    auto at = sides.begin();
    while (at != sides.end() && rank(*at) < rank(one)) ++at;
    if (at == sides.end() || rank(*at) != rank(one)) at = sides.insert(at, {.claimed = one.claimed, .reference = one.reference});
    ++at->subjects;
    at->points += one.points;
    at->over = std::max(at->over, one.over);
    at->under = std::max(at->under, one.under);
}

void measure_distances(const Trial& trial, Measure& out) {
    const Truth truth = truth_of(trial);
    SideMeasure outside{.claimed = trial.exactness.outside, .reference = truth.reference};
    SideMeasure inside{.claimed = trial.exactness.inside, .reference = truth.reference};
    for (std::size_t i = 0; i < truth.distance.size(); ++i) {
        if (std::isnan(truth.distance[i])) continue;
        const double value = trial.samples[i].value, error = (std::fabs(value) - truth.distance[i]) / trial.extent;
        SideMeasure& side = is_inside(trial, i) ? inside : outside;
        ++side.points;
        side.over = std::max(side.over, error);
        side.under = std::max(side.under, -error);
    }
    add(outside, out.outside);
    add(inside, out.inside);
}

/// The largest of the gradients, and of the differences between points far apart and near each other.
double slope_of(const Trial& trial) {
    double steepest = 0;
    CounterRng rng(7);
    for (std::size_t i = 0; i < trial.points.size(); ++i) {
        const Vec2& p = trial.points[i];
        const double here = trial.samples[i].value;
        steepest = std::max(steepest, length(trial.samples[i].gradient));
        const auto compare = [&](const Vec2& q, double there) {
            // Nearer than this, rounding is most of the difference.
            if (length(q - p) > 1e-5 * trial.extent) steepest = std::max(steepest, std::fabs(here - there) / length(q - p));
        };
        const std::size_t partner = trial.points.size() - 1 - i;
        compare(trial.points[partner], trial.samples[partner].value);
        for (const double step : {1e-1, 1e-2, 1e-4}) {
            const double dx = rng.in(-1, 1);
            const Vec2 q = p + step * trial.extent * Vec2(dx, rng.in(-1, 1));
            compare(q, trial.subject.value(q));
        }
    }
    return steepest;
}

/// In sizes, as the declared one is.
double float_error_of(const Trial& trial) {
    double largest = -1;
    const Subject& subject = trial.subject;
    const Floats input = packet_input(trial);
    const std::vector<float> results = run(subject, sdf::Isa::sse2, input.a, input.b);
    for (std::size_t i = 0; i < results.size(); ++i) {
        const double a = input.a[i], b = input.b[i], truth = in_double(subject, a, b);
        largest = std::max(largest, std::fabs(results[i] - truth) / std::max({trial.extent, std::sqrt(a * a + b * b), std::fabs(truth)}));
    }
    const sdf::Kernels& k = subject.kernels();
    if (k.form != sdf::Form::warp) return largest;
    const Floats points = points_in_floats(trial);
    const Floats3 warped = warp(subject, sdf::Isa::sse2, points);
    for (std::size_t i = 0; i < warped.x.size(); ++i) {
        const Vec2 p(points.a[i], points.b[i]), q(warped.x[i], warped.y[i]);
        const double missed = missed_by(subject, q, p);
        const double lift_missed = std::fabs(warped.lift[i] - k.lift(subject.params(), p));
        largest = std::max(largest, std::max(missed, lift_missed) / std::max(trial.extent, length(p)));
    }
    return largest;
}

void measure_subject(const Subject& subject, std::uint64_t seed, Measure& out) {
    const Trial trial = trial_of(subject, witness_of(subject.kernels()), seed, random_points);
    ++out.subjects;
    measure_distances(trial, out);
    const double slope = slope_of(trial), claimed = trial.exactness.lipschitz;
    if (out.slope_claimed == 0 || slope / claimed > out.slope / out.slope_claimed) out.slope = slope, out.slope_claimed = claimed;
    out.float_error = std::max(out.float_error, float_error_of(trial));
}

}  // namespace

double floor_of(Reference reference) {
    switch (reference) {
        case Reference::outline: return 2e-12;
        case Reference::curve: return 2e-8;
        default: return 1e-6;
    }
}

Measure measure(const Catalog& catalog, const NodeType& type, int random_sets) {
    CounterRng rng(2024);
    std::vector<Values> sets{defaults_of(type)};
    if (type.own_fields > 0)
        for (int i = 0; i < random_sets; ++i) sets.push_back(random_values(type, rng));
    Measure out;
    std::uint64_t seed = 1;
    for (const Values& values : sets)
        for (const Subject& subject : subjects_of(catalog, type, values)) measure_subject(subject, ++seed, out);
    return out;
}

}  // namespace pinfield::conformance
