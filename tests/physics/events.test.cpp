// Events say which part and which surface they are about.
#include <vector>

#include "engine/core/at.h"
#include "tests/physics/support.h"

using namespace pinfield;
using namespace pinfield::physics_test;

namespace {

/// The first event of this kind within two seconds.
Event first(World& world, EventKind kind) {
    for (int t = 0; t < 2000; ++t) {
        world.step();
        for (const Event& event : world.events())
            if (event.kind == kind) return event;
    }
    FAIL("no " << name(kind));
    return {};
}

std::string part_of(const World& world, const Event& event) {
    return event.part < 0 ? "" : at(world.program().parts, event.part).name;
}
std::string material_of(const World& world, const Event& event) {
    return event.material < 0 ? "" : at(world.program().materials, event.material).name;
}

const std::string table =
    "pinfield: 1\ntable: {size: [1, 1], slope: 0}\ninputs: {left: [Z], plunge: [Space]}\n"
    "materials: {rubber: {restitution: 0.8}, steel: {restitution: 0.5}}\nscene:\n"
    "  - domain: {id: air, material: steel, children: [box: {size: [1, 1], at: [0.5, 0.5]}]}\n"
    "  - bumper: {id: pop, at: [0.2, 0.5], radius: 24mm, material: rubber}\n  - circle: {id: plain, at: [0.5, 0.5], radius: 24mm}\n"
    "  - union: {id: pair, at: [0.5, 0.8], material: rubber, children: [box: {size: [40mm, 40mm]}, circle: {id: knob, radius: 10mm, at: "
    "[0.1, 0], material: steel}]}\n"
    "  - flipper: {id: bat, at: [0.75, 0.5], rest: 0, material: rubber, input: [left]}\n"
    "  - plunger: {id: rod, at: [0.5, 0.2], input: [plunge]}\n  - drain: {id: out, at: [0.2, 0.1], size: [0.1, 0.1]}\n";

}  // namespace

TEST_CASE("a hit and a kick name the part and the material of the surface, down to the leaf") {
    struct Case {
        Vec2 from;
        std::string part, material;
    };
    const std::vector<Case> cases{{{0.2, 0.56}, "pop", "rubber"}, {{0.5, 0.56}, "", "default"}, {{0.5, 0.86}, "", "rubber"},
                                  {{0.6, 0.86}, "", "steel"},     {{0.8, 0.56}, "bat", "rubber"}, {{0.5, 0.26}, "rod", "default"},
                                  {{0.95, 0.1}, "air", "steel"}};
    for (const Case& expected : cases) {
        World world(program_of(table));
        world.add_ball(expected.from, {0, -1});
        const Event hit = first(world, EventKind::hit);
        INFO(expected.from.transpose());
        CHECK(part_of(world, hit) == expected.part);
        CHECK(material_of(world, hit) == expected.material);
        for (const Event& event : world.events())
            if (event.kind == EventKind::kick) CHECK((event.part == hit.part && event.material == hit.material));
    }
}

TEST_CASE("events of parts name the part and no material") {
    World world(program_of(table));
    const auto check = [&](EventKind kind, const std::string& part) {
        const Event event = first(world, kind);
        CHECK(part_of(world, event) == part);
        if (event.part >= 0) CHECK(at(world.program().parts, event.part).origin == event.node);
        CHECK(event.material == -1);
    };
    world.set_input(0, 1);
    check(EventKind::press, "bat");
    check(EventKind::end_stop, "bat");
    world.set_input(0, 0);
    check(EventKind::release, "bat");
    world.set_input(1, 1);
    check(EventKind::press, "rod");
    for (int t = 0; t < 100; ++t) world.step();
    world.set_input(1, 0);
    check(EventKind::launch, "rod");
    world.add_ball({0.2, 0.3}, {0, -1});
    check(EventKind::drain, "out");
    world.add_ball({0.9, 0.9}, {0, 1});
    world.add_ball({0.9, 0.86}, {0, 2});
    check(EventKind::ball_hit, "");
}

TEST_CASE("a change of the program leaves no event behind whose parts are those of the old one") {
    World world(program_of(table));
    world.set_input(0, 1);
    world.step();
    REQUIRE_FALSE(world.events().empty());
    world.set_program(program_of(room(1, 1, "", "", "")));
    CHECK(world.events().empty());
}

TEST_CASE("a ball that meets the seam of two targets hits both") {
    World world(program_of("pinfield: 1\ntable: {size: [1, 1], slope: 0}\nscene:\n  - box: {id: a, size: [40mm, 10mm], at: [0.48, 0.2]}\n"
                           "  - box: {id: b, size: [40mm, 10mm], at: [0.52, 0.2]}\n"));
    world.add_ball({0.5, 0.3}, {0, -1});
    std::vector<Event> hits;
    for (int t = 0; t < 150 && hits.empty(); ++t) {
        world.step();
        for (const Event& event : world.events())
            if (event.kind == EventKind::hit) hits.push_back(event);
    }
    REQUIRE(hits.size() == 2);
    CHECK(hits[0].node != hits[1].node);
    CHECK(hits[0].speed == Approx(hits[1].speed));
}

TEST_CASE("a drain and a spawn of another layer leave the ground's balls alone") {
    World world(program_of("pinfield: 1\ntable: {size: [1, 1], slope: 0}\nscene:\n  - drain: {id: up, layer: [upstairs], at: [0.5, 0.5], size: [0.1, "
                           "0.1]}\n  - spawn: {at: [0.5, 0.8], velocity: [0, -1]}\n  - spawn: {layer: [upstairs], at: [0.5, 0.2], velocity: [0, 1]}\n"));
    world.add_spawned_balls();
    int meetings = 0;
    for (int t = 0; t < 500; ++t) {
        world.step();
        for (const Event& event : world.events()) meetings += event.kind == EventKind::ball_hit;
    }
    CHECK(meetings == 0);
    CHECK(world.balls()[0].state == BallState::rolling);
    CHECK(world.balls()[1].state == BallState::drained);
    const BallId upstairs = world.balls()[1].id;
    world.put_back(upstairs);
    CHECK(world.find(upstairs)->layer != ground_layer);
    for (int t = 0; t < 500; ++t) world.step();
    CHECK(world.find(upstairs)->state == BallState::drained);
}

TEST_CASE("a ball stays on its layer, known by its name, when an edit numbers the layers anew, and is on the ground when it is gone") {
    const auto layered = [](const std::string& first, const std::string& wall) {
        return program_of("pinfield: 1\ntable: {size: [1, 1], slope: 0}\nscene:\n" + first + "  - box: {id: up, layer: [" + wall +
                          "], at: [0.5, 0.2], size: [0.2, 0.02]}\n  - spawn: {layer: [" + wall + "], at: [0.5, 0.8], velocity: [0, -1]}\n");
    };
    const std::string attic = "  - circle: {layer: [attic], at: [0.5, 0.5], radius: 50mm}\n";
    World world(layered("", "upstairs"));
    world.add_spawned_balls();
    world.step();
    const LayerMask before = world.balls()[0].layer;
    world.set_program(layered(attic, "upstairs"));
    CHECK(world.balls()[0].layer != before);
    std::vector<Event> hits;
    for (int t = 0; t < 700 && hits.empty(); ++t) {
        world.step();
        for (const Event& event : world.events())
            if (event.kind == EventKind::hit) hits.push_back(event);
    }
    REQUIRE(hits.size() == 1);
    CHECK(hits[0].position.y() == Approx(0.21));  // past the attic's disc, at the box upstairs
    world.set_program(layered("", "cellar"));
    world.set_program(program_of("pinfield: 1\ntable: {size: [1, 1], slope: 0}\nscene: []\n"));
    CHECK(world.balls()[0].layer == ground_layer);
}
