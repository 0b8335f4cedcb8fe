// What holds between a node's kernels: packets and doubles, a fold and its lattice counterpart, a claim and its computation.
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <string>

#include "engine/core/rng.h"
#include "tests/conformance/laws.h"

namespace pinfield::conformance {
namespace {

struct Operands {
    std::vector<double> a, b;
};

/// Pairs of field values: of all signs, equal, opposite, far apart.
Operands operands(double extent) {
    Operands out;
    CounterRng rng(11);
    for (int i = 0; i < 200; ++i) {
        const double a = extent * rng.in(-1, 1), b = i % 5 == 0 ? a : i % 7 == 0 ? -a : extent * rng.in(-1, 1);
        out.a.push_back(i % 11 == 0 ? 0 : a);
        out.b.push_back(b);
    }
    return out;
}

/// All n results of one instruction set; empty where this machine or the node has none.
std::vector<float> run(const Subject& subject, sdf::Isa isa, const std::vector<float>& a, const std::vector<float>& b) {
    if (isa > sdf::best_isa()) return {};
    const sdf::PacketKernels& k = subject.kernels().packets[static_cast<std::size_t>(isa)];
    std::vector<float> out = a;
    const int n = static_cast<int>(a.size());
    if (k.distance) k.distance(subject.params(), a.data(), b.data(), out.data(), n);
    else if (k.combine) k.combine(subject.params(), out.data(), b.data(), n);
    else return {};
    return out;
}

/// What packets are fed: points for a shape, field values for an operation; in floats, so that rounding the input is no error.
struct Floats {
    std::vector<float> a, b;
};
Floats points_in_floats(const Trial& trial) {
    Floats out;
    for (const Vec2& p : trial.points) {
        out.a.push_back(static_cast<float>(p.x()));
        out.b.push_back(static_cast<float>(p.y()));
    }
    return out;
}

Floats packet_input(const Trial& trial) {
    Floats out;
    if (trial.subject.is_shape()) return points_in_floats(trial);
    const Operands pairs = operands(trial.extent);
    out.a.assign(pairs.a.begin(), pairs.a.end());
    out.b.assign(pairs.b.begin(), pairs.b.end());
    return out;
}

double in_double(const Subject& subject, double a, double b) {
    const sdf::Kernels& k = subject.kernels();
    switch (k.form) {
        case sdf::Form::shape: return k.distance(subject.params(), a, b);
        case sdf::Form::fold: return k.combine(subject.params(), a, b);
        default: return k.modify(subject.params(), a);
    }
}

/// Where packets of one instruction set send the points, and what they lift there.
struct Floats3 {
    std::vector<float> x, y, lift;
};
Floats3 warp(const Subject& subject, sdf::Isa isa, const Floats& points) {
    const sdf::PacketKernels& k = subject.kernels().packets[static_cast<std::size_t>(isa)];
    if (isa > sdf::best_isa() || !k.warp) return {};
    Floats3 out{points.a, points.b, std::vector<float>(points.a.size())};
    k.warp(subject.params(), out.x.data(), out.y.data(), out.lift.data(), static_cast<int>(out.x.size()));
    return out;
}

}  // namespace

void packets_are_the_value_within_float_error(const Trial& trial) {
    const Floats input = packet_input(trial);
    const double declared = trial.subject.type().meta.float_error;
    for (int isa = 0; isa < sdf::isa_count; ++isa) {
        const std::vector<float> results = run(trial.subject, static_cast<sdf::Isa>(isa), input.a, input.b);
        for (std::size_t i = 0; i < results.size(); ++i) {
            const double a = input.a[i], b = input.b[i], truth = in_double(trial.subject, a, b);
            // An operation's own lengths, such as a large k, are part of the extent: the result shows them.
            const double limit = declared * std::max({trial.extent, std::sqrt(a * a + b * b), std::fabs(truth)});
            if (!(std::fabs(results[i] - truth) <= limit))
                trial.report(fmt::format("isa {} of ({}, {}): {} for {}, declared {}", isa, a, b, results[i], truth, limit));
        }
    }
}

/// Also with every number of points, whole packets or not.
void every_instruction_set_gives_the_same_bits(const Trial& trial) {
    Floats input = packet_input(trial);
    const std::vector<float> all = run(trial.subject, sdf::Isa::sse2, input.a, input.b);
    if (all.empty()) return;
    for (std::size_t n : {input.a.size(), std::size_t{19}, std::size_t{7}, std::size_t{1}, std::size_t{0}}) {
        input.a.resize(std::min(n, input.a.size()));
        input.b.resize(input.a.size());
        for (int isa = 0; isa < sdf::isa_count; ++isa) {
            const std::vector<float> results = run(trial.subject, static_cast<sdf::Isa>(isa), input.a, input.b);
            for (std::size_t i = 0; i < results.size(); ++i)
                if (std::bit_cast<std::uint32_t>(results[i]) != std::bit_cast<std::uint32_t>(all[i]))
                    trial.report(fmt::format("isa {}, lane {} of {}: {} for {}", isa, i, n, results[i], all[i]));
        }
    }
}

/// Within the float error of what is seen of it: a miss counts by as much as the child's field is multiplied.
void warp_packets_are_the_warp(const Trial& trial) {
    const sdf::Kernels& k = trial.subject.kernels();
    if (k.form != sdf::Form::warp) return;
    const Floats points = points_in_floats(trial);
    const Floats3 baseline = warp(trial.subject, sdf::Isa::sse2, points);
    for (int isa = 0; isa < sdf::isa_count; ++isa) {
        const Floats3 found = warp(trial.subject, static_cast<sdf::Isa>(isa), points);
        for (std::size_t i = 0; i < found.x.size(); ++i) {
            const Vec2 p(points.a[i], points.b[i]), q(found.x[i], found.y[i]);
            const double limit = trial.subject.type().meta.float_error * std::max(trial.extent, length(p));
            if (!(k.factor(trial.subject.params()) * length(q - k.warp(trial.subject.params(), p)) <= limit) ||
                !(std::fabs(found.lift[i] - k.lift(trial.subject.params(), p)) <= limit))
                trial.report(fmt::format("isa {} of ({}, {})", isa, p.x(), p.y()));
            if (std::bit_cast<std::uint32_t>(found.x[i]) != std::bit_cast<std::uint32_t>(baseline.x[i]) ||
                std::bit_cast<std::uint32_t>(found.lift[i]) != std::bit_cast<std::uint32_t>(baseline.lift[i]))
                trial.report(fmt::format("isa {} of ({}, {}): other bits", isa, p.x(), p.y()));
        }
    }
}

void fold_strays_no_further_than_its_slack(const Trial& trial) {
    const sdf::Kernels& k = trial.subject.kernels();
    if (k.form != sdf::Form::fold) return;
    const double* params = trial.subject.params();
    const sdf::Slack slack = k.slack(params);
    const Operands pairs = operands(trial.extent);
    for (std::size_t i = 0; i < pairs.a.size(); ++i) {
        const double a = pairs.a[i], b = pairs.b[i];
        const double f = k.combine(params, a, b), hard = k.combine_hard(params, a, b), rounding = trial.rounding({a, b});
        if (!(hard - slack.below - rounding <= f && f <= hard + slack.above + rounding))
            trial.report(fmt::format("({}, {}): {}, hard {}", a, b, f, hard));
        // Over times instead of distances the counterpart must choose the same way.
        const sdf::Clearance clear = k.combine_clearance(params, {std::max(a, 0.0), std::max(-a, 0.0)},
                                                         {std::max(b, 0.0), std::max(-b, 0.0)});
        if (clear.outside != std::max(hard, 0.0) || clear.inside != std::max(-hard, 0.0))
            trial.report(fmt::format("({}, {}): clearance ({}, {}), hard {}", a, b, clear.outside, clear.inside, hard));
    }
}

void fold_partials_are_weights_of_differences(const Trial& trial) {
    const sdf::Kernels& k = trial.subject.kernels();
    if (k.form != sdf::Form::fold) return;
    const double* params = trial.subject.params();
    const double h = 1e-6 * trial.extent, limit = trial.subject.type().meta.exactness.lipschitz;
    const Operands pairs = operands(trial.extent);
    for (std::size_t i = 0; i < pairs.a.size(); ++i) {
        const double a = pairs.a[i], b = pairs.b[i];
        const sdf::Partials f = k.combine_partials(params, a, b);
        if (!identical(f.value, k.combine(params, a, b))) trial.report(fmt::format("({}, {}): two values", a, b));
        if (!(std::fabs(f.by_a) + std::fabs(f.by_b) <= limit + 1e-12))
            trial.report(fmt::format("({}, {}): weights {} and {}", a, b, f.by_a, f.by_b));
        const double a_right = k.combine(params, a + h, b), a_left = k.combine(params, a - h, b);
        const double b_right = k.combine(params, a, b + h), b_left = k.combine(params, a, b - h);
        const bool smooth = std::fabs(a_right - 2 * f.value + a_left) + std::fabs(b_right - 2 * f.value + b_left) < 1e-3 * h;
        const double error = std::max(std::fabs(f.by_a - (a_right - a_left) / (2 * h)), std::fabs(f.by_b - (b_right - b_left) / (2 * h)));
        if (smooth && !(error < 1e-3)) trial.report(fmt::format("({}, {}): partials off by {}", a, b, error));
    }
}

void modify_is_what_its_affine_form_says(const Trial& trial) {
    const sdf::Kernels& k = trial.subject.kernels();
    if (k.form != sdf::Form::modify) return;
    const sdf::Affine affine = k.affine(trial.subject.params());
    if (std::fabs(affine.sign) != 1) trial.report("a sign is +1 or -1");
    for (const double d : operands(trial.extent).a) {
        const double expected = (affine.absolute ? std::fabs(d) : affine.sign * d) + affine.offset;
        if (k.modify(trial.subject.params(), d) != expected) trial.report(fmt::format("{}", d));
    }
}

void exactness_at_defaults_is_as_described(const Trial& trial) {
    const NodeType& type = trial.subject.type();
    for (std::size_t i = 0; i < trial.subject.values().size(); ++i)
        if (!identical(trial.subject.values()[i], type.fields[i].initial)) return;
    const std::vector<Exactness> children(trial.subject.is_shape() ? 0 : type.meta.children.max == 1 ? 1 : 2);
    const Exactness computed = trial.subject.kernels().exactness(trial.subject.params(), children);
    if (!(computed == type.meta.exactness)) trial.report("described otherwise");
}

}  // namespace pinfield::conformance
