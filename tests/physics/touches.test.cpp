// One touch, one hit: what impulses come to for players, ears and counters.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "engine/core/at.h"
#include "engine/core/rng.h"
#include "engine/core/trig.h"
#include "tests/physics/support.h"

using namespace pinfield;
using namespace pinfield::physics_test;

namespace {

constexpr double r = 0.0135, mass = 0.08;

/// Events of a run by kind.
struct Tally {
    std::map<EventKind, std::vector<Event>> of;
    std::size_t operator[](EventKind kind) const { return of.contains(kind) ? of.at(kind).size() : 0; }
    void take(const World& world) {
        for (const Event& event : world.events()) of[event.kind].push_back(event);
    }
};

Tally run(World& world, double seconds) {
    Tally tally;
    for (const double end = world.time() + seconds; world.time() < end - 1e-9;) {
        world.step();
        tally.take(world);
    }
    return tally;
}

WorldOptions with(Integrator integrator) {
    WorldOptions options;
    options.integrator = integrator;
    return options;
}

constexpr Integrator both[] = {Integrator::symplectic_euler, Integrator::ballistic};

std::string number(double x) { return std::to_string(x); }

/// Walls, bumpers that kick at any touch and others, a narrow chute, beating bats, a plunger that jams what is in its way, a drain.
/// Each number is drawn in a statement of its own: the order in a sum is the compiler's.
std::string random_table(CounterRng& rng) {
    const auto drawn = [&](double lo, double hi) { return number(rng.in(lo, hi)); };
    const auto place = [&] {
        const std::string x = drawn(0.05, 0.45), y = drawn(0.1, 0.55);
        return "at: [" + x + ", " + y + "]";
    };
    const std::string slope = drawn(0, 30), restitution = drawn(0, 1), friction = drawn(0, 0.5);
    std::string text = "pinfield: 1\ntable: {size: [0.5, 0.6], slope: " + slope + "}\ninputs: {a: [Z], b: [Slash]}\n" +
                       "materials: {default: {restitution: " + restitution + ", friction: " + friction + "}}\nscene:\n";
    for (int k = 0; k < 3; ++k) {
        const std::string at = place(), threshold = rng.in(0, 1) < 0.3 ? "0" : drawn(0, 0.1), kick = drawn(0, 2);
        text += fmt::format("  - bumper: {{{}, threshold: {}, kick: {}}}\n", at, threshold, kick);
    }
    for (int k = 0; k < 2; ++k) {
        const std::string at = place(), width = drawn(0.02, 0.2), turn = drawn(0, 180);
        text += fmt::format("  - box: {{size: [{}, 10mm], turn: {}, {}}}\n", width, turn, at);
    }
    for (const char* const node : {"ellipse: {radii: [50mm, 30mm]", "flipper: {input: [a]", "flipper: {input: [b], flip: x"})
        text += fmt::format("  - {}, {}}}\n", node, place());
    const std::string at = place(), turn = drawn(0, 360);
    return text + "  - plunger: {input: [b], turn: " + turn + ", " + at + "}\n  - drain: {at: [0.25, 0.01], size: [0.2, 20mm]}\n";
}

/// A ball, what it touches, and from which side (eighths of a turn): begins and ends of touches.
using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;
Key key_of(BallId ball, NodeId node, BallId other) { return {ball.value, node.value, other.value}; }

/// Begins and ends of all touches in order; every count that may not be.
struct Books {
    std::map<Key, std::int64_t> open;
    std::map<std::uint32_t, std::int64_t> told;  ///< hits by ball
    bool sound = true;

    void take(const World& world) {
        std::map<std::uint32_t, int> in_tick;
        for (const Event& event : world.events()) {
            const bool begins = event.kind == EventKind::hit || event.kind == EventKind::ball_hit;
            std::int64_t& count = open[key_of(event.ball, event.node, event.other)];
            if (begins) ++count, ++told[event.ball.value];
            if (event.kind == EventKind::leave) --count;
            sound = sound && count >= 0;
            if (begins || event.kind == EventKind::kick) sound = sound && ++in_tick[event.ball.value] <= 32;
        }
    }
    /// Does what is open agree with what the world says is touched?
    bool agrees(const World& world) const {
        std::map<Key, std::int64_t> touched;
        for (const BallTouch& touch : world.touches())
            if (touch.told) ++touched[key_of(touch.ball, touch.node, touch.other)];
        for (const auto& [key, count] : open) {
            const auto found = touched.find(key);
            if (count != (found == touched.end() ? 0 : found->second)) return false;
        }
        return true;
    }
};

/// How fast each ball was of late, and when it hit each side of what stands still.
class Intervals {
public:
    /// A touch is over after 10 ms, or once the ball has flown 0.8 of its radius off: who hits the same side again any sooner is fast.
    void take(const World& world) {
        for (const Ball& ball : world.balls()) note_speed(ball.id, length(ball.velocity));
        for (const Event& event : world.events()) note_speed(event.ball, event.speed);
        for (const Event& event : world.events()) {
            if (event.kind != EventKind::hit || (event.part >= 0 && at(world.program().parts, event.part).mover >= 0)) continue;
            std::vector<Event>& before = hits_[{event.ball.value, event.node.value}];
            for (const Event& hit : before) {
                const double between = event.time - hit.time;
                if (dot(hit.normal, event.normal) > 0.7 && between < 0.0099 && 1.25 * fastest(event.ball) * between < 0.8 * r) ++too_soon;
            }
            std::erase_if(before, [&](const Event& hit) { return event.time - hit.time > 0.01; });
            before.push_back(event);
        }
        ++tick_;
        for (auto& [ball, speeds] : speeds_) std::erase_if(speeds, [&](const auto& noted) { return noted.first + 12 < tick_; });
    }
    int too_soon = 0;

private:
    void note_speed(BallId ball, double speed) { speeds_[ball.value].emplace_back(tick_, speed); }
    double fastest(BallId ball) const {
        double out = 0;
        for (const auto& [tick, speed] : speeds_.at(ball.value))
            if (tick + 12 > tick_) out = std::max(out, speed);
        return out;
    }

    int tick_ = 0;
    std::map<std::uint32_t, std::vector<std::pair<int, double>>> speeds_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Event>> hits_;
};

/// A touch lasts until there was no impulse for 10 ms, or the ball flew 0.8 of its radius off the surface: so many there can be a second, on
/// the three surfaces that a ball may meet in turn.
double most_hits(double speed, double seconds) { return 3 * seconds * (100 + speed / (0.8 * r)); }

void check_law(std::uint64_t first, std::uint64_t count) {
    for (std::uint64_t n = first; n < first + count; ++n) {
        CounterRng rng(n, 0x70c4e5);
        World world(program_of(random_table(rng)), with(both[n % 2]));
        for (int k = 0; k < 4; ++k) {
            const Vec2 place{rng.in(0.05, 0.45), rng.in(0.1, 0.55)};
            if (gap_at(world, place).distance > r) world.add_ball(place, {rng.in(-3, 3), rng.in(-3, 3)});
        }
        Books books;
        Intervals intervals;
        double fastest = 0;
        for (int t = 0; t < 2000; ++t) {
            if (rng.in(0, 1) < 0.02) {
                const int input = rng.in(0, 2) < 1 ? 0 : 1;
                world.set_input(input, rng.in(0, 1) < 0.5);
            }
            world.step();
            books.take(world);
            intervals.take(world);
            for (const Ball& ball : world.balls()) fastest = std::max(fastest, length(ball.velocity));
            if (t % 100 == 0) CHECK(books.agrees(world));
        }
        INFO("table " << n);
        CHECK(books.sound);
        CHECK(books.agrees(world));
        CHECK(intervals.too_soon == 0);
        for (const auto& [ball, told] : books.told) CHECK(static_cast<double>(told) <= most_hits(fastest, 2));
    }
}

/// Hits of the only mover.
std::size_t hits_of_bat(Tally& tally, const World& world) {
    const std::vector<Event>& hits = tally.of[EventKind::hit];
    return static_cast<std::size_t>(std::count_if(hits.begin(), hits.end(), [&](const Event& event) { return event.part == at(world.program().movers, 0).part; }));
}

}  // namespace

TEST_CASE("touches begin and end in pairs, and are no more a second than can be, on thirty random tables") { check_law(0, 30); }

TEST_CASE("touches begin and end in pairs, and are no more a second than can be, on a thousand random tables", "[slow]") { check_law(30, 1000); }

TEST_CASE("one push of a bat is one hit, and none when the ball lies on it") {
    for (const Integrator integrator : both) {
        World world(program_of("pinfield: 1\ntable: {size: [0.5, 1], slope: 6.5}\ninputs: {left: [Z]}\nscene:\n  - flipper: {id: bat, at: [0.2, 0.3], rest: "
                               "-30, swing: 51, input: [left]}\n  - box: {id: stop, size: [10mm, 60mm], turn: -30, at: [0.262, 0.299]}\n"),
                    with(integrator));
        world.add_ball({0.235, 0.31}, {0, 0});
        Tally lying = run(world, 2);
        world.set_input(0, 1);
        Tally pushed = run(world, 0.3);
        INFO("integrator " << static_cast<int>(integrator));
        CHECK(hits_of_bat(lying, world) >= 1);  // it came bouncing
        CHECK(hits_of_bat(pushed, world) == 0);
        CHECK(length(world.balls()[0].velocity) > 0.5);
        for (int late = 0; late < 20; ++late) {  // a ball that meets the bat on its way
            World falling(world.shared_program(), with(integrator));
            falling.add_ball({0.25, 0.33}, {0, -0.5});
            Tally tally = run(falling, 0.001 * late);
            falling.set_input(0, 1);
            const Tally rest = run(falling, 0.05);
            for (const auto& [kind, events] : rest.of) tally.of[kind].insert(tally.of[kind].end(), events.begin(), events.end());
            CHECK(hits_of_bat(tally, falling) == 1);
        }
    }
}

TEST_CASE("a ball that runs round a loop hits it once and rolls, however many pieces the loop has") {
    for (const Integrator integrator : both)
        for (const std::string loop : {"circle: {radius: 0.2, at: [0.5, 0.5]}", "ellipse: {radii: [0.2, 0.15], at: [0.5, 0.5]}",
                                       "regular_polygon: {sides: 64, radius: 0.2, at: [0.5, 0.5]}"}) {
            World world(program_of("pinfield: 1\ntable: {size: [1, 1], slope: 6.5}\nmaterials: {default: {restitution: 0.3}}\nscene:\n  - domain: {children: [" +
                                   loop + "]}\n"),
                        with(integrator));
            world.add_ball({0.5, 0.5 - (loop[0] == 'e' ? 0.15 : 0.1997) + r + 1e-4}, {4, -0.05});
            const Tally tally = run(world, 0.3);
            INFO(loop << ", integrator " << static_cast<int>(integrator));
            CHECK(tally[EventKind::hit] == 1);
            CHECK(tally[EventKind::leave] == 0);
            REQUIRE(world.touches().size() == 1);
            CHECK(std::fabs(world.touches()[0].along) == Approx(length(world.balls()[0].velocity)).epsilon(0.1));
        }
}

// Statics: m g cos(a) presses, and what rolls does not slip.
TEST_CASE("a rolling ball is told with its load and without slip, a sliding one with its slip") {
    for (const Integrator integrator : both)
        for (const double friction : {1.0, 0.0}) {
            World world(program_of("pinfield: 1\ntable: {size: [4, 4], slope: 30}\nmaterials: {default: {restitution: 0, friction: " + number(friction) +
                                   "}}\nscene:\n  - half_plane: {at: [2, 2], turn: 20}\n"),
                        with(integrator));
            const double a = radians(20), g = -world.program().physics.gravity.y();
            world.add_ball(Vec2(2, 2) + (r + 1e-7) * Vec2(-std::sin(a), std::cos(a)), {0, 0});
            const Tally tally = run(world, 0.5);
            REQUIRE(world.touches().size() == 1);
            const BallTouch& touch = world.touches()[0];
            INFO("integrator " << static_cast<int>(integrator) << ", friction " << friction);
            CHECK(touch.load == Approx(mass * g * std::cos(a)).epsilon(1e-3));
            CHECK(std::fabs(touch.along) == Approx(length(world.balls()[0].velocity)).epsilon(1e-2));
            CHECK(std::fabs(touch.slip) == Approx(friction > 0 ? 0 : std::fabs(touch.along)).margin(1e-2 * std::fabs(touch.along)));
            CHECK_FALSE(touch.told);  // it was laid there
            CHECK(tally.of.empty());
        }
}

TEST_CASE("a touch tells its hardest impulse and how long it lasted when it ends") {
    World world(program_of("pinfield: 1\ntable: {size: [1, 1], slope: 0}\nmaterials: {default: {restitution: 0.5}}\nscene:\n  - box: {id: wall, size: [0.2, 0.02], "
                           "at: [0.5, 0.5]}\n"));
    world.add_ball({0.5, 0.51 + r + 0.05}, {0, -1});
    const Tally tally = run(world, 0.3);
    REQUIRE(tally[EventKind::hit] == 1);
    REQUIRE(tally[EventKind::leave] == 1);
    const Event &hit = tally.of.at(EventKind::hit)[0], &leave = tally.of.at(EventKind::leave)[0];
    CHECK(leave.speed == Approx(1));
    CHECK(leave.duration == 0);
    CHECK((leave.node == hit.node && leave.material == hit.material));
    CHECK(leave.time > hit.time);
    CHECK(leave.time < hit.time + 0.012);
}

TEST_CASE("a jam is one hit and one jam, and the ball that stands has no speed") {
    for (const Integrator integrator : both) {
        World world(program_of("pinfield: 1\ntable: {size: [0.5, 1], slope: 0}\ninputs: {pull: [Space]}\nscene:\n  - plunger: {id: rod, at: [0.25, 0.2], stroke: "
                               "40mm, speed: 3, input: [pull]}\n  - box: {id: lid, size: [0.1, 0.02], at: [0.25, 0.23]}\n"),
                    with(integrator));
        world.set_input(0, 1);
        run(world, 0.7);
        world.add_ball({0.25, 0.19}, {0, 0});
        world.set_input(0, 0);
        const Tally tally = run(world, 0.5);
        INFO("integrator " << static_cast<int>(integrator));
        CHECK(tally[EventKind::jam] == 1);
        CHECK(tally[EventKind::hit] <= 4);
        CHECK(world.balls()[0].state == BallState::jammed);
        CHECK(world.balls()[0].velocity == Vec2(0, 0));
    }
}

TEST_CASE("an end-stop is met once a stroke, however often the bat rebounds") {
    World world(program_of("pinfield: 1\ntable: {size: [0.5, 1], slope: 6.5}\ninputs: {left: [Z]}\nscene:\n  - flipper: {at: [0.2, 0.3], input: [left], stop_bounce: "
                           "0.6}\n"));
    for (int stroke = 0; stroke < 6; ++stroke) {
        world.set_input(0, stroke % 2 == 0 ? 1 : 0);
        const Tally tally = run(world, 1);
        CHECK(tally[EventKind::end_stop] == 1);
    }
}

TEST_CASE("more hits and kicks of a ball in a tick than anybody would read are told as a flood, which names the node") {
    WorldOptions options;
    options.restitution = 1;
    World world(program_of("pinfield: 1\ntable: {size: [1, 1], slope: 0}\nscene:\n  - box: {id: left, size: [0.02, 0.5], at: [0.4, 0.5]}\n"
                           "  - box: {id: right, size: [0.02, 0.5], at: [0.46, 0.5]}\n"),
                options);
    world.add_ball({0.43, 0.5}, {1000, 0});
    for (int t = 0; t < 20; ++t) {
        Tally tally = run(world, 1e-3);
        CHECK(tally[EventKind::hit] == 32);  // of 1 m / 13 mm
        REQUIRE(tally[EventKind::flood] == 1);
        CHECK(tally.of[EventKind::flood][0].node);
        CHECK(tally[EventKind::leave] <= 32);
    }
}

TEST_CASE("two balls that meet and part tell it once, by both their ids") {
    World world(program_of("pinfield: 1\ntable: {size: [1, 1], slope: 0}\nscene: []\n"));
    const BallId first = world.add_ball({0.4, 0.5}, {0.5, 0}), second = world.add_ball({0.6, 0.5}, {-0.5, 0});
    const Tally tally = run(world, 0.4);
    REQUIRE(tally[EventKind::ball_hit] == 1);
    REQUIRE(tally[EventKind::leave] == 1);
    for (const EventKind kind : {EventKind::ball_hit, EventKind::leave}) {
        const Event& event = tally.of.at(kind)[0];
        CHECK((event.ball == first && event.other == second));
        CHECK(event.speed == Approx(1));
        CHECK(event.normal.x() == Approx(-1));
    }
}
