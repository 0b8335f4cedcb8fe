#pragma once
#include <tuple>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/core/trig.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/angle.h"
#include "engine/sdf/plain_stroke.h"

namespace pinfield::sdf {

/// Wall with round ends along an Archimedean spiral about the local origin, counter-clockwise outwards from [radius, 0]. The outside is
/// always exact; where the wall fills the gap between two turns or the bend of the innermost one, the inside is a bound.
template <class Real>
struct Spiral {
    Real radius = Real(0.015);
    Real pitch = Real(0.018);
    Real turns = Real(2.25);
    Real thickness = Real(0.006);
    double end_x = 0, end_y = 0;

    static constexpr auto derived() { return std::tuple(&Spiral::end_x, &Spiral::end_y); }
    void derive() {
        const Vec2 end = curve_at(1).at;
        end_x = end.x();
        end_y = end.y();
    }

    /// Where on the spiral, by its angle from the start, and where that is.
    template <class Plain>
    struct Foot {
        Plain angle;
        Point<Plain> at;
    };

    /// On a turn that passes p at some angle outside p, the foot lies up to a quarter turn behind that angle; on a turn that passes
    /// inside p, up to a quarter turn ahead. With t the angle from p, R = |p| and b = pitch / 2 pi, half the derivative of
    /// the squared distance is b (r - R cos t) + r R sin t. In either quarter it falls, if at all, before it rises: there is one place
    /// where it rises through 0, which halving and then Newton's steps find. `start` is the quarter's first angle, from p, in quarter
    /// turns.
    template <class Plain>
    static Foot<Plain> foot_in_quarter(const Point<Plain>& p, const Plain& distance, const Plain& b, const Plain& passing_angle,
                                       const Plain& passing_radius, int start) {
        Plain angle(start * half_pi), width(half_pi);
        Point<Plain> direction{Plain(start == 0 ? 1 : 0), Plain(start)};
        double step_cosine = 0, step_sine = 1;
        const auto slope_at = [&](const Plain& r, const Point<Plain>& t) { return b * (r - distance * t.x) + r * distance * t.y; };
        const auto bend_at = [&](const Plain& r, const Point<Plain>& t) {
            return b * b + distance * (Plain(2) * b * t.y + r * t.x);
        };
        const auto turned = [](const Point<Plain>& v, const Plain& c, const Plain& s) {
            return Point<Plain>{v.x * c - v.y * s, v.x * s + v.y * c};
        };
        for (int step = 0; step < 12; ++step) {
            const double half_cosine = sqrt(0.5 * (1 + step_cosine));
            step_sine = step_sine / (2 * half_cosine);
            step_cosine = half_cosine;
            width = width * Plain(0.5);
            const Point<Plain> next = turned(direction, Plain(step_cosine), Plain(step_sine));
            const Plain r = passing_radius + b * (angle + width);
            const auto before = either(slope_at(r, next) < Plain(0), bend_at(r, next) < Plain(0));
            angle = select(before, angle + width, angle);
            direction = select(before, next, direction);
        }
        for (int step = 0; step < 4; ++step) {
            const Plain r = passing_radius + b * angle, bend = bend_at(r, direction);
            const Plain turn = clamp(-slope_at(r, direction) / max(bend, Plain(1e-30)), -width, width), square = turn * turn;
            direction = turned(direction, Plain(1) - square * (Plain(0.5) - square * Plain(1.0 / 24)),
                               turn * (Plain(1) - square * (Plain(1.0 / 6) - square * Plain(1.0 / 120))));
            angle = angle + turn;
        }
        const Point<Plain> foot_direction = turned(p, direction.x, direction.y);
        const Plain scale = (passing_radius + b * angle) / select(distance > Plain(0), distance, Plain(1));
        return {passing_angle + angle, foot_direction * scale};
    }

    Real distance(const Point<Real>& p) const { return distance_to_middle(p) - thickness * Real(0.5); }
    Real distance_to_middle(const Point<Real>& p) const {
        using Plain = decltype(frozen(Real(0)));
        const Point<Plain> q{frozen(p.x), frozen(p.y)};
        const Plain whole(two_pi), start = frozen(radius), step = frozen(pitch), b = step / whole, length = frozen(turns) * whole;
        const Plain q_distance = norm(q), q_angle = angle_of(q);
        const Plain turns_inside = floor((q_distance - start - b * q_angle) / step);
        // The last turn that begins a quarter before p's angle, and the last that reaches it; the first ones are 0 and, a quarter behind,
        // -1.
        const Plain last_outside = floor((length + Plain(half_pi) - q_angle) / whole), last_inside = floor((length - q_angle) / whole);
        const Plain outside = max(min(turns_inside + Plain(1), last_outside), Plain(0));
        const Plain inside = max(min(turns_inside, last_inside), Plain(-1));

        Point<Plain> foot{start, Plain(0)};
        const auto offer = [&](const Point<Plain>& other, const auto& exists) {
            const Point<Plain> now = q - foot, then = q - other;
            foot = select(both(exists, dot(then, then) < dot(now, now)), other, foot);
        };
        const auto has_angle = q_distance > Plain(1e-15);  // in the centre the start is as near as anything
        offer({Plain(end_x), Plain(end_y)}, Plain(0) <= length);
        for (const int quarter : {-1, 0}) {
            const Plain turn = quarter < 0 ? outside : inside;
            const Foot<Plain> found = foot_in_quarter(q, q_distance, b, q_angle + turn * whole, start + b * q_angle + turn * step, quarter);
            offer(found.at, both(has_angle, both(found.angle >= Plain(0), found.angle <= length)));
        }
        return norm(Point<Real>{p.x - Real(foot.x), p.y - Real(foot.y)});
    }

    CurvePoint curve_at(double t) const {
        const double angle = t * turns * two_pi, b = pitch / two_pi, r = radius + b * angle, speed = sqrt(r * r + b * b);
        const SineCosine to = sine_cosine(angle);
        return {r * Vec2(to.cosine, to.sine), Vec2(b * to.cosine - r * to.sine, b * to.sine + r * to.cosine) / speed};
    }
    bool is_plain() const {
        const double b = pitch / two_pi, end_radius = radius + pitch * turns,
                     top_speed = two_pi * turns * sqrt(end_radius * end_radius + b * b);
        return is_plain_stroke([this](double t) { return curve_at(t); }, top_speed, 0.5 * thickness,
                               [this](const Vec2& p) { return distance_to_middle({p.x(), p.y()}); });
    }
    Exactness exactness() const { return {.inside = is_plain() ? Side::exact : Side::bound}; }

    /// A turn is furthest along an axis a little after it passes it, where b cos t = r sin t.
    Box2 bounds() const {
        const double b = pitch / two_pi, length = turns * two_pi;
        Box2 box = Box2::of(curve_at(0).at, curve_at(1).at);
        for (int quarter = 0; quarter * half_pi < length; ++quarter) {
            double low = 0, high = half_pi;
            for (int step = 0; step < 50; ++step) {
                const double t = 0.5 * (low + high);
                const SineCosine to = sine_cosine(t);
                (b * to.cosine > (radius + b * (quarter * half_pi + t)) * to.sine ? low : high) = t;
            }
            const double furthest = quarter * half_pi + high;
            if (furthest < length) box = box.including(curve_at(furthest / length).at);
        }
        return box.grown(0.5 * thickness);
    }

    static constexpr auto describe() {
        return shape<Spiral>(
            {.key = "spiral", .float_error = 2e-6, .doc = "Wall with round ends along an Archimedean spiral about the local origin."},
            fields(field("radius", &Spiral::radius, {.unit = Unit::metre, .min = from(0), .step = 0.001, .doc = "Where it starts, on +x."}),
                   field("pitch", &Spiral::pitch,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "From the middle of one turn to that of the next."}),
                   field("turns", &Spiral::turns,
                         {.min = from(0.1), .max = to(12), .step = 0.05, .doc = "How often it goes round, counter-clockwise outwards."}),
                   field("thickness", &Spiral::thickness,
                         {.unit = Unit::metre, .min = above(0), .step = 0.0005, .doc = "Full width of the wall."})));
    }
};

}  // namespace pinfield::sdf
