// Whether a wall along a curve is exact inside, by trying.
#pragma once
#include "engine/core/geometry.h"
#include "engine/core/trig.h"

namespace pinfield::sdf {

/// A point of a wall's middle line and the unit vector along it.
struct CurvePoint {
    Vec2 at, along;
};

/// Of a wall: round, or one and the same place, passed through without a bend.
enum class StrokeEnds : unsigned char { round, joined };

/// The wall about the middle line curve(0) ... curve(1) (CurvePoints; `top_speed` bounds the length gone per unit of t) overlaps itself
/// nowhere, with a tenth of its thickness to spare: every point that far beside the middle line is nearest to where it
/// was set out from. Tried at steps of an eighth of the thickness at most, between which the tenth covers; false when that takes too many.
/// `distance_to_middle` is the distance to the middle line.
template <class Curve, class Distance>
bool is_plain_stroke(const Curve& curve, double top_speed, double half_thickness, const Distance& distance_to_middle,
                     StrokeEnds ends = StrokeEnds::round) {
    // A wall so long or thin that it takes more is not tried; a short one is tried at the least, for it may bend all the same.
    constexpr int most_steps = 2000, least_steps = 64, steps_round_end = 16;
    const double wanted = 4 * top_speed / half_thickness;
    if (!(wanted <= most_steps)) return false;
    const int steps = std::max(least_steps, static_cast<int>(wanted) + 1);
    const double reach = 1.1 * half_thickness, least = reach * (1 - 1e-9);
    for (int i = 0; i <= steps; ++i) {
        const CurvePoint c = curve(static_cast<double>(i) / steps);
        const Vec2 aside = reach * perpendicular(c.along);
        if (!(distance_to_middle(Vec2(c.at + aside)) >= least && distance_to_middle(Vec2(c.at - aside)) >= least)) return false;
    }
    if (ends == StrokeEnds::joined) return true;
    for (const double end : {0.0, 1.0}) {
        const CurvePoint c = curve(end);
        const Vec2 out = (end == 0 ? -reach : reach) * c.along;
        for (int i = 1; i < steps_round_end; ++i) {
            const SineCosine turn = sine_cosine(pi * i / steps_round_end);
            if (!(distance_to_middle(Vec2(c.at + turn.sine * out + turn.cosine * perpendicular(out))) >= least)) return false;
        }
    }
    return true;
}

}  // namespace pinfield::sdf
