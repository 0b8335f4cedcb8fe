// Balls shot at every node of the catalog: none enters it, none gains energy, and each stops where a polygon of the outline stops it.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/core/at.h"
#include "engine/core/trig.h"
#include "engine/physics/audit.h"
#include "engine/physics/sweep_field.h"
#include "engine/physics/world.h"
#include "engine/program/evaluate.h"
#include "tests/conformance/brute_force.h"
#include "tests/conformance/nodes_in_scenes.h"
#include "tests/conformance/witness.h"

namespace pinfield::conformance {
namespace {

constexpr double r = 0.0135;

/// One node about the origin of a room that leaves a ball's way around it.
struct Range {
    ProgramPtr program;
    double extent = 0;  ///< metres, of what is shot at
};

/// Of an endless lattice so small that a ball fits between two, if it can.
double child_radius(const NodeType& type, const Values& values) {
    constexpr double usual = 0.025, least = 0.002;
    if (!type.kernels->lattice) return usual;
    const Vec2 step = type.kernels->lattice(pack(type, values, type.kernels->derived_count).data()).step;
    const double narrowest = std::min(step.x() > 0 ? step.x() : infinity, step.y() > 0 ? step.y() : infinity);
    return std::clamp(0.5 * narrowest - 1.1 * r, least, usual);
}

Range range_of(const NodeType& type, const Values& values) {
    Range out;
    Scene scene(test::catalog());
    const NodeId target = add_with(scene, type, values);
    const double apart = 0.03;
    for (int i = 0; i < type.meta.children.min; ++i)
        test::add(scene, "circle", target, {{"radius", child_radius(type, values)}, {"at", Vec2(apart * (1 - i), 0.01)}});
    const NodeId air = test::add(scene, "domain");
    const Subject alone(type, values, std::vector<Subject>(static_cast<std::size_t>(type.meta.children.min),
                                                           Subject(*test::catalog()->find("circle"), {0.06})));
    out.extent = alone.bounds().is_finite() ? alone.extent() : 0.1;
    test::add(scene, "box", air, {{"size", Vec2(2 * out.extent + 0.2, 2 * out.extent + 0.2)}});
    test::set(scene.table(), "slope", 0.0);
    out.program = test::compiled(scene);
    return out;
}

struct Shot {
    Vec2 from{0, 0}, velocity{0, 0};
};

/// From a free place near the room's walls to a place in the target; with no velocity when no place is free.
Shot shot_at(const Range& range, double speed, CounterRng& rng) {
    for (int attempt = 0; attempt < 100; ++attempt) {
        const SineCosine side = sine_cosine(rng.in(0, two_pi));
        const Vec2 from = (range.extent + 0.05) * rng.in(1, 1.3) * Vec2(side.cosine, side.sine);
        const double x = rng.in(-1, 1);
        const Vec2 to = range.extent * Vec2(x, rng.in(-1, 1));
        if (nearest(range.program->fixed, from).distance > r + 1e-3) return {from, speed * (to - from).normalized()};
    }
    return {};
}

/// Closest approach of two segments that do not cross.
double distance_between(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const auto to = [](const Vec2& p, const Vec2& u, const Vec2& v) {
        const Vec2 along = v - u;
        const double square = dot(along, along), t = square > 0 ? std::clamp(dot(p - u, along) / square, 0.0, 1.0) : 0;
        return length(p - u - t * along);
    };
    return std::min({to(a, c, d), to(b, c, d), to(c, a, b), to(d, a, b)});
}

double distance_between(const Vec2& a, const Vec2& b, const std::vector<Loop>& chains) {
    double best = infinity;
    for (const Loop& chain : chains)
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) best = std::min(best, distance_between(a, b, chain[i], chain[i + 1]));
    return best;
}

/// The outline in straight edges, which stray from it by at most `error`, measured in their middles, where a bound rises by its slope.
std::vector<Loop> polygon_of(const Subject& subject, double& error) {
    std::vector<Loop> out;
    sdf::Outline pieces;
    if (subject.kernels().outline) subject.kernels().outline(subject.params(), pieces);
    for (const sdf::Piece& piece : pieces) out.push_back(points_along(piece, piece.is_arc() ? 401 : 2));
    const ParametricOutline parametric = witness_of(subject.kernels()).parametric_outline;
    if (pieces.empty() && parametric) {
        Loop loop;
        parametric(subject.params(), 400, loop);
        if (loop.empty()) return out;
        loop.push_back(loop[0]);
        out.push_back(std::move(loop));
    }
    error = 0;
    for (const Loop& chain : out)
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
            const sdf::Sample middle = subject.sample(0.5 * (chain[i] + chain[i + 1]));
            error = std::max(error, std::fabs(middle.value) / length(middle.gradient));
        }
    return out;
}

void check_against_polygon(const NodeType& type, const Values& values) {
    const Subject subject(type, values);
    if (!subject.bounds().is_finite() || subject.extent() > 2) return;
    double error = 0;
    const std::vector<Loop> outline = polygon_of(subject, error);
    if (outline.empty()) return;
    const Range range = range_of(type, values);
    const SweptField swept(range.program->fixed);
    const ContactBand band;
    SweepStats stats;
    CounterRng rng(3);
    for (int i = 0; i < 12; ++i) {
        const Shot shot = shot_at(range, 1, rng);
        const Motion path{shot.from, shot.velocity, {0, 0}};
        const FieldSweep found = swept.sweep(path, 1, r, band, ground_layer, path.travel(1), stats);
        const double until = std::min({found.hit.time, found.clear_until, 1.0});
        INFO("from (" << shot.from.x() << ", " << shot.from.y() << ") at (" << shot.velocity.x() << ", " << shot.velocity.y() << ")");
        const double passed = distance_between(shot.from, path.at(until), outline) - r;
        if (!(passed > -error - 1e-9)) FAIL_CHECK("overlaps by " << -passed << ", the polygon is true within " << error);
        if (found.hit.solid >= 0 && !at(range.program->fixed.solids, found.hit.solid).is_domain &&
            !(passed < error + band.tolerance + 1e-9))
            FAIL_CHECK("stopped by what is " << passed << " away");
    }
}

void check_play(const NodeType& type, const Values& values, double restitution) {
    const Range range = range_of(type, values);
    WorldOptions options;
    options.restitution = restitution;
    options.integrator = Integrator::ballistic;
    options.balls_collide = false;
    World world(range.program, options);
    CounterRng rng(9);
    for (int i = 0; i < 6; ++i) {
        const Shot shot = shot_at(range, i % 2 ? 2 : 40, rng);
        if (shot.velocity.squaredNorm() > 0) world.add_ball(shot.from, shot.velocity);
    }
    world.record_paths(true);
    Auditor auditor;
    std::vector<double> energy;
    for (const Ball& ball : world.balls()) energy.push_back(world.energy(ball));
    for (int tick = 0; tick < 150; ++tick) {
        world.step();
        auditor.after_tick(world);
        for (std::size_t i = 0; i < energy.size(); ++i) {
            const double now = world.energy(world.balls()[i]);
            const bool is_right = now <= energy[i] * (1 + 1e-12) && (restitution < 1 || now >= energy[i] * (1 - 1e-12));
            if (!is_right) FAIL_CHECK("tick " << tick << ", ball " << i << ": energy " << energy[i] << " to " << now);
            energy[i] = now;
        }
    }
    CHECK(auditor.report().crossings == 0);
    CHECK(auditor.report().worst_depth < 1e-6);
}

World world_in(const Range& range) {
    WorldOptions options;
    options.restitution = 1;
    options.integrator = Integrator::ballistic;
    return World(range.program, options);
}

/// How far from its start a ball ends that goes until it has hit something once, is turned round, and goes as long again; nothing when it
/// hits nothing, or more than once in its last tick.
std::optional<double> missed_start(const Range& range, const Shot& shot) {
    World forth = world_in(range);
    forth.add_ball(shot.from, shot.velocity);
    int ticks = 0;
    do {
        if (++ticks > 2000) return {};
        forth.step();
    } while (forth.stats().impacts == 0);
    World back = world_in(range);
    back.add_ball(forth.balls()[0].position, -forth.balls()[0].velocity);
    for (int tick = 0; tick < ticks; ++tick) back.step();
    if (back.stats().impacts != 1) return {};
    return length(back.balls()[0].position - shot.from);
}

}  // namespace

// It is stopped within the contact tolerance, and not in the same place both ways; a glancing hit or a bend magnifies that.
TEST_CASE("an elastic ball turned round after its hit goes back the way it came, whatever it hit") {
    int tried = 0;
    for (const NodeType& type : test::catalog()->types()) {
        if (type.meta.kind != NodeKind::shape && type.meta.kind != NodeKind::operation) continue;
        INFO(type.key());
        for (const Values& values : some_values(type, 1)) {
            const Range range = range_of(type, values);
            CounterRng rng(11);
            for (int i = 0; i < 6; ++i) {
                const Shot shot = shot_at(range, 2, rng);
                const std::optional<double> missed = shot.velocity.squaredNorm() > 0 ? missed_start(range, shot) : std::nullopt;
                if (!missed) continue;
                ++tried;
                INFO("from " << shot.from.transpose() << " at " << shot.velocity.transpose());
                CHECK(*missed < 10 * ContactBand{}.tolerance);
            }
        }
    }
    CHECK(tried > 200);
}

TEST_CASE("a ball shot at any shape stops where it touches a polygon of the outline, and not before") {
    for (const NodeType& type : test::catalog()->types()) {
        if (type.meta.kind != NodeKind::shape) continue;
        for (const Values& values : some_values(type, 3)) {
            INFO(Subject(type, values).text());
            check_against_polygon(type, values);
        }
    }
}

TEST_CASE("no ball shot at any node enters it or gains energy from it, elastic or not") {
    for (const NodeType& type : test::catalog()->types()) {
        if (type.meta.kind != NodeKind::shape && type.meta.kind != NodeKind::operation) continue;
        INFO(type.key());
        for (const Values& values : some_values(type, 1))
            for (const double restitution : {1.0, 0.5}) check_play(type, values, restitution);
    }
}

}  // namespace pinfield::conformance
