// Times of impact: closed forms, certified advancement and dense sampling against each other.
#include <functional>

#include "engine/core/rng.h"
#include "engine/core/trig.h"
#include "engine/physics/sweep_field.h"
#include "engine/physics/sweep_mover.h"
#include "engine/physics/sweep_tree.h"
#include "engine/program/evaluate.h"
#include "tests/physics/support.h"

using namespace pinfield;
using namespace pinfield::physics_test;

namespace {

constexpr double r = 0.0135;
const ContactBand band{1e-7};

Motion random_motion(CounterRng& rng, double speed, double pull) {
    const SineCosine way = sine_cosine(rng.in(0, two_pi)), down = sine_cosine(rng.in(0, two_pi));
    const double v = speed * rng.uniform();
    return {{rng.in(-0.15, 0.15), rng.in(-0.15, 0.15)}, {v * way.cosine, v * way.sine}, {pull * down.cosine, pull * down.sine}};
}

/// A program with one static solid, lowered, and the same solid kept as a tree.
struct Both {
    ProgramPtr lowered, tree;
};

Both both(const std::string& node) {
    const ProgramPtr lowered =
        program_of("pinfield: 1\ntable: {size: [4, 4]}\nscene:\n  - domain: {children: [box: {size: [4, 4]}]}\n" + node);
    auto tree = std::make_shared<Program>(*lowered);
    Field& field = tree->fixed;
    field.pieces.clear();
    field.tree_solids.clear();
    std::vector<Box2> boxes;
    for (std::size_t i = 0; i < field.solids.size(); ++i) {
        field.solids[i].lowered = false;
        field.solids[i].piece_count = 0;
        field.tree_solids.push_back(static_cast<int>(i));
        boxes.push_back(field.solids[i].bounds);
    }
    field.bvh = Bvh(boxes);
    return {lowered, tree};
}

/// First sample at which the ball overlaps the field by more than nothing, or infinity.
double sampled(const Field& field, const Motion& path, double duration, int samples) {
    for (int k = 0; k <= samples; ++k) {
        const double t = duration * (static_cast<double>(k) / samples);
        if (nearest(field, path.at(t), ground_layer, 2 * r).distance < r) return t;
    }
    return infinity;
}

}  // namespace

TEST_CASE("the time of impact with a line under gravity is the root of its quadratic") {
    const ProgramPtr program = program_of("pinfield: 1\ntable: {size: [4, 4], slope: 90}\nscene: []\n");
    const SweptField swept(program->fixed);
    SweepStats stats;
    CounterRng rng(1);
    for (int i = 0; i < 20000; ++i) {
        const Motion path{{2, rng.in(0.1, 1)}, {rng.in(-1, 1), rng.in(-4, 3)}, {0, -9.81}};
        const double gap = path.position.y() - r - band.target(), v = path.velocity.y();
        const double expected = (v + std::sqrt(v * v + 2 * 9.81 * gap)) / 9.81;
        const FieldSweep found = swept.sweep(path, 1.5, r, band, ground_layer, 1, stats);
        if (expected < 1.5 && std::fabs(path.at(expected).x() - 2) < 1.9) REQUIRE(relative_error(found.hit.time, expected) < 1e-9);
    }
    CHECK(stats.capped == 0);
}

TEST_CASE("the tangent plane's time never exceeds the true time of impact with a disc, and the sweep finds that time") {
    const ProgramPtr program = both("  - circle: {radius: 0.04}\n").lowered;
    const SweptField swept(program->fixed);
    SweepStats stats;
    CounterRng rng(2);
    int hits = 0, wrong = 0, late_planes = 0;
    for (int i = 0; i < 200000; ++i) {
        const Motion path = random_motion(rng, 3, 9.81);
        const double start = length(path.position);
        if (start < 0.04 + r + 1e-6) continue;
        const double duration = 0.1;
        const FieldSweep found = swept.sweep(path, duration, r, band, ground_layer, 0.3, stats);
        const double time = found.hit.time;
        const auto gap = [&](double t) { return length(path.at(t)) - 0.04 - r; };
        if (time <= duration) {
            ++hits;
            if (!(gap(time) > 0 && gap(time) < 1e-7)) ++wrong;
            const Vec2 n = path.position / start;
            const double plane = first_zero(start - 0.04 - r, dot(n, path.velocity), dot(n, path.acceleration));
            for (int k = 0; k <= 20; ++k)
                if (plane < infinity && gap(std::min(plane, duration) * k / 20) < -1e-12) ++late_planes;
        }
        for (int k = 0; k <= 40; ++k) {
            const double t = std::min(time, duration) * k / 40;
            if (gap(t) < 0) ++wrong;
        }
    }
    CHECK(hits > 10000);
    CHECK(wrong == 0);
    CHECK(late_planes == 0);
    CHECK(stats.capped == 0);
}

TEST_CASE("closed forms, safe-time advancement and dense sampling agree on every shape") {
    const std::string nodes[] = {
        "  - box: {size: [0.12, 0.05], turn: 20}\n",
        "  - box: {size: [0.12, 0.06], round: 0.02, turn: -30}\n",
        "  - capsule: {length: 0.1, radius: 0.015, turn: 10}\n",
        "  - uneven_capsule: {length: 0.07, radius_a: 0.02, radius_b: 0.008}\n",
        "  - triangle: {a: [-0.05, -0.04], b: [0.06, -0.02], c: [0, 0.05]}\n",
        "  - difference: {children: [circle: {radius: 0.09}, circle: {radius: 0.06}, box: {size: [0.2, 0.06], at: [0.1, 0]}]}\n",
        "  - union: {children: [box: {size: [0.1, 0.02]}, box: {size: [0.02, 0.1]}, circle: {radius: 0.02, at: [0.04, 0.04]}]}\n",
        "  - intersection: {children: [circle: {radius: 0.07, at: [-0.03, 0]}, circle: {radius: 0.07, at: [0.03, 0]}]}\n",
    };
    CounterRng rng(3);
    for (const std::string& node : nodes) {
        INFO(node);
        const Both programs = both(node);
        const SweptField pieces(programs.lowered->fixed), tree(programs.tree->fixed);
        SweepStats stats, tree_stats;
        int hits = 0, missed = 0, overlaps = 0, too_early = 0;
        for (int i = 0; i < 16000; ++i) {
            const Motion path = random_motion(rng, i % 2 ? 3 : 40, i % 3 ? 9.81 : 0);
            if (nearest(programs.lowered->fixed, path.position).distance < r + 2e-7) continue;
            const double duration = 0.02;
            const FieldSweep a = pieces.sweep(path, duration, r, band, ground_layer, path.travel(duration), stats);
            const double truth = sampled(programs.lowered->fixed, path, duration, 60);
            if (truth < std::min(a.hit.time, duration)) ++missed;
            if (a.hit.time <= duration) {
                ++hits;
                const double gap = nearest(programs.lowered->fixed, path.at(a.hit.time)).distance - r;
                if (gap < 0) ++overlaps;
                if (gap > 1e-7) ++too_early;
            }
            // A tree of max() is only a bound near its edges (a mitre): a ball is never let into that zone, so none starts there.
            if (i % 4 || nearest(programs.tree->fixed, path.position).distance < r + 2e-7) continue;
            const FieldSweep b = tree.sweep(path, duration, r, band, ground_layer, path.travel(duration), tree_stats);
            if (truth < std::min({b.hit.time, b.clear_until, duration})) ++missed;
            // The tree may stop early, where it is only a bound; when it goes on past the other's contact, that was a graze.
            const double until = std::min({b.hit.time, b.clear_until, duration});
            for (int k = 0; k <= 100 && until > a.hit.time; ++k)
                if (nearest(programs.lowered->fixed, path.at(a.hit.time + (until - a.hit.time) * k / 100)).distance < r) ++missed;
        }
        CHECK(hits > 300);
        CHECK(missed == 0);
        CHECK(overlaps == 0);
        CHECK(too_early == 0);
        CHECK(stats.capped == 0);
    }
}

TEST_CASE("a ball hit by a bat that comes and goes within the tick is found") {
    const ProgramPtr program = program_of(
        "pinfield: 1\ntable: {size: [4, 4], slope: 0}\ninputs: {left: [Z]}\nscene:\n"
        "  - flipper: {id: f, at: [2, 2], length: 0.2, radius_pivot: 0.01, radius_tip: 0.01, rest: -90, swing: 180, input: [left]}\n");
    const SweptField swept(program->movers[0].field);
    MoverState state;
    state.q = -1;
    state.rate = 2000;  // sweeps two radians in a millisecond
    const Vec2 tip(2 + 0.21 + r - 1e-4, 2);
    SweepStats stats;
    const MoverHit hit = sweep_mover(swept, program->movers[0], state, {tip, {0, 0}, {0, 0}}, 1e-3, r, band, ground_layer, stats);
    CHECK(hit.hit.time < 0.5e-3);
    CHECK(hit.hit.time > 0.3e-3);
    const Vec2 clear(2 + 0.21 + r + 1e-4, 2);
    CHECK(sweep_mover(swept, program->movers[0], state, {clear, {0, 0}, {0, 0}}, 1e-3, r, band, ground_layer, stats).hit.time == infinity);
}

TEST_CASE("the sweep against a turning bat never misses what dense sampling finds") {
    const ProgramPtr program = program_of(
        "pinfield: 1\ntable: {size: [4, 4], slope: 0}\ninputs: {left: [Z]}\nscene:\n  - flipper: {id: f, at: [2, 2], input: [left]}\n");
    const Mover& mover = program->movers[0];
    const SweptField swept(mover.field);
    CounterRng rng(5);
    SweepStats stats;
    int hits = 0, missed = 0, overlaps = 0;
    for (int i = 0; i < 40000; ++i) {
        MoverState state;
        state.q = rng.in(-1, 1);
        state.rate = rng.in(-80, 80);
        state.acceleration = rng.in(-4000, 4000);
        Motion ball = random_motion(rng, 10, 1);
        ball.position = mover.pivot + 0.6 * ball.position;
        const auto gap = [&](double t) {
            const Pose pose = pose_of(mover, state.q + state.rate * t + 0.5 * state.acceleration * t * t);
            return nearest(mover.field, pose.place_from_world(ball.at(t))).distance - r;
        };
        if (gap(0) < 2e-7) continue;
        const double duration = 2e-3;
        const MoverHit found = sweep_mover(swept, mover, state, ball, duration, r, band, ground_layer, stats);
        const double until = std::min({found.hit.time, found.clear_until, duration});
        for (int k = 0; k <= 60; ++k)
            if (gap(until * k / 60) < 0) ++missed;
        if (found.hit.time <= duration) {
            ++hits;
            if (gap(found.hit.time) > 1e-7) ++overlaps;
        }
    }
    CHECK(hits > 1000);
    CHECK(missed == 0);
    CHECK(overlaps == 0);
    CHECK(stats.capped == 0);
}

TEST_CASE("a ball that follows a wall in contact stays outside where the wall bends into a hollow") {
    // Walls that join smoothly: the next piece must be met at the join, not one tick into it.
    for (const double speed : {0.5, 1.8, 10.0, 100.0})
        for (const std::string integrator : {"ballistic", "symplectic_euler"}) {
            INFO(speed << " m/s, " << integrator);
            World world(program_of("pinfield: 1\ntable: {size: [1, 1], slope: 6.5}\nphysics: {integrator: " + integrator +
                                   "}\nmaterials: {default: {restitution: 0.3, falloff: 0.3}}\nscene:\n"
                                   "  - domain: {children: [box: {size: [1, 1], round: 0.25, at: [0.5, 0.5]}]}\n"));
            const double away[] = {1e-9, 2e-8, 6e-8, 9e-8};
            for (int i = 0; i < 4; ++i) world.add_ball({1 - r - away[i], 0.5 + 0.01 * i}, {0, speed});
            for (int i = 0; i < 400; ++i) {
                world.step();
                for (const Ball& ball : world.balls()) REQUIRE(gap_at(world, ball.position).distance - r > -1e-12);
            }
        }
}

// A list remembered from sweep to sweep is a shortcut only: what is found has the same bits as with a search each time, also
// for several things at the same distance and for what is marched as a tree.
TEST_CASE("a sweep with remembered neighbours finds the same to the bit") {
    std::string nodes = "  - half_plane: {at: [0.1, 0.1], turn: 20}\n";
    CounterRng rng(12);
    for (int i = 0; i < 40; ++i) {
        const std::string at = "at: [" + std::to_string(rng.in(0.2, 0.9)) + ", " + std::to_string(rng.in(0.2, 0.9)) + "]";
        nodes += i % 2 ? "  - circle: {radius: 15mm, " + at + "}\n"
                       : "  - box: {size: [30mm, 30mm], turn: " + std::to_string(i) + ", " + at + "}\n";
    }
    const ProgramPtr program = program_of(room(1, 1, "", "", nodes));
    const SweptField swept(program->fixed);
    Neighbours near;
    SweepStats stats;
    Vec2 p(0.5, 0.5);
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const double speed = i % 50 == 0 ? 60 : 3, duration = 1e-3;  // now and then it jumps out of its list
        Motion path = random_motion(rng, speed, i % 2 ? 9.81 : 0);
        path.position = p;
        const FieldSweep listed = swept.sweep(path, duration, r, band, ground_layer, r, stats, &near);
        const FieldSweep searched = swept.sweep(path, duration, r, band, ground_layer, r, stats);
        REQUIRE(listed.hit.time == searched.hit.time);
        REQUIRE(listed.hit.piece == searched.hit.piece);
        REQUIRE(listed.hit.solid == searched.hit.solid);
        REQUIRE(listed.hit.normal == searched.hit.normal);
        REQUIRE(listed.free_path == searched.free_path);
        REQUIRE(listed.clear_until == searched.clear_until);
        hits += listed.hit.time <= duration ? 1 : 0;
        p = path.at(std::min(duration, listed.hit.time));
    }
    CHECK(hits > 300);
}
