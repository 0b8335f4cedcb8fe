#include "engine/physics/mechanisms/mechanism.h"

#include "engine/core/at.h"
#include "engine/physics/mechanisms/flipper.h"
#include "engine/physics/mechanisms/plunger.h"
#include "engine/program/evaluate.h"
#include "engine/program/parts.h"
#include "engine/program/pose.h"
#include "engine/scene/parts/bumper.h"
#include "engine/scene/parts/drain.h"

namespace pinfield {

namespace {

const Part& part_of(const Program& program, int mover) {
    return at(program.parts, at(program.movers, mover).part);
}

}  // namespace

MoverState mover_at_rest(const Program& program, int mover) {
    const Part& part = part_of(program, mover);
    if (part.is<parts::Flipper>()) return flipper_at_rest(part.as<parts::Flipper>(), part.world_from_part.scale);
    if (part.is<parts::Plunger>()) return plunger_at_rest(part.as<parts::Plunger>(), part.world_from_part.scale);
    return {};
}

Similarity world_from_resting_mover(const Program& program, int mover) {
    return world_from_mover(at(program.movers, mover), mover_at_rest(program, mover).q);
}

bool drive_mover(const Program& program, int mover, MoverState& state, double step) {
    const Part& part = part_of(program, mover);
    if (part.is<parts::Flipper>()) drive_flipper(part.as<parts::Flipper>(), state, step);
    if (part.is<parts::Plunger>()) return drive_plunger(part.as<parts::Plunger>(), state);
    return false;
}

double leaning(const Program& program, int mover, const MoverState& state) {
    const Part& part = part_of(program, mover);
    return part.is<parts::Flipper>() ? flipper_leaning(part.as<parts::Flipper>(), state) : 0.0;
}

void switch_mover(MoverState& state, bool pressed) {
    if (pressed && !state.driven) state.drive_time = 0;
    const double middle = 0.5 * (state.q_min + state.q_max);
    if (pressed != state.driven || (state.rung > 0 && state.q < middle) || (state.rung < 0 && state.q > middle)) state.rung = 0;
    state.driven = pressed;
}

void hit_end_stop(const Program& program, int mover, MoverState& state, double step) {
    const Part& part = part_of(program, mover);
    if (part.is<parts::Flipper>()) {
        flipper_hits_stop(part.as<parts::Flipper>(), state, step);
    } else {
        state.rate = state.acceleration = 0;
    }
}

double mover_reach(const Program& program, int mover, const MoverState& state) {
    const Mover& shape = at(program.movers, mover);
    return shape.slides ? shape.bounding_radius + std::max(std::fabs(state.q_min), std::fabs(state.q_max)) : shape.bounding_radius;
}

double kick_of(const Part& part, double speed) {
    if (!part.is<parts::Bumper>()) return 0;
    const auto bumper = part.as<parts::Bumper>();
    return speed >= bumper.threshold ? bumper.kick : 0.0;
}

bool drains(const Program& program, const Sensor& sensor, const Vec2& centre, LayerMask layers) {
    if (!at(program.parts, sensor.part).is<parts::Drain>()) return false;
    return nearest(sensor.field, centre, layers).distance < 0;
}

}  // namespace pinfield
