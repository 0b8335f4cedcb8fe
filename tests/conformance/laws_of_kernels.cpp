// What holds between a node's kernels: packets and doubles, a fold and its lattice counterpart, a claim and its computation.
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <string>

#include "tests/conformance/packets.h"

namespace pinfield::conformance {

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
            if (!(missed_by(trial.subject, q, p) <= limit) ||
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
