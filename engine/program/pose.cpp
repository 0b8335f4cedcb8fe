#include "engine/program/pose.h"

#include "engine/core/trig.h"

namespace pinfield {

Pose pose_of(const Mover& mover, double q) {
    if (mover.slides) return {mover.cosine, mover.sine, mover.pivot + q * mover.axis};
    const SineCosine turn = sine_cosine(mover.handedness * q);
    return {mover.cosine * turn.cosine - mover.sine * turn.sine, mover.sine * turn.cosine + mover.cosine * turn.sine, mover.pivot};
}

Similarity world_from_mover(const Mover& mover, double q) {
    const Pose pose = pose_of(mover, q);
    return {.cosine = pose.cosine, .sine = pose.sine, .offset = pose.offset};
}

Vec2 velocity_of(const Mover& mover, double rate, const Vec2& p) {
    if (mover.slides) return rate * mover.axis;
    return (mover.handedness * rate) * perpendicular(p - mover.pivot);
}

}  // namespace pinfield
