// Lowered boundaries against the tree that they came from. No sampling error enters: a boundary B is the true one when
// every point of it separates inside from outside, and every point of a leaf's outline that does so is on it; and a
// distance is exact when its foot is on the boundary and no boundary point is nearer.
#include <catch2/catch.hpp>

#include "engine/core/at.h"
#include "engine/program/arrangement.h"
#include "engine/program/evaluate.h"
#include "engine/program/tree.h"
#include "engine/sdf/piece.h"
#include "tests/program/tables.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

struct Sample {
    Vec2 at, normal;
};

/// Points inside each piece, never its ends.
std::vector<Sample> samples_of(const sdf::Piece& piece, int n, CounterRng& random) {
    std::vector<Sample> out;
    for (int i = 0; i < n; ++i) {
        if (!piece.is_arc()) {
            const double t = random.in(0.001, 0.999);
            const Vec2 along = piece.b - piece.a;
            out.push_back({piece.a + t * along, -perpendicular(along) / length(along)});
            continue;
        }
        const double angle = random.in(0, 6.283185307179586);
        const Vec2 ray(std::cos(angle), std::sin(angle));
        if (in_sweep(piece, ray)) out.push_back({piece.centre + piece.radius * ray, piece.turn * ray});
    }
    return out;
}

/// -1: not a boundary point, 1: a boundary point with the solid on its left, -2: on its right; 0: too close to call.
int verdict(const Field& field, const Solid& solid, const std::vector<LeafImage>& leaves, const Sample& s) {
    constexpr double step = 1e-6;
    for (const LeafImage& leaf : leaves) {
        const double d = std::fabs(tree_value(field, leaf.leaf, leaf.field_from_leaf.inverse() * s.at));
        if (d > 1e-11 && d < 10 * step) return 0;
    }
    // Two outlines through one point at an angle: the step may leave through either.
    for (const double along : {-5.0, 5.0}) {
        const Vec2 near = s.at + along * step * perpendicular(s.normal);
        for (const LeafImage& leaf : leaves) {
            const double here = tree_value(field, leaf.leaf, leaf.field_from_leaf.inverse() * s.at);
            const double there = tree_value(field, leaf.leaf, leaf.field_from_leaf.inverse() * near);
            if (std::fabs(here) < 1e-11 && std::fabs(there) > 1e-10 * (1 + 1e3 * 25 * step * step)) return 0;
        }
    }
    const bool left = tree_value(field, solid.root, s.at - step * s.normal) < 0;
    const bool right = tree_value(field, solid.root, s.at + step * s.normal) < 0;
    if (left == right) return -1;
    return left ? 1 : -2;
}

struct Count {
    int trees = 0, boundary_points = 0, queries = 0;
};

void check_tree(std::uint64_t seed, bool snapped, Count& count) {
    Scene scene(catalog());
    RandomTree tree(scene, seed, snapped);
    const int depth = 1 + tree.pick(4);
    tree.grow({}, depth);
    const ProgramPtr program = compiled(scene);
    const Field& field = program->fixed;
    const Solid& solid = field.solids[0];
    const std::vector<LeafImage> leaves = leaf_images(field, solid.root).leaves;
    REQUIRE(!leaves.empty());
    if (!solid.lowered || leaves.size() > 60) return;  // empty, everything, or too dear to check
    INFO("seed " << seed << (snapped ? " snapped" : "") << " depth " << depth << " pieces " << solid.piece_count);
    ++count.trees;

    CounterRng random(seed, 1);
    std::vector<Vec2> boundary;
    for (const LeafImage& leaf : leaves)
        for (const sdf::Piece& piece : leaf.outline)
            for (const Sample& s : samples_of(piece, 12, random)) {
                const int v = verdict(field, solid, leaves, s);
                if (v != 1 && v != -2) continue;
                boundary.push_back(s.at);
                const Nearest here = nearest_of_solid(field, 0, s.at);
                if (std::fabs(here.distance) < 1e-10 && std::fabs(length(here.gradient) - 1) < 1e-9) continue;
                FAIL("outline point " << s.at.transpose() << " at " << here.distance << " gradient "
                                      << here.gradient.transpose());
            }
    count.boundary_points += static_cast<int>(boundary.size());
    for (int i = 0; i < solid.piece_count; ++i) {
        const BoundaryPiece& piece = at(field.pieces, solid.first_piece + i);
        for (const Sample& s : samples_of(piece.piece, 10, random)) {
            const int v = verdict(field, solid, leaves, s);
            INFO("piece " << i << " at " << s.at.transpose());
            REQUIRE((v == 1 || v == 0));
        }
    }
    for (int i = 0; i < 300; ++i) {
        const double x = random.in(-1.5, 1.5);
        const Vec2 p(x, random.in(-1.5, 1.5));
        const Nearest found = nearest_of_solid(field, 0, p);
        const double raw = tree_value(field, solid.root, p);
        INFO("point " << p.transpose() << " distance " << found.distance << " tree " << raw);
        ++count.queries;
        if (std::fabs(raw) > 1e-10) REQUIRE((found.distance < 0) == (raw < 0));
        REQUIRE(std::fabs(raw) <= std::fabs(found.distance) + 1e-10);  // the tree's value is a lower bound
        double least = infinity;
        for (const Vec2& b : boundary) least = std::min(least, dot(p - b, p - b));
        REQUIRE(std::sqrt(least) >= std::fabs(found.distance) - 1e-10);
        REQUIRE(std::fabs(nearest_of_solid(field, 0, p - found.distance * found.gradient).distance) < 1e-10);
    }
}

}  // namespace

TEST_CASE("the lowered boundary of random trees is their true boundary") {
    Count count;
    for (std::uint64_t seed = 1; seed <= 150; ++seed) check_tree(seed, false, count);
    CHECK(count.trees > 100);
    CHECK(count.boundary_points > 8000);
}

TEST_CASE("the lowered boundary is true where edges are shared, outlines touch and children are identical") {
    Count count;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) check_tree(seed, true, count);
    CHECK(count.trees > 180);
    CHECK(count.boundary_points > 20000);
}

TEST_CASE("what two shapes share is in the boundary once, and belongs to the first") {
    Scene scene(catalog());
    const NodeId both = add(scene, "union");
    const NodeId first = add(scene, "box", both, {{"size", Vec2(2, 2)}});
    add(scene, "box", both, {{"size", Vec2(2, 2)}});
    add(scene, "box", both,
        {{"size", Vec2(2, 1)}, {"at", Vec2(0, 0.5)}});  // shares three sides and ends within two of them
    const ProgramPtr program = compiled(scene);
    const Field& field = program->fixed;
    double perimeter = 0;
    for (int i = 0; i < field.solids[0].piece_count; ++i) {
        const BoundaryPiece& boundary = at(field.pieces, i);
        perimeter += length(boundary.piece.b - boundary.piece.a);
        CHECK(at(field.ops, boundary.leaf).origin == first);
    }
    CHECK(perimeter == Approx(8).epsilon(1e-14));
}
