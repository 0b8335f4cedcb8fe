#include "engine/physics/start.h"

#include "engine/core/at.h"
#include "engine/physics/mechanisms/mechanism.h"
#include "engine/program/evaluate.h"
#include "engine/program/pose.h"

namespace pinfield {

namespace {

/// The domain in whose solid a point is, or -1.
int domain_around(const Program& program, const Vec2& p, LayerMask layers) {
    const std::vector<Solid>& solids = program.fixed.solids;
    for (int s = 0; s < static_cast<int>(solids.size()); ++s)
        if (at(solids, s).is_domain && (at(solids, s).layers & layers) && nearest_of_solid(program.fixed, s, p).distance < 0) return s;
    return -1;
}

Start overlap_with(const Program& program, const Field& field, int solid, double distance, Hindrance hindrance) {
    const Solid& found = at(field.solids, solid);
    const NodeId node = found.part >= 0 ? at(program.parts, found.part).origin : found.origin;
    return {hindrance, node, program.physics.ball_radius - distance};
}

}  // namespace

bool is_outside(const Program& program, const Vec2& p, LayerMask layers) { return domain_around(program, p, layers) >= 0; }

Start start_at(const Program& program, std::span<const double> q, const Vec2& p, LayerMask layers) {
    const double least = program.physics.ball_radius - program.physics.tolerance, reach = 2 * program.physics.ball_radius;
    if (const int domain = domain_around(program, p, layers); domain >= 0)
        return overlap_with(program, program.fixed, domain, nearest_of_solid(program.fixed, domain, p).distance, Hindrance::outside);
    if (const Nearest n = nearest(program.fixed, p, layers, reach); n.solid >= 0 && n.distance < least)
        return overlap_with(program, program.fixed, n.solid, n.distance, Hindrance::solid);
    for (const Sensor& sensor : program.sensors)
        if (drains(program, sensor, p, layers)) return {Hindrance::drain, at(program.parts, sensor.part).origin};
    for (std::size_t m = 0; m < program.movers.size(); ++m) {
        const Mover& mover = program.movers[m];
        const Nearest n = nearest(mover.field, pose_of(mover, q[m]).place_from_world(p), layers, reach);
        if (n.solid < 0 || n.distance >= least) continue;
        return {Hindrance::mover, at(program.parts, mover.part).origin, program.physics.ball_radius - n.distance, static_cast<int>(m)};
    }
    return {};
}

Start start_at(const Program& program, const Vec2& p, LayerMask layers) {
    std::vector<double> q;
    q.reserve(program.movers.size());
    for (int m = 0; m < static_cast<int>(program.movers.size()); ++m) q.push_back(mover_at_rest(program, m).q);
    return start_at(program, q, p, layers);
}

}  // namespace pinfield
