// What holds of any field without knowing its outline.
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "engine/core/rng.h"
#include "engine/core/trig.h"
#include "tests/conformance/laws.h"

namespace pinfield::conformance {
namespace {

std::string at(const Vec2& p) { return fmt::format("at ({}, {})", p.x(), p.y()); }

}  // namespace

void everything_is_finite(const Trial& trial) {
    for (std::size_t i = 0; i < trial.points.size(); ++i) {
        const sdf::Sample& s = trial.samples[i];
        if (!std::isfinite(s.value) || !s.gradient.allFinite())
            trial.report(fmt::format("{}: {} gradient ({}, {})", at(trial.points[i]), s.value, s.gradient.x(), s.gradient.y()));
        if (!trial.subject.is_shape()) continue;
        // By itself, too: a choice between dual numbers may step round what is none.
        const double alone = trial.subject.kernels().distance(trial.subject.params(), trial.points[i].x(), trial.points[i].y());
        if (!std::isfinite(alone)) trial.report(fmt::format("{}: {}", at(trial.points[i]), alone));
    }
}

void value_alone_is_value_with_gradient(const Trial& trial) {
    if (!trial.subject.is_shape()) return;
    for (std::size_t i = 0; i < trial.points.size(); ++i) {
        const Vec2& p = trial.points[i];
        const double alone = trial.subject.kernels().distance(trial.subject.params(), p.x(), p.y());
        if (!(alone == trial.samples[i].value))
            trial.report(fmt::format("{}: {} and {}", at(p), alone, trial.samples[i].value));
    }
}

void gradient_is_unit_where_exact(const Trial& trial) {
    const bool outside = trial.exactness.outside == Side::exact, inside = trial.exactness.inside == Side::exact;
    for (std::size_t i = 0; i < trial.points.size(); ++i) {
        const sdf::Sample& s = trial.samples[i];
        const double margin = trial.rounding(trial.points[i]);
        const bool exact = s.value > margin ? outside : s.value < -margin ? inside : outside && inside;
        if (exact && !(std::fabs(length(s.gradient) - 1) < 1e-9))
            trial.report(fmt::format("{}: value {}, |gradient| {}", at(trial.points[i]), s.value, length(s.gradient)));
    }
}

/// Differences to the left and to the right tell a smooth place from a crease; within each smooth place the step must be
/// small beside the distance to the centre of curvature.
void gradient_is_the_central_difference(const Trial& trial) {
    int tried = 0;
    for (std::size_t i = 0; i < trial.random_count; ++i) {
        const Vec2& p = trial.points[i];
        const double h = 1e-5 * std::max(trial.extent, length(p));
        const sdf::Sample& s = trial.samples[i];
        Vec2 central{0, 0};
        bool smooth = true;
        for (int axis = 0; axis < 2; ++axis) {
            const Vec2 step = axis == 0 ? Vec2(h, 0) : Vec2(0, h);
            const double right = trial.subject.value(p + step), left = trial.subject.value(p - step);
            central[axis] = (right - left) / (2 * h);
            smooth = smooth && std::fabs(right - 2 * s.value + left) < 1e-3 * h;
        }
        if (!smooth) continue;
        ++tried;
        if (!((central - s.gradient).cwiseAbs().maxCoeff() < 1e-5))
            trial.report(fmt::format("{}: ({}, {}), differences ({}, {})", at(p), s.gradient.x(), s.gradient.y(), central.x(),
                                     central.y()));
    }
    if (tried < static_cast<int>(trial.random_count / 4)) trial.report(fmt::format("only {} smooth points", tried));
}

void gradient_is_within_lipschitz(const Trial& trial) {
    const double limit = trial.exactness.lipschitz;
    for (std::size_t i = 0; i < trial.points.size(); ++i) {
        const double g = length(trial.samples[i].gradient);
        if (!(g <= limit * (1 + 1e-9))) trial.report(fmt::format("{}: |gradient| {} above {}", at(trial.points[i]), g, limit));
    }
}

/// Random pairs, and pairs a little apart around every point where a formula may branch: a jump shows nowhere else.
void field_is_lipschitz(const Trial& trial) {
    const double limit = trial.exactness.lipschitz;
    const auto compare = [&](const Vec2& p, double at_p, const Vec2& q) {
        const double difference = std::fabs(at_p - trial.subject.value(q));
        if (!(difference <= limit * length(p - q) * (1 + 1e-9) + trial.rounding(p) + 1e-15 * std::fabs(at_p)))
            trial.report(fmt::format("{} and {}: differ by {}", at(p), at(q), difference));
    };
    CounterRng rng(7);
    for (std::size_t i = 0; i < trial.points.size(); ++i) {
        const Vec2& p = trial.points[i];
        const double here = trial.samples[i].value;
        if (i < trial.random_count) {
            compare(p, here, trial.points[trial.random_count - 1 - i]);
            for (const Vec2& on_axis : {Vec2(p.x(), 0), Vec2(0, p.y())}) {
                const double value = trial.subject.value(on_axis);
                const Vec2 aside = 1e-11 * Vec2(on_axis.y(), on_axis.x());
                compare(on_axis, value, on_axis + aside);
                compare(on_axis, value, on_axis - aside);
            }
            continue;
        }
        for (const double step : {1e-3, 1e-7}) {
            const double dx = rng.in(-1, 1);
            compare(p, here, p + step * trial.extent * Vec2(dx, rng.in(-1, 1)));
        }
    }
}

void field_is_not_zero_on_an_area(const Trial& trial) {
    std::size_t zeros = 0;
    for (std::size_t i = 0; i < trial.random_count; ++i) zeros += std::fabs(trial.samples[i].value) < trial.rounding(trial.points[i]);
    if (10 * zeros > trial.random_count) trial.report(fmt::format("zero at {} random points", zeros));
}

/// From a few places looks about in the disc that a ball may cross unasked, towards the surface first.
void safe_disc_holds_no_surface(const Trial& trial) {
    constexpr int directions = 16, radii = 8;
    const auto look_from = [&](std::size_t i) {
        const Vec2& p = trial.points[i];
        const sdf::Sample& here = trial.samples[i];
        const double safe = std::fabs(here.value) / trial.exactness.lipschitz * (1 - 1e-9) - trial.rounding(p);
        const double steep = length(here.gradient);
        if (!(safe > 0) || !(steep > 0)) return;
        const Vec2 ahead = (here.value > 0 ? -1 : 1) / steep * here.gradient;
        for (int k = 0; k < directions; ++k) {
            const SineCosine turn = sine_cosine(two_pi * k / directions);
            const Vec2 way = turn.cosine * ahead + turn.sine * perpendicular(ahead);
            for (int j = 1; j <= radii; ++j) {
                const Vec2 q = p + (safe * j / radii) * way;
                const double there = trial.subject.value(q);
                if (there == 0 || (there < 0) != (here.value < 0))
                    trial.report(fmt::format("{}: {}, but {} {}", at(p), here.value, there, at(q)));
            }
        }
    };
    for (std::size_t i = 0; i < trial.random_count; i += trial.random_count / 3) look_from(i);
    for (std::size_t i = trial.random_count; i < trial.points.size(); i += (trial.points.size() - trial.random_count) / 3 + 1) look_from(i);
}

}  // namespace pinfield::conformance
