// Uniformly accelerated motion of a point, and the roots that times of impact are made of.
#pragma once
#include "engine/core/geometry.h"

namespace pinfield {

/// A stretch of a ball's path: a parabola, or a line when the acceleration is zero. Times count from its start, seconds.
struct Motion {
    Vec2 position{0, 0}, velocity{0, 0}, acceleration{0, 0};

    Vec2 at(double t) const { return position + t * velocity + (0.5 * t * t) * acceleration; }
    Vec2 velocity_at(double t) const { return velocity + t * acceleration; }
    Motion from(double t) const { return {at(t), velocity_at(t), acceleration}; }
    bool is_straight() const { return acceleration.x() == 0 && acceleration.y() == 0; }
    /// No point of the first `duration` seconds is farther away from the start.
    double travel(double duration) const {
        return length(velocity) * duration + 0.5 * length(acceleration) * duration * duration;
    }
    double top_speed(double duration) const {
        const double first = length(velocity), last = length(velocity_at(duration));
        return first < last ? last : first;  // |v + t a| is convex in t
    }
    /// Around the first `duration` seconds.
    Box2 bounds(double duration) const {
        Box2 box = Box2::of(position, at(duration));
        for (int axis = 0; axis < 2; ++axis) {
            const double apex = acceleration[axis] != 0 ? -velocity[axis] / acceleration[axis] : -1;
            if (apex > 0 && apex < duration) box = box.including(at(apex));
        }
        return box;
    }
};

/// First t >= 0 at which gap + rate t + curvature t^2 / 2 is used up, for gap >= 0; infinity when it never is. Written so that
/// no branch subtracts nearly equal numbers (Press et al., Numerical Recipes, section 5.6).
/// With gap == 0 and rate > 0 it is the time of the return to zero.
inline double first_zero(double gap, double rate, double curvature) {
    const double discriminant = rate * rate - 2 * curvature * gap;
    if (rate < 0) return discriminant < 0 ? infinity : 2 * gap / (std::sqrt(discriminant) - rate);
    if (curvature < 0) return (rate + std::sqrt(discriminant)) / -curvature;
    return infinity;
}

/// The gaps at which a sweep stops. A ball is stopped when its gap is half the tolerance, so that rounding never eats the gap.
/// One that starts within the band is already touching: it may creep a little closer (rounding makes a tangential velocity
/// close by 1e-17 m/s), but when its motion would use the gap up it counts as a contact here and now.
/// The thresholds are quarters of the tolerance, so that each is 25 nm from the next at the usual 0.1 um: 10^8 roundings of a metre.
struct ContactBand {
    double tolerance = 1e-7;  ///< metres

    double target() const { return 0.5 * tolerance; }
    double touching() const { return 0.75 * tolerance; }
    double accepted() const { return 0.25 * tolerance; }  ///< excess over the target that is as good as none
    /// How close a touching ball may creep.
    double floor_below(double gap) const {
        if (gap > 0.375 * tolerance) return 0.25 * tolerance;
        return gap > 0 ? 0.5 * gap : gap - 0.001 * tolerance;
    }
};

}  // namespace pinfield
