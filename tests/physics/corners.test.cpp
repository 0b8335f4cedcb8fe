// A corner that a formula only bounds: max(a, b) keeps level lines sharp where a ball's centre turns in an arc. A ball that
// believed it would roll on along the mitre, past a corner that is not there.
#include "tests/physics/support.h"

using namespace pinfield;
using namespace pinfield::physics_test;

namespace {

constexpr double r = 0.0135;

/// The centre of a ball that rolls to the right along the top of `solid`, whose top right corner is at (0.5, 0.5), and over it.
std::vector<Vec2> path_over(const std::string& solid, const std::string& integrator) {
    World world(program_of("pinfield: 1\ntable: {size: [1, 1], slope: 30}\nphysics: {integrator: " + integrator +
                           "}\nmaterials: {default: {restitution: 0, friction: 0.4}}\nscene:\n" + solid));
    world.add_ball({0.47, 0.5 + r + 1e-7}, {0.15, 0});
    std::vector<Vec2> path;
    for (int i = 0; i < 900; ++i) {
        world.step();
        path.push_back(world.balls()[0].position);
    }
    return path;
}

double farthest_apart(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, length(a[i] - b[i]));
    return most;
}

}  // namespace

TEST_CASE("a ball rolls round an intersected corner as round a box's") {
    const std::string box = "  - box: {size: [0.4, 0.4], at: [0.3, 0.3]}\n";
    const std::string of_boxes =
        "  - intersection:\n      children:\n        - box: {size: [0.4, 0.8], at: [0.3, 0.4]}\n        - box: {size: [0.8, 0.4], at: "
        "[0.5, 0.3]}\n";
    const std::string of_planes =
        "  - intersection:\n      children:\n        - half_plane: {turn: 0, at: [0, 0.5]}\n        - half_plane: {turn: -90, at: [0.5, "
        "0]}\n"
        "        - box: {size: [0.4, 0.4], at: [0.3, 0.3]}\n";
    const std::string quadrant =
        "  - intersection:\n      children:\n        - half_plane: {turn: 0, at: [0, 0.5]}\n        - half_plane: {turn: -90, at: [0.5, "
        "0]}\n";
    const std::string less_a_quadrant =
        "  - difference:\n      children:\n        - box: {size: [0.8, 0.8], at: [0.5, 0.5]}\n        - box: {size: [0.4, 2], at: [0.7, "
        "1]}\n"
        "        - box: {size: [2, 0.4], at: [0.5, 0.7]}\n";
    for (const std::string integrator : {"ballistic", "symplectic_euler"}) {
        const std::vector<Vec2> exact = path_over(box, integrator);
        // It does go round: past the corner, down, and never nearer to it than its radius.
        CHECK(exact.back().x() > 0.5 + r);
        CHECK(exact.back().y() < 0.5);
        double nearest = 1, turned = 0;
        for (const Vec2& p : exact) {
            const Vec2 from_corner = p - Vec2(0.5, 0.5);
            nearest = std::min(nearest, length(from_corner));
            if (from_corner.x() > 0.2 * r && from_corner.y() > 0 && length(from_corner) < r + 1e-6) turned += 1;
        }
        CHECK(nearest >= r);
        CHECK(turned > 3);  // ticks spent rolling on the corner itself
        for (const std::string& solid : {of_boxes, of_planes, quadrant, less_a_quadrant}) {
            INFO(integrator << '\n' << solid);
            CHECK(farthest_apart(exact, path_over(solid, integrator)) < 1e-4);
        }
    }
}
