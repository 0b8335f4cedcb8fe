// Balls that lie where nobody can play them are told, and searched for.
#include "engine/core/at.h"
#include "engine/scene/parts/bumper.h"
#include "tests/physics/support.h"

using namespace pinfield;
using namespace pinfield::physics_test;

namespace {

const std::string sloped = "pinfield: 1\ntable: {size: [0.5, 1], slope: 6.5}\ninputs: {left: [Z], pull: [Space]}\nscene:\n";

struct Found {
    std::vector<Event> stuck, kicks;
};

Found run(World& world, double seconds) {
    Found found;
    for (const double end = world.time() + seconds; world.time() < end - 1e-9;) {
        world.step();
        for (const Event& event : world.events()) {
            if (event.kind == EventKind::stuck) found.stuck.push_back(event);
            if (event.kind == EventKind::kick) found.kicks.push_back(event);
        }
    }
    return found;
}

constexpr Integrator both[] = {Integrator::symplectic_euler, Integrator::ballistic};

World world_of(const std::string& nodes, Integrator integrator) {
    WorldOptions options;
    options.integrator = integrator;
    return World(program_of(sloped + nodes), options);
}

/// Two bumpers between which a ball lies, 0.1 mm above them.
std::string notch(const std::string& more) {
    return "  - bumper: {id: a, at: [0.22, 0.5]" + more + "}\n  - bumper: {id: b, at: [0.28, 0.5]" + more + "}\n";
}
// Centres 60 mm apart, radii 24 + 13.5 mm: the ball lies 22.5 mm above them.
const Vec2 in_the_notch{0.2502, 0.5 + 0.0226};

}  // namespace

TEST_CASE("a bumper whose threshold is 0 kicks a ball that comes to it as slowly as can be") {
    for (const Integrator integrator : both) {
        World world = world_of(notch(", threshold: 0"), integrator);
        world.add_ball(in_the_notch, {0, 0});
        const Found found = run(world, 0.2);
        CHECK(found.kicks.size() >= 1);
        CHECK(world.balls()[0].position.y() > 0.55);
        World pile = world_of(notch(", threshold: 0"), integrator);  // two balls, settled together
        pile.add_ball(in_the_notch, {0, 0});
        pile.add_ball(in_the_notch + Vec2(0, 0.0271), {0, 0});
        CHECK(run(pile, 0.2).kicks.size() >= 1);
    }
}

TEST_CASE("a ball in a notch of two bumpers is told as stuck, at its place, after three seconds, and kicked out") {
    for (const Integrator integrator : both) {
        World world = world_of(notch(""), integrator);
        world.add_ball(in_the_notch, {0, 0});
        const Found lying = run(world, 2.9);
        CHECK(lying.stuck.empty());
        CHECK(lying.kicks.empty());
        const Found found = run(world, 0.3);
        REQUIRE(found.stuck.size() == 1);
        CHECK(length(found.stuck[0].position - Vec2(0.25, 0.5225)) < 1e-3);
        CHECK(at(world.program().parts, found.stuck[0].part).is<parts::Bumper>());
        CHECK(found.kicks.size() == 2);
        CHECK(length(world.balls()[0].velocity) > 0.5);
    }
}

TEST_CASE("a ball that nothing can kick is told once where it lies, and again only after it has moved") {
    for (const Integrator integrator : both) {
        World world = world_of("  - box: {id: shelf, size: [0.1, 0.02], at: [0.05, 0.5], turn: 20}\n", integrator);
        const BallId ball = world.add_ball({0.02, 0.53}, {0, 0});
        const Found found = run(world, 20);
        REQUIRE(found.stuck.size() == 1);
        CHECK(found.stuck[0].time < 6);
        CHECK(length(found.stuck[0].position - world.balls()[0].position) < 0.007);
        CHECK(found.stuck[0].node);
        world.set_ball(ball, {0.25, 0.3}, {0, 0});
        CHECK(run(world, 20).stuck.size() == 1);  // on the floor
    }
}

TEST_CASE("a ball that somebody can play is not stuck: on a plunger, on a bat, or on a ball that lies there") {
    for (const Integrator integrator : both) {
        World world = world_of("  - flipper: {at: [0.012, 0.2], rest: -30, swing: 51, input: [left]}\n  - plunger: {at: [0.4, 0.1], input: [pull]}\n"
                               "  - box: {size: [10mm, 0.2], at: [0.38, 0.15]}\n  - box: {size: [10mm, 0.2], at: [0.42, 0.15]}\n",
                               integrator);
        world.set_input(0, 1);
        for (int t = 0; t < 500; ++t) world.step();
        world.add_ball({0.03, 0.27}, {0, 0});
        world.add_ball({0.034, 0.3}, {0, 0});
        world.add_ball({0.4, 0.1136}, {0, 0});
        world.add_ball({0.4, 0.141}, {0, 0});
        CHECK(run(world, 15).stuck.empty());
        for (const Ball& ball : world.balls()) CHECK(length(ball.velocity) < 1e-2);
    }
}
