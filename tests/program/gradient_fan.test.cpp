#include "engine/program/gradient_fan.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/core/trig.h"
#include "engine/program/tree.h"
#include "tests/program/random_construction.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

constexpr double widest = 160;  // degrees

/// The least angle that holds all of them, by trying each as its beginning.
double spread_of(const std::vector<double>& angles) {
    double least = 360;
    for (const double first : angles) {
        double most = 0;
        for (const double angle : angles) most = std::max(most, std::fmod(angle - first + 720, 360));
        least = std::min(least, most);
    }
    return least;
}

}  // namespace

TEST_CASE("a fan is as wide as its directions are apart, in whatever order they come") {
    CounterRng random(7);
    int wide = 0, narrow = 0;
    for (int i = 0; i < 20000; ++i) {
        const double middle = random.in(0, 360), reach = random.in(0, 180);
        std::vector<double> angles;
        for (int k = 1 + static_cast<int>(random.uniform() * 5); k > 0; --k) angles.push_back(middle + random.in(-reach, reach));
        Fan fan;
        for (const double angle : angles) fan.include(Vec2{cosine(radians(angle)), sine(radians(angle))});
        const double spread = spread_of(angles);
        if (std::fabs(spread - widest) < 1) continue;
        INFO(spread << " degrees");
        REQUIRE(fan.is_wide() == (spread > widest));
        ++(fan.is_wide() ? wide : narrow);
        if (fan.is_wide()) continue;
        for (const double angle : angles) {
            const Vec2 way(cosine(radians(angle)), sine(radians(angle)));
            REQUIRE(cross(fan.first(), way) > -1e-12);
            REQUIRE(cross(way, fan.last()) > -1e-12);
        }
    }
    CHECK(wide > 1000);
    CHECK(narrow > 1000);
}

// What tracing rests on: between two places of such a disc the line cannot hide. Shapes without lines and arcs are known by samples alone.
TEST_CASE("along the axis of a narrow fan the field of any operators only rises, all over the disc") {
    int narrow = 0;
    std::vector<std::uint64_t> seeds{154};  // a filled elongation narrower than the disc
    for (std::uint64_t seed = 1; seed <= 60; ++seed) seeds.push_back(seed);
    for (const std::uint64_t seed : seeds) {
        Scene scene(catalog());
        set(scene.table(), "size", Vec2(2, 2));
        const NodeId top = RandomConstruction(scene, seed, 1.0 / 500, false).grow({}, 1 + static_cast<int>(seed % 4));
        set(*scene.find(top), "at", Vec2(1, 1));
        const ProgramPtr program = compiled(scene);
        const Field& field = program->fixed;
        if (field.solids[0].is_domain) continue;
        const int root = field.solids[0].root;
        FanFinder fans(field);
        CounterRng random(seed, 3);
        for (int i = 0; i < 3000; ++i) {
            const Vec2 middle{random.in(0.7, 1.3), random.in(0.7, 1.3)};
            const double radius = 0.02 * std::pow(0.01, random.uniform());
            // Fans are asked only where the line may be.
            if (std::fabs(tree_value(field, root, middle)) > at(field.ops, root).exactness.lipschitz * radius) continue;
            const Fan fan = fans.fan(root, middle, radius);
            if (fan.is_wide() || fan.is_empty()) continue;
            ++narrow;
            const Vec2 axis = fan.first() + fan.last(), along = axis / length(axis);
            for (int k = 0; k < 20; ++k) {
                const Vec2 aside = perpendicular(along) * random.in(-1, 1);
                const double half = std::sqrt(std::max(0.0, 1 - dot(aside, aside))), from = random.in(-half, half), to = random.in(-half, half);
                const double low = tree_value(field, root, middle + radius * (aside + std::min(from, to) * along));
                const double high = tree_value(field, root, middle + radius * (aside + std::max(from, to) * along));
                INFO("seed " << seed << " at " << middle.transpose() << ", radius " << radius << ": " << low << " to " << high);
                REQUIRE(high >= low - 1e-12);
            }
        }
    }
    CHECK(narrow > 1000);
}
