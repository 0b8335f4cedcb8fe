// Laws of similarity: what scaling by a power of two, mirroring and quarter turns may not change in a single bit.
#include <functional>

#include "engine/program/bvh.h"
#include "tests/physics/support.h"

using namespace pinfield;
using namespace pinfield::physics_test;

namespace {

/// The same program with everything that has a place mapped by `place`, and lengths multiplied by `scale`.
ProgramPtr mapped(const Program& from, double scale, bool reverses, const std::function<Vec2(const Vec2&)>& place) {
    auto out = std::make_shared<Program>(from);
    std::vector<Box2> boxes;
    for (BoundaryPiece& boundary : out->fixed.pieces) {
        sdf::Piece& p = boundary.piece;
        p.a = place(p.a);
        p.b = place(p.b);
        p.centre = place(p.centre);
        p.radius *= scale;
        if (reverses) {
            std::swap(p.a, p.b);
        }
        Box2 box = Box2::of(p.a, p.b);
        if (p.is_arc()) box = Box2{p.centre, p.centre}.grown(p.radius);
        boxes.push_back(box);
    }
    out->fixed.bvh = Bvh(boxes);
    PhysicsRecord& physics = out->physics;
    physics.gravity = place(physics.gravity);
    physics.ball_radius *= scale;
    physics.tolerance *= scale;
    physics.rest_speed *= scale;
    out->size *= scale;
    return out;
}

/// Posts, slabs and a wedge about the origin, in a box.
ProgramPtr garden() {
    return program_of(
        "pinfield: 1\ntable: {size: [1, 1], slope: 6.5}\nmaterials: {default: {restitution: 0.9, friction: 0.2, tangential: 0.3}}\nscene:\n"
        "  - domain: {children: [box: {size: [1, 1], round: 0.1}]}\n  - circle: {radius: 0.06, at: [0.2, 0.15]}\n"
        "  - box: {size: [0.2, 0.04], turn: 25, at: [-0.2, -0.1]}\n  - capsule: {length: 0.2, radius: 0.02, turn: -40, at: [0.15, -0.25]}\n"
        "  - triangle: {a: [-0.3, 0.2], b: [-0.1, 0.25], c: [-0.22, 0.36]}\n");
}

std::vector<Ball> played(const ProgramPtr& program, const std::function<Vec2(const Vec2&)>& place, bool reverses, Integrator integrator) {
    WorldOptions options;
    options.integrator = integrator;
    options.balls_collide = true;
    World world(program, options);
    const Vec2 places[] = {{0.05, 0.3}, {-0.35, -0.2}, {0.38, -0.05}, {0, -0.35}};
    const Vec2 speeds[] = {{1.3, 0.2}, {0.7, 1.9}, {-2.1, -0.4}, {0.3, 2.5}};
    for (int i = 0; i < 4; ++i) world.add_ball(place(places[i]), place(speeds[i]), reverses ? -3.0 : 3.0);
    for (int i = 0; i < 1500; ++i) world.step();
    CHECK(world.stats().impacts > 10);
    return {world.balls().begin(), world.balls().end()};
}

void check_law(double scale, bool reverses, const std::function<Vec2(const Vec2&)>& place) {
    const ProgramPtr plain = garden(), other = mapped(*plain, scale, reverses, place);
    for (const Integrator integrator : {Integrator::ballistic, Integrator::symplectic_euler}) {
        const auto a = played(plain, [](const Vec2& p) { return p; }, false, integrator);
        const auto b = played(other, place, reverses, integrator);
        for (std::size_t i = 0; i < a.size(); ++i) {
            CHECK(place(a[i].position) == b[i].position);
            CHECK(place(a[i].velocity) == b[i].velocity);
            CHECK((reverses ? -a[i].spin : a[i].spin) == b[i].spin);
        }
    }
}

}  // namespace

TEST_CASE("a table twice or an eighth the size plays the same, bit for bit") {
    for (const double scale : {2.0, 0.125}) check_law(scale, false, [=](const Vec2& p) { return Vec2(scale * p); });
}

TEST_CASE("a mirrored table plays the mirrored game, bit for bit") {
    check_law(1, true, [](const Vec2& p) { return Vec2(-p.x(), p.y()); });
}

TEST_CASE("a table turned by a quarter plays the turned game, bit for bit") {
    check_law(1, false, [](const Vec2& p) { return Vec2(-p.y(), p.x()); });
}
