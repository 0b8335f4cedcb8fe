// Round, inset and onion over CSG trees: offsets of the true distance, and exact on both sides themselves.
#include <catch2/catch.hpp>

#include <cmath>

#include "engine/program/evaluate.h"
#include "tests/program/tables.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

struct Offset {
    std::string_view key, field;
    double amount;
    double (*of)(double distance, double amount);
};

constexpr Offset offsets[] = {{"round", "radius", 0.07, [](double d, double r) { return d - r; }},
                              {"inset", "distance", 0.04, [](double d, double s) { return d + s; }},
                              {"onion", "thickness", 0.06, [](double d, double t) { return std::fabs(d) - 0.5 * t; }}};

struct Tally {
    int trees = 0, crossings = 0, exact_outside = 0;
};

/// Where the offset's field changes sign between p and q, by the bare solid's distance alone.
Vec2 crossing(const Field& bare, const Offset& offset, Vec2 p, Vec2 q) {
    const auto f = [&](const Vec2& x) { return offset.of(nearest_of_solid(bare, 0, x).distance, offset.amount); };
    const bool inside_p = f(p) < 0;
    for (int i = 0; i < 60; ++i) {
        const Vec2 middle = 0.5 * (p + q);
        ((f(middle) < 0) == inside_p ? p : q) = middle;
    }
    return 0.5 * (p + q);
}

void check_offset(std::uint64_t seed, bool snapped, const Offset& offset, Tally& tally) {
    const auto scene_of = [&](bool with_offset) {
        Scene scene(catalog());
        const NodeId above = with_offset ? add(scene, offset.key, {}, {{offset.field, offset.amount}}) : NodeId{};
        RandomTree(scene, seed, snapped, true).grow(above, 1 + static_cast<int>(seed % 4));
        return compiled(scene);
    };
    const ProgramPtr with = scene_of(true), without = scene_of(false);
    const Field &field = with->fixed, &bare = without->fixed;
    if (bare.solids[0].is_domain || field.solids[0].is_domain) return;  // nothing is left
    if (!bare.solids[0].lowered || bare.solids[0].piece_count > 150 || !field.solids[0].lowered) return;
    ++tally.trees;
    INFO(offset.key << ", seed " << seed << (snapped ? " snapped" : ""));
    CounterRng random(seed, 3);
    const auto place = [&] {
        const double x = random.in(-1.2, 1.2);
        return Vec2{x, random.in(-1.2, 1.2)};
    };
    for (int i = 0; i < 150; ++i) {
        const Vec2 p = place(), q = place();
        const double d = nearest_of_solid(bare, 0, p).distance, wanted = offset.of(d, offset.amount);
        const Nearest found = nearest_of_solid(field, 0, p);
        INFO("at " << p.transpose() << ": " << found.distance << ", bare " << d);
        if (std::fabs(wanted) > 1e-9) CHECK((found.distance < 0) == (wanted < 0));
        // The offset of a distance never says more than the distance to the offset, ...
        CHECK(std::fabs(found.distance) >= std::fabs(wanted) - 1e-10);
        // ... outside what grew, or inside what shrank, it is that distance, ...
        const bool grown_outside = offset.key == "round" && wanted > 0, shrunk_inside = offset.key == "inset" && wanted < 0;
        if (grown_outside || shrunk_inside || (offset.key == "onion" && wanted > 0)) {
            CHECK(std::fabs(found.distance - wanted) < 1e-10);
            ++tally.exact_outside;
        }
        // ... the foot is on its outline, and every place where it changes sign is too: so no other distance is the true one.
        const Vec2 foot = p - found.distance * found.gradient;
        CHECK(std::fabs(offset.of(nearest_of_solid(bare, 0, foot).distance, offset.amount)) < 1e-9);
        if ((wanted < 0) != (offset.of(nearest_of_solid(bare, 0, q).distance, offset.amount) < 0)) {
            CHECK(std::fabs(nearest_of_solid(field, 0, crossing(bare, offset, p, q)).distance) < 1e-9);
            ++tally.crossings;
        }
    }
}

}  // namespace

TEST_CASE("an offset of a CSG tree is that of its true distance, and exact on both sides") {
    for (const Offset& offset : offsets) {
        Tally tally;
        for (std::uint64_t seed = 1; seed <= 60; ++seed) check_offset(seed, seed % 2 == 0, offset, tally);
        INFO(offset.key);
        CHECK(tally.trees > 25);
        CHECK(tally.crossings > 300);
        CHECK(tally.exact_outside > 200);
    }
}
