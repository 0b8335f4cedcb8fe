// Where a mover stands at its coordinate q, and how its points move with it: of the program alone, whoever drives q.
#pragma once
#include "engine/program/program.h"

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

/// Of the mover's field at q.
Pose pose_of(const Mover& mover, double q);
/// The same as a similarity, for drawing and picking.
Similarity world_from_mover(const Mover& mover, double q);

/// Velocity of the mover's material point at the world place p while q changes by `rate` a second, m/s.
Vec2 velocity_of(const Mover& mover, double rate, const Vec2& p);

}  // namespace pinfield
