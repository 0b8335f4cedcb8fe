// Operators over operators over thin walls: wherever a line goes into a solid or out of it, the boundary that balls hit must be.
#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <string>

#include "engine/program/distance_quality.h"
#include "engine/program/tree.h"
#include "engine/sdf/piece.h"
#include "tests/program/random_construction.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

constexpr double thinnest = 1.0 / 5000;

double distance_to_boundary(const Field& field, const Solid& solid, const Vec2& p) {
    double least = infinity;
    for (int i = solid.first_piece; i < solid.first_piece + solid.piece_count; ++i)
        least = std::min(least, squared_distance_to_piece(at(field.pieces, i).piece, p));
    return std::sqrt(least);
}

/// Where a line is in the solid, or out of it.
struct Stretch {
    double begin = 0;    ///< share of the line, found by halving
    double extreme = 0;  ///< the greatest |value| that was seen on it
};

/// Walks a line in small steps: knows nothing but the values there.
std::vector<Stretch> march(const Field& field, int root, const Vec2& from, const Vec2& to) {
    constexpr int steps = 20000;
    const auto value = [&](double share) { return tree_value(field, root, from + share * (to - from)); };
    std::vector<Stretch> out{{}};
    double before = value(0);
    for (int i = 1; i <= steps; ++i) {
        const double here = value(static_cast<double>(i) / steps);
        if ((here < 0) != (before < 0)) {
            double lo = static_cast<double>(i - 1) / steps, hi = static_cast<double>(i) / steps;
            for (int k = 0; k < 40; ++k) ((value(0.5 * (lo + hi)) < 0) == (before < 0) ? lo : hi) = 0.5 * (lo + hi);
            out.push_back({hi, 0});
        }
        out.back().extreme = std::max(out.back().extreme, std::fabs(here));
        before = here;
    }
    return out;
}

struct Found {
    int solids = 0, as_trees = 0, crossings = 0;
};

/// What is thinner than the thinnest wall of all may have no boundary; whatever parts two stretches that are not, has.
void judge(const Field& field, std::uint64_t seed, Found& found) {
    for (const Solid& solid : field.solids) {
        if (!solid.bounds.is_finite() || solid.bounds.is_empty()) continue;
        ++found.solids;
        if (!solid.lowered) {
            ++found.as_trees;
            continue;
        }
        const Box2 around = solid.bounds.grown(0.01);
        const double size = around.size().maxCoeff();
        CounterRng random(seed);
        const auto somewhere = [&] {
            const double x = random.in(around.lo.x(), around.hi.x());
            return Vec2(x, random.in(around.lo.y(), around.hi.y()));
        };
        for (int line = 0; line < 4; ++line) {
            const Vec2 from = somewhere(), to = somewhere();
            const std::vector<Stretch> stretches = march(field, solid.root, from, to);
            for (std::size_t i = 1; i < stretches.size(); ++i) {
                if (std::min(stretches[i - 1].extreme, stretches[i].extreme) < 0.5 * thinnest * size) continue;
                ++found.crossings;
                const Vec2 p = from + stretches[i].begin * (to - from);
                INFO(fmt::format("seed {}: at ({}, {})", seed, p.x(), p.y()));
                REQUIRE(distance_to_boundary(field, solid, p) < 1e-6 * size + 2 * solid.fit_error);
            }
        }
    }
}

Found judge_random(std::uint64_t first, int count, int deepest) {
    Found found;
    for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(count); ++seed) {
        Scene scene(catalog());
        set(scene.table(), "size", Vec2(2, 2));
        RandomConstruction construction(scene, seed, thinnest);
        const NodeId top = construction.grow({}, 1 + static_cast<int>(seed % static_cast<std::uint64_t>(deepest)));
        set(*scene.find(top), "at", Vec2(1, 1));
        judge(compiled(scene)->fixed, seed, found);
    }
    return found;
}

}  // namespace

TEST_CASE("wherever a line enters or leaves a solid of any operators over thin walls, the boundary is") {
    const Found found = judge_random(1, 20, 3);
    CHECK(found.crossings > 50);
    CHECK(found.as_trees <= found.solids / 5);
}

// PINFIELD_CONSTRUCTIONS asks for another number of solids than usual.
TEST_CASE("wherever a line enters or leaves a solid of operators over operators over thin walls, the boundary is", "[slow]") {
    const char* const asked = std::getenv("PINFIELD_CONSTRUCTIONS");
    const Found found = judge_random(1000, asked ? std::stoi(asked) : 150, 6);
    WARN(fmt::format("{} solids, {} of them trees, {} crossings", found.solids, found.as_trees, found.crossings));
    CHECK(found.crossings > 2 * found.solids);
}

TEST_CASE("two thin walls under a stretch are whole wherever they stand") {
    for (int i = 0; i < 40; ++i) {
        Scene scene(catalog());
        set(scene.table(), "size", Vec2(0.8, 0.8));
        const NodeId stretch = add(scene, "stretch", {}, {{"at", Vec2(0.4, 0.4)}, {"by", Vec2(1.1, 1)}});
        const NodeId both = add(scene, "union", stretch);
        add(scene, "box", both, {{"size", Vec2(0.5, 0.0005)}, {"at", Vec2(0, -0.03 + 0.00137 * i)}});
        add(scene, "box", both, {{"size", Vec2(0.0005, 0.5)}});
        Found found;
        judge(compiled(scene)->fixed, static_cast<std::uint64_t>(i), found);
        REQUIRE(found.as_trees == 0);
    }
}

namespace {

/// A pin and a box of 0.9 m in one blend; nothing when the pin is in the box.
void check_pin(const Vec2& pin, double radius, double k) {
    INFO(fmt::format("at ({}, {}), radius {}", pin.x(), pin.y(), radius));
    Scene scene(catalog());
    set(scene.table(), "size", Vec2(0.9, 1));
    const NodeId blend = add(scene, "smooth_union", {}, {{"k", k}});
    add(scene, "box", blend, {{"size", Vec2(0.02, 0.9)}, {"at", Vec2(0.45, 0.5)}});
    add(scene, "circle", blend, {{"radius", radius}, {"at", pin}});
    const ProgramPtr program = compiled(scene);
    const Solid& solid = program->fixed.solids[0];
    REQUIRE(solid.lowered);
    CHECK(distance_to_boundary(program->fixed, solid, pin) == Approx(radius).epsilon(1e-3));
}

}  // namespace

TEST_CASE("a pin beside a long box in one blend has its boundary, wherever it stands and however thin it is") {
    for (const double radius : {0.0007, 0.0005, 0.0002})
        for (int i = 0; i < 24; ++i) {
            const Vec2 pin(0.2217 + 0.0093 * i, 0.5119 - 0.0151 * i);
            if (std::fabs(pin.x() - 0.45) > 0.01 + radius) check_pin(pin, radius, 0.001);
        }
}

TEST_CASE("a pin so close to a long box that it is nearest to no place that is looked at has its boundary") {
    for (const double gap : {0.0001, 0.0003, 0.001})
        for (int i = 0; i < 20; ++i) check_pin({0.44 - gap - 0.0002, 0.5119 - 0.0151 * i}, 0.0002, 0.00002);
}

// Of two waves over one another on a capsule of 1 mm a needle is left that is thinner than its boundary strays: the sides of that cross.
TEST_CASE("outside its box no place is inside a solid, whatever needles it has") {
    Scene scene(catalog());
    set(scene.table(), "size", Vec2(2, 2));
    const NodeId inset = add(scene, "inset", {}, {{"at", Vec2(1, 1)}, {"turn", -93.55439893791865}, {"distance", 0.0011871898141930597}});
    const NodeId outer = add(scene, "displace", inset,
                             {{"at", Vec2(0.009597804778590513, -0.030573608686973276)}, {"flip", std::string("y")},
                              {"amplitude", 0.0027892929072389546}, {"wavelength", Vec2(0.17571210976430157, 0.10864451759712818)}});
    const NodeId inner = add(scene, "displace", outer,
                             {{"at", Vec2(-0.0035379579381136783, -0.04001104364637022)}, {"amplitude", 0.0023383703500894004},
                              {"wavelength", Vec2(0.14314793777055335, 0.193425086425413)}});
    add(scene, "capsule", inner,
        {{"at", Vec2(0.08883943395914079, 0.08847864494445182)}, {"length", 0.2775587299673111}, {"radius", 0.000529819319022478}});
    const ProgramPtr program = compiled(scene);
    const Field& field = program->fixed;
    const Solid& solid = field.solids[0];
    CounterRng random(1);
    for (int i = 0; i < 50000; ++i) {
        const double x = random.in(0.85, 1);
        const Vec2 p(x, random.in(0.75, 1.1));
        if (!solid.bounds.contains(p)) REQUIRE(tree_value(field, solid.root, p) > 0);
    }
}

TEST_CASE("of a filled path the edge that balls meet is there, however far one of its points lies") {
    for (const double far : {0.5, 20.0, 1000.0})
        for (std::uint64_t seed = 1; seed <= 30; ++seed) {
            INFO(fmt::format("{} m, seed {}", far, seed));
            CounterRng random(seed);
            const auto corner = [&](double angle, double radius) { return Vec2(radius * std::cos(angle), radius * std::sin(angle)); };
            std::vector<Vec2> points{corner(0, 0.1)};
            std::vector<std::string> pieces;
            const int sides = 6, far_one = 1 + static_cast<int>(random.uniform() * 5);
            for (int i = 1; i < sides; ++i) {
                const bool is_arc = random.uniform() < 0.5;
                if (is_arc) points.push_back(corner(i - 0.5, random.in(0.05, 0.2)));
                points.push_back(corner(i, i == far_one ? far : random.in(0.05, 0.2)));
                pieces.emplace_back(is_arc ? "arc" : "line");
            }
            Scene scene(catalog());
            set(scene.table(), "size", Vec2(0.8, 0.8));
            add(scene, "path", {}, {{"at", Vec2(0.4, 0.4)}, {"points", points}, {"pieces", pieces}, {"fill", true}, {"thickness", 0.0}});
            const auto program = compile(scene);
            if (!program) continue;  // an arc so flat that it is refused
            const Field& field = (*program)->fixed;
            const Solid& solid = field.solids[0];
            if (!solid.lowered) continue;  // balls meet the formula itself
            for (int line = 0; line < 4; ++line) {
                const Vec2 from(0.8 * random.uniform(), 0), to(0.8 * random.uniform(), 0.8);
                const std::vector<Stretch> stretches = march(field, solid.root, from, to);
                for (std::size_t i = 1; i < stretches.size(); ++i)
                    REQUIRE(distance_to_boundary(field, solid, from + stretches[i].begin * (to - from)) < 1e-6 + 2 * solid.fit_error);
            }
        }
}

TEST_CASE("what is cut from itself or common to what is apart is no solid, and is told") {
    Scene scene(catalog());
    const auto disc = [&](NodeId parent, double x) { return add(scene, "circle", parent, {{"radius", 0.05}, {"at", Vec2(x, 0.5)}}); };
    std::vector<NodeId> empty;
    for (const std::string_view operation : {"difference", "xor"}) {
        empty.push_back(add(scene, operation));
        disc(empty.back(), 0.2);
        disc(empty.back(), 0.2);
    }
    empty.push_back(add(scene, "intersection"));
    disc(empty.back(), 0.1);
    disc(empty.back(), 0.4);
    for (const std::string_view operation : {"intersection", "smooth_intersection", "lerp"}) {  // known by their formulas
        empty.push_back(add(scene, operation));
        add(scene, "ellipse", empty.back(), {{"at", Vec2(0.1, 0.5)}});
        disc(empty.back(), 0.4);
    }
    empty.push_back(add(scene, "flipper"));
    const NodeId bat = add(scene, "difference", empty.back());
    disc(bat, 0);
    disc(bat, 0);
    const NodeId half = add(scene, "difference");
    disc(half, 0.3);
    disc(half, 0.33);
    const ProgramPtr program = compiled(scene);
    std::vector<NodeId> solids;
    for (const Solid& solid : program->fixed.solids) solids.push_back(solid.origin);
    CHECK(solids == std::vector<NodeId>{half, scene.table().id});
    CHECK(program->movers.at(0).field.solids.empty());
    CHECK(program->movers[0].bounding_radius == 0);
    const Diagnostics told = warnings_of(*program, scene);
    REQUIRE(told.size() == empty.size());
    for (const Diagnostic& warning : told) CHECK(warning.message.starts_with("nothing is left of this"));
}

// Together with something far away it is not dropped, and its formula can be asked.
TEST_CASE("what was found to be no solid is solid nowhere") {
    int dropped = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const auto grown = [&](bool with_another) {
            Scene scene(catalog());
            set(scene.table(), "size", Vec2(2, 2));
            const NodeId both = with_another ? add(scene, "union") : NodeId{};
            const NodeId top = RandomConstruction(scene, seed, thinnest).grow(both, 1 + static_cast<int>(seed % 5));
            set(*scene.find(top), "at", Vec2(1, 1));
            if (with_another) add(scene, "circle", both, {{"radius", 0.01}, {"at", Vec2(0.1, 0.1)}});
            return std::pair(compiled(scene), top);
        };
        if (!grown(false).first->fixed.solids[0].is_domain) continue;
        ++dropped;
        const auto [program, top] = grown(true);
        const Field& field = program->fixed;
        int op = 0;
        while (at(field.ops, op).origin != top) ++op;
        while (op + 1 < static_cast<int>(field.ops.size()) && at(field.ops, op + 1).origin == top) ++op;
        INFO("seed " << seed);
        CounterRng random(seed, 9);
        for (int i = 0; i < 4000; ++i) {
            const Vec2 p{random.in(0.6, 1.4), random.in(0.6, 1.4)};
            REQUIRE(tree_value(field, op, p) >= 0);
        }
    }
    CHECK(dropped > 3);
}

TEST_CASE("a filled elongation has its boundary, however little it is pulled apart") {
    for (const double by : {0.0002, 0.0005, 0.002})
        for (int i = 0; i < 12; ++i) {
            Scene scene(catalog());
            set(scene.table(), "size", Vec2(1, 1));
            const NodeId strip = add(scene, "elongate", {}, {{"at", Vec2(0.5, 0.5)}, {"turn", 13.0 * i}, {"by", Vec2(by, 0.3)}});
            const NodeId two = add(scene, "union", strip);
            add(scene, "box", two, {{"size", Vec2(0.1, 0.1)}, {"at", Vec2(0.05 + 0.0001 * i + 0.4 * by, 0)}});
            Found found;
            judge(compiled(scene)->fixed, static_cast<std::uint64_t>(i), found);
            CHECK(found.solids == 1);
        }
}
