// Time of impact of a ball against a moving part.
#pragma once
#include "engine/physics/sweep_field.h"
#include "engine/physics/world.h"

namespace pinfield {

/// Rotation and translation: world = offset + R m.
struct Pose {
    double cosine = 1, sine = 0;
    Vec2 offset{0, 0};

    Vec2 to_world(const Vec2& direction) const {
        return {cosine * direction.x() - sine * direction.y(), sine * direction.x() + cosine * direction.y()};
    }
    Vec2 from_world(const Vec2& direction) const {
        return {cosine * direction.x() + sine * direction.y(), cosine * direction.y() - sine * direction.x()};
    }
    Vec2 place_from_world(const Vec2& p) const { return from_world(p - offset); }
};

/// world_from_mover at coordinate q. For a part that rotates, `axis` is not used.
Pose pose_of(const Mover& mover, bool rotates, const Vec2& axis, double q);

/// Velocity of the mover's material point at the world place p, m/s.
Vec2 velocity_of(const Mover& mover, const MoverState& state, const Vec2& p);

struct MoverHit {
    FieldHit hit;                   ///< normal in the world's frame
    double clear_until = infinity;  ///< < duration when the budget ran out
};

/// First contact within `duration`, during which the mover follows q + rate t + acceleration t^2 / 2.
MoverHit sweep_mover(const SweptField& swept, const Mover& mover, const MoverState& state, const Motion& ball, double duration,
                     double radius, const ContactBand& band, LayerMask layers, SweepStats& stats);

}  // namespace pinfield
