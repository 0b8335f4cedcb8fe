// Pockets against closed forms, and against balls that are let roll.
#include "engine/game/pockets.h"

#include "engine/core/at.h"
#include "engine/core/rng.h"
#include "engine/physics/world.h"
#include "tests/physics/support.h"

using namespace pinfield;
using namespace pinfield::physics_test;

namespace {

constexpr double r = 0.0135;

const std::string sloped = "pinfield: 1\ntable: {size: [0.5, 0.6], slope: 6.5}\nmaterials: {default: {restitution: 0, friction: 0}}\ninputs: {left: [Z]}\nscene:\n";
/// Takes what comes down.
const std::string pit = "  - drain: {at: [0.25, 0.02], size: [0.5, 40mm]}\n";

std::vector<Pocket> pockets_in(const std::string& nodes) { return pockets_of(*program_of(sloped + nodes)); }

std::string number(double x) { return std::to_string(x); }

/// Does a push by a tenth of its radius let the ball go? Then it lay on a ripple.
bool is_ripple(const ProgramPtr& program, const Vec2& place) {
    for (const double side : {-0.1, 0.1}) {
        World world(program);
        Vec2 aside = place + Vec2(side * r, 0);
        for (int k = 0; k < 20; ++k) {
            const auto gap = gap_at(world, aside);
            if (gap.distance < r) aside += (r + 1e-7 - gap.distance) * gap.gradient;
        }
        world.add_ball(aside, {0, 0});
        for (int t = 0; t < 5000; ++t) world.step();
        if (length(world.balls()[0].position - place) > 0.5 * r) return true;
    }
    return false;
}

}  // namespace

// Centres 60 mm apart, radii 24 mm: a ball lies sqrt(37.5^2 - 30^2) = 22.5 mm above them.
TEST_CASE("two discs hold a ball where geometry says, unless they are too far apart or too near the drain's way") {
    const auto discs = [](double apart) {
        return pit + "  - circle: {at: [" + number(0.25 - apart / 2) + ", 0.3], radius: 24mm}\n  - circle: {at: [" + number(0.25 + apart / 2) +
               ", 0.3], radius: 24mm}\n";
    };
    const std::vector<Pocket> found = pockets_in(discs(0.06));
    REQUIRE(found.size() == 1);
    CHECK(length(found[0].place - Vec2(0.25, 0.3225)) < 2e-4);
    CHECK(found[0].nodes.size() == 2);
    CHECK(pockets_in(discs(0.0745)).size() == 1);  // 26.5 mm between them, a ball has 27
    CHECK(pockets_in(discs(0.0755)).empty());
}

TEST_CASE("a cup, a level shelf and a floor hold balls, a tilted shelf and a dome do not") {
    CHECK(pockets_in(pit + "  - box: {size: [0.1, 0.02], at: [0.25, 0.3]}\n").size() == 1);
    CHECK(pockets_in(pit + "  - box: {size: [0.1, 0.02], at: [0.25, 0.3], turn: 2}\n").empty());
    CHECK(pockets_in(pit + "  - circle: {radius: 0.1, at: [0.25, 0.3]}\n").empty());
    CHECK(pockets_in(pit + "  - arc: {radius: 60mm, from: 200, to: 340, thickness: 8mm, at: [0.25, 0.3]}\n").size() == 1);
    CHECK(pockets_in("  - circle: {radius: 0.05, at: [0.25, 0.3]}\n").size() == 1);  // the floor
    CHECK(pockets_in(pit + "  - box: {size: [0.1, 0.02], at: [0.05, 0.3], turn: 20}\n").size() == 1);  // against the wall
}

TEST_CASE("a bumper that kicks at every touch keeps no ball, one that waits for a hit does") {
    const auto cup = [](const std::string& fields) {
        return pit + "  - bumper: {" + fields + ", children: [arc: {radius: 60mm, from: 200, to: 340, thickness: 8mm, at: [0.25, 0.3]}]}\n";
    };
    CHECK(pockets_in(cup("threshold: 0")).empty());
    CHECK(pockets_in(cup("threshold: 0.05")).size() == 1);
    CHECK(pockets_in(cup("threshold: 0, kick: 0")).size() == 1);
}

TEST_CASE("what a flipper reaches, what no ball reaches, and what lies on a level table are no pockets") {
    const std::string bowl = "  - arc: {radius: 60mm, from: 180, to: 360, thickness: 8mm, at: [0.25, 0.3]}\n";
    CHECK(pockets_in(pit + bowl).size() == 1);
    CHECK(pockets_in(pit + bowl + "  - flipper: {at: [0.2, 0.262], rest: 0, swing: 40, length: 50mm, input: [left]}\n").empty());
    CHECK(pockets_in(pit + "  - onion: {thickness: 8mm, children: [circle: {radius: 60mm, at: [0.25, 0.3]}]}\n  - spawn: {at: [0.1, 0.5]}\n").empty());
    CHECK(pockets_of(*program_of("pinfield: 1\ntable: {size: [0.5, 0.6], slope: 0}\nscene:\n" + bowl)).empty());
}

TEST_CASE("whatever place a slow ball comes to on random tables is a pocket, and a ball laid into a pocket stays") {
    int rested = 0, laid = 0;
    for (std::uint64_t n = 0; n < 40; ++n) {
        CounterRng rng(n, 0x90c8e7);
        std::string text = sloped + pit;
        for (int k = 0; k < 8; ++k) {
            const double x = rng.in(0.05, 0.45), y = rng.in(0.15, 0.5), turn = rng.in(0, 360), size = k % 2 ? rng.in(0.03, 0.1) : rng.in(0.015, 0.04);
            text += (k % 2 ? "  - box: {size: [" + number(size) + ", 12mm]" : "  - ellipse: {radii: [" + number(size) + ", 15mm]") + ", at: [" + number(x) +
                    ", " + number(y) + "], turn: " + number(turn) + "}\n";
        }
        const ProgramPtr program = program_of(text);
        const std::vector<Pocket> pockets = pockets_of(*program);
        const auto nearest_pocket = [&](const Vec2& p) {
            double least = infinity;
            for (const Pocket& pocket : pockets) least = std::min(least, length(pocket.place - p));
            return least;
        };
        INFO("table " << n << '\n' << text);
        for (int k = 0; k < 18; ++k) {  // balls that are let go lose their speed at the first thing they meet
            World world(program);
            const Vec2 from{rng.in(0.02, 0.48), rng.in(0.15, 0.58)};
            if (gap_at(world, from).distance < r) continue;
            world.add_ball(from, {0, 0});
            for (int t = 0; t < 20000 && world.balls()[0].state == BallState::rolling; ++t) world.step();
            if (world.balls()[0].state != BallState::resting || is_ripple(program, world.balls()[0].position)) continue;
            ++rested;
            INFO("rests at " << world.balls()[0].position.transpose() << ", let go at " << from.transpose());
            CHECK(nearest_pocket(world.balls()[0].position) < 0.5 * r);
        }
        for (const Pocket& pocket : pockets) {
            World world(program);
            world.add_ball(pocket.place, {0, 0});
            for (int t = 0; t < 1000; ++t) world.step();
            ++laid;
            CHECK(length(world.balls()[0].position - pocket.place) < 0.5 * r);
        }
    }
    CHECK(rested > 20);
    CHECK(laid > 40);
}
