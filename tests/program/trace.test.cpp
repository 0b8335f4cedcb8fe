// Traced boundaries against closed forms, against the exact lowering of solids that have one, and against brute force.
#include <catch2/catch.hpp>

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "engine/core/at.h"
#include "engine/program/evaluate.h"
#include "engine/program/trace.h"
#include "engine/program/tree.h"
#include "engine/sdf/piece.h"
#include "tests/program/tables.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

/// The pieces' common box and length.
struct Extent {
    Box2 box;
    double size = 0, longest_gap = 0;
};

Extent extent_of(const std::vector<BoundaryPiece>& pieces) {
    Extent out;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        out.box = out.box.merged(bounds_of(pieces[i].piece));
        double gap = infinity;  // to where another piece begins
        for (const BoundaryPiece& other : pieces) gap = std::min(gap, length(other.piece.a - pieces[i].piece.b));
        out.longest_gap = std::max(out.longest_gap, gap);
    }
    out.size = out.box.size().maxCoeff();
    return out;
}

double brute_distance(const std::vector<Vec2>& outline, const Vec2& p) {
    double best = infinity;
    for (const Vec2& q : outline) best = std::min(best, dot(p - q, p - q));
    return std::sqrt(best);
}

/// A table with this one solid.
ProgramPtr table_of(const std::function<void(Scene&)>& fill) {
    Scene scene(catalog());
    set(scene.table(), "size", Vec2(1, 1));
    fill(scene);
    return compiled(scene);
}

}  // namespace

TEST_CASE("distances to an ellipse are the true ones on both sides, through its traced boundary") {
    const double a = 0.08, b = 0.03;
    const ProgramPtr program = table_of([&](Scene& scene) { add(scene, "ellipse", {}, {{"radii", Vec2(a, b)}, {"at", Vec2(0.4, 0.5)}}); });
    const Field& field = program->fixed;
    REQUIRE(field.solids[0].lowered);
    CHECK(field.solids[0].fit_error == Approx(trace_tolerance * 2 * a));
    std::vector<Vec2> outline;
    for (int i = 0; i < 20000; ++i) {
        const double t = 6.283185307179586 * i / 20000;
        outline.emplace_back(0.4 + a * std::cos(t), 0.5 + b * std::sin(t));
    }
    for (const BoundaryPiece& piece : field.pieces)
        if (piece.solid == 0) {
            const double u = (piece.piece.a.x() - 0.4) / a, v = (piece.piece.a.y() - 0.5) / b;
            REQUIRE(std::fabs(u * u + v * v - 1) < 4 * trace_tolerance * a / b);  // its gradient is at most 2 / b
        }
    CounterRng random(3);
    for (int i = 0; i < 300; ++i) {
        const double x = random.in(0.25, 0.55);
        const Vec2 p(x, random.in(0.4, 0.6));
        const double truth = brute_distance(outline, p), found = nearest_of_solid(field, 0, p).distance,
                     hit = nearest_outside(field, p, ground_layer, infinity).distance;
        const double chord = 6.3 * a / 20000, error = chord * chord / std::max(truth, chord);  // of the brute force
        CHECK(std::fabs(std::fabs(found) - truth) < error + 1e-12);
        if (found > 0 && found < 0.2) CHECK(std::fabs(hit - found) < trace_tolerance * 2 * a);
    }
}

TEST_CASE("no wave of a formula hides between the places where it was looked at") {
    // Two waves to a cell of the lattice, whose corners and middle are all alike: of a box of 40 mm a 128th of 1.0437 times its side.
    const double wave = 0.04 * 1.0437 / 128 / 2;
    const std::string text = fmt::format(
        "max(abs(x) - 2cm, abs(y) - 1cm, min(0.04mm * cos(360 * x / {}m) - 0.01mm, 1mm - abs(x)))", wave);
    const ProgramPtr program = table_of([&](Scene& scene) {
        add(scene, "formula", {}, {{"distance", text}, {"bounds", Vec2(0.05, 0.03)}, {"at", Vec2(0.4, 0.5)}});
    });
    const Field& field = program->fixed;
    REQUIRE(field.solids[0].lowered);
    int slits = 0;
    for (double x = -0.9e-3; x < 0.9e-3; x += wave / 40) {
        const Vec2 p(0.4 + x, 0.5);
        const double formula = tree_value(field, field.solids[0].root, p);
        if (std::fabs(formula) < 1e-7) continue;
        REQUIRE((nearest_of_solid(field, 0, p).distance < 0) == (formula < 0));
        REQUIRE(nearest_outside(field, p, ground_layer, infinity).distance < wave);
        slits += formula > 0;
    }
    CHECK(slits > 100);
}

TEST_CASE("a traced boundary is closed, follows the zero line, and has the solid on its left") {
    for (const std::string_view shape : {"ellipse", "parabola", "hyperbola", "blobby_cross", "circle_wave", "quadratic_bezier", "spiral"}) {
        INFO(shape);
        const ProgramPtr program = table_of([&](Scene& scene) {
            const NodeId blend = add(scene, "smooth_union", {}, {{"k", 0.004}});
            add(scene, shape, blend, {{"at", Vec2(0.4, 0.5)}});
            add(scene, "box", blend, {{"size", Vec2(0.05, 0.02)}, {"at", Vec2(0.43, 0.51)}, {"turn", 20.0}});
        });
        const Field& field = program->fixed;
        if (!field.solids[0].bounds.is_finite()) continue;
        REQUIRE(field.solids[0].lowered);
        REQUIRE(field.solids[0].fit_error > 0);
        const std::vector<BoundaryPiece> pieces(field.pieces.begin(), field.pieces.begin() + field.solids[0].piece_count);
        const Extent extent = extent_of(pieces);
        CHECK(extent.longest_gap == 0);
        for (const BoundaryPiece& piece : pieces) {
            const sdf::Piece& q = piece.piece;
            Vec2 p = 0.5 * (q.a + q.b);
            if (q.is_arc()) p = q.centre + (q.radius / length(p - q.centre)) * (p - q.centre);
            CHECK(std::fabs(tree_value(field, field.solids[0].root, p)) < trace_tolerance * extent.size);
            if (length(q.b - q.a) < 1e-6) continue;
            const Vec2 left = perpendicular(q.b - q.a) / length(q.b - q.a);
            CHECK(tree_value(field, field.solids[0].root, p + 2e-7 * extent.size * left) < 0);
            CHECK(tree_value(field, field.solids[0].root, p - 2e-7 * extent.size * left) > 0);
        }
    }
}

TEST_CASE("traced as formulas, CSG trees have the boundary that they are lowered to exactly") {
    int tried = 0;
    double worst = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        Scene scene(catalog());
        RandomTree tree(scene, seed, seed % 4 == 0);
        tree.grow({}, 1 + static_cast<int>(seed % 2));
        const ProgramPtr program = compiled(scene);
        const Field& field = program->fixed;
        if (!field.solids[0].lowered) continue;
        const std::vector<OwnedPiece> traced = traced_boundary(field, field.solids[0].root).pieces;
        if (traced.empty()) continue;  // without end, or touching itself
        ++tried;
        const double size = field.solids[0].bounds.is_finite() ? field.solids[0].bounds.size().maxCoeff() : 2;
        for (const OwnedPiece& piece : traced) {
            double nearest = infinity;
            for (int i = 0; i < field.solids[0].piece_count; ++i)
                nearest = std::min(nearest, squared_distance_to_piece(at(field.pieces, i).piece, piece.piece.a));
            worst = std::max(worst, std::sqrt(nearest) / size);
        }
        for (int i = 0; i < field.solids[0].piece_count; ++i) {  // and nothing of it was missed
            const sdf::Piece& whole = at(field.pieces, i).piece;
            if (length(whole.b - whole.a) < 0.05 * size && !whole.is_full_circle()) continue;
            double nearest = infinity;
            for (const OwnedPiece& piece : traced) nearest = std::min(nearest, squared_distance_to_piece(piece.piece, whole.a));
            worst = std::max(worst, std::sqrt(nearest) / size);
        }
    }
    CHECK(tried > 30);
    CHECK(worst < 1e-7);
}

TEST_CASE("identical, touching and overlapping ellipses unite, cut and exclude each other like any other outlines") {
    for (const std::string_view operation : {"union", "intersection", "difference", "xor"})
        for (const double apart : {0.0, 0.01, 0.1}) {
            INFO(operation << " " << apart);
            const ProgramPtr program = table_of([&](Scene& scene) {
                const NodeId both = add(scene, operation);
                add(scene, "ellipse", both, {{"radii", Vec2(0.05, 0.02)}, {"at", Vec2(0.4, 0.5)}});
                add(scene, "ellipse", both, {{"radii", Vec2(0.05, 0.02)}, {"at", Vec2(0.4 + apart, 0.5)}});
            });
            const Field& field = program->fixed;
            const bool empty =
                (apart == 0 && (operation == "difference" || operation == "xor")) || (apart == 0.1 && operation == "intersection");
            if (empty) {
                CHECK(nearest_of_solid(field, 0, {0.4, 0.5}).distance >= 0);
                continue;
            }
            REQUIRE(field.solids[0].lowered);
            CounterRng random(5);
            for (int i = 0; i < 200; ++i) {
                const double x = random.in(0.33, 0.57);
                const Vec2 p(x, random.in(0.46, 0.54));
                const Nearest n = nearest_of_solid(field, 0, p);
                const double raw = tree_value(field, field.solids[0].root, p);
                CHECK((n.distance < 0) == (raw < 0));
                CHECK(std::fabs(n.distance) > std::fabs(raw) - 1e-9);
                CHECK(std::fabs(tree_value(field, field.solids[0].root, p - n.distance * n.gradient)) < 1e-8);
            }
        }
}

TEST_CASE("an offset of a blend is an offset of its true distance") {
    const ProgramPtr program = table_of([&](Scene& scene) {
        const NodeId inset = add(scene, "inset", {}, {{"distance", 0.004}});
        const NodeId blend = add(scene, "smooth_union", inset, {{"k", 0.01}});
        add(scene, "circle", blend, {{"radius", 0.03}, {"at", Vec2(0.4, 0.5)}});
        add(scene, "circle", blend, {{"radius", 0.03}, {"at", Vec2(0.45, 0.5)}});
        const NodeId bare = add(scene, "smooth_union", {}, {{"k", 0.01}});
        add(scene, "circle", bare, {{"radius", 0.03}, {"at", Vec2(0.4, 0.5)}});
        add(scene, "circle", bare, {{"radius", 0.03}, {"at", Vec2(0.45, 0.5)}});
    });
    const Field& field = program->fixed;
    REQUIRE(field.solids[0].lowered);
    for (int i = 0; i < 60; ++i) {
        const Vec2 p(0.36 + 0.0022 * i, 0.505 - 0.0003 * i);
        const double outer = nearest_of_solid(field, 1, p).distance;
        if (std::fabs(outer) < 0.01) CHECK((nearest_of_solid(field, 0, p).distance < 0) == (outer < -0.004));
    }
    const Nearest rim = nearest_of_solid(field, 0, {0.425, 0.5});
    CHECK(rim.distance == Approx(nearest_of_solid(field, 1, {0.425, 0.5}).distance + 0.004).margin(1e-8));
}

TEST_CASE("each piece of a traced boundary belongs to the shape whose surface it is") {
    NodeId left, right;
    const ProgramPtr program = table_of([&](Scene& scene) {
        const NodeId blend = add(scene, "smooth_union", {}, {{"k", 0.002}});
        left = add(scene, "circle", blend, {{"radius", 0.03}, {"at", Vec2(0.4, 0.5)}});
        right = add(scene, "circle", blend, {{"radius", 0.03}, {"at", Vec2(0.45, 0.5)}});
    });
    const Field& field = program->fixed;
    int of_left = 0, of_right = 0;
    for (int i = 0; i < field.solids[0].piece_count; ++i) {
        const BoundaryPiece& boundary = at(field.pieces, field.solids[0].first_piece + i);
        const NodeId owner = at(field.ops, boundary.leaf).origin;
        const double x = 0.5 * (boundary.piece.a.x() + boundary.piece.b.x());
        if (std::fabs(x - 0.425) < 1e-4) continue;  // across the seam
        CHECK(owner == (x < 0.425 ? left : right));
        ++(x < 0.425 ? of_left : of_right);
    }
    CHECK(of_left > 10);
    CHECK(of_right > 10);
}

// In a cell of the lattice that holds both corners the line may run two ways.
TEST_CASE("two corners that all but touch are traced as the field has them, parted or joined") {
    int traced_at_all = 0;
    for (const double gap : {2e-5, -2e-5})
        for (int turn = 0; turn < 90; turn += 7) {
            INFO("gap " << gap << ", turned " << turn);
            const ProgramPtr program = table_of([&](Scene& scene) {
                const NodeId both = add(scene, "union", {}, {{"at", Vec2(0.5, 0.5)}, {"turn", 1.0 * turn}});
                for (const double side : {1.0, -1.0}) {
                    const double at = side * (0.05 + 0.5 * gap);
                    add(scene, "box", both, {{"size", Vec2(0.1, 0.1)}, {"at", Vec2(at, at)}});
                }
            });
            const Field& field = program->fixed;
            const TracedBoundary traced = traced_boundary(field, field.solids[0].root);
            if (traced.pieces.empty()) continue;  // the lattice took the wrong way, which the fit noticed
            ++traced_at_all;
            for (const OwnedPiece& owned : traced.pieces) {
                CHECK(std::fabs(tree_value(field, field.solids[0].root, owned.piece.a)) < traced.error);
                CHECK(std::fabs(tree_value(field, field.solids[0].root, 0.5 * (owned.piece.a + owned.piece.b))) < traced.error);
            }
            for (int i = 0; i < field.solids[0].piece_count; ++i) {  // of the exact outline
                double nearest = infinity;
                for (const OwnedPiece& owned : traced.pieces)
                    nearest = std::min(nearest, squared_distance_to_piece(owned.piece, at(field.pieces, i).piece.a));
                CHECK(std::sqrt(nearest) < traced.error);
            }
        }
    CHECK(traced_at_all > 10);
}

// What is fitted strays by a ten millionth of what was traced, however little of it is left; the distance is put right by what it strayed.
TEST_CASE("a small piece of a large traced shape knows its error and is corrected by it") {
    const double a = 0.9, b = 0.5;
    const auto rim = [&](double angle) { return Vec2(a * std::cos(angle), b * std::sin(angle)); };
    const ProgramPtr program = table_of([&](Scene& scene) {
        const NodeId chip = add(scene, "intersection");
        add(scene, "ellipse", chip, {{"radii", Vec2(a, b)}});
        add(scene, "circle", chip, {{"radius", 0.005}, {"at", rim(1)}});
    });
    const Field& field = program->fixed;
    const int chip = first_shape(*program);
    REQUIRE(at(field.solids, chip).lowered);
    CHECK(at(field.solids, chip).fit_error == Approx(trace_tolerance * 2 * a));
    CounterRng rng(8);
    for (int i = 0; i < 200; ++i) {
        const double angle = 1 + rng.in(-0.004, 0.004), distance = rng.in(1e-5, 1e-3);
        const Vec2 normal = Vec2(b * std::cos(angle), a * std::sin(angle)).normalized();
        const Nearest found = nearest_of_solid(field, chip, rim(angle) + distance * normal);
        INFO("angle " << angle << " distance " << distance);
        REQUIRE(std::fabs(found.distance - distance) < 1e-11);
    }
}

TEST_CASE("half planes are cut where they meet, exact up to a horizon and never too far beyond") {
    const ProgramPtr plane = table_of([&](Scene& scene) { add(scene, "half_plane", {}, {{"at", Vec2(0, 0.1)}}); });
    CHECK_FALSE(plane->fixed.solids[0].lowered);  // its formula is exact everywhere
    CHECK(nearest_of_solid(plane->fixed, 0, {1e6, 3.1}).distance == 3.0);

    const ProgramPtr program = table_of([&](Scene& scene) {
        add(scene, "circle", add(scene, "domain"), {{"radius", 1e7}});  // out of the way
        const NodeId both = add(scene, "intersection");
        add(scene, "half_plane", both, {{"at", Vec2(0, 0.5)}});
        add(scene, "half_plane", both, {{"at", Vec2(0.5, 0)}, {"turn", -90.0}});
    });
    const Field& field = program->fixed;
    const int quadrant = field.solids[0].is_domain ? 1 : 0;
    REQUIRE(at(field.solids, quadrant).lowered);
    const double horizon = at(field.solids, quadrant).horizon;
    CHECK(horizon > 50);
    CHECK(horizon < 1000);
    const Vec2 corner(0.5, 0.5);
    CounterRng rng(4);
    for (int i = 0; i < 2000; ++i) {
        const double reach = std::pow(10, rng.in(-4, 5));  // from beside the corner to far beyond the horizon
        const double dx = reach * rng.in(-1, 1), dy = reach * rng.in(-1, 1);
        const double truth = dx > 0 && dy > 0 ? std::hypot(dx, dy) : std::max(dx, dy);
        const Vec2 p = corner + Vec2(dx, dy);
        for (const Nearest& found :
             {nearest_of_solid(field, quadrant, p), truth > 0 ? nearest_outside(field, p, ground_layer, infinity) : nearest(field, p)}) {
            INFO(dx << ' ' << dy << " found " << found.distance << " truth " << truth);
            REQUIRE((found.distance < 0) == (truth < 0));
            REQUIRE(std::fabs(found.distance) <= std::fabs(truth) * (1 + 1e-12) + 1e-12);
            if (found.certified || reach < 0.2 * horizon) REQUIRE(std::fabs(found.distance - truth) <= 1e-12 * (1 + reach));
            if (reach < 0.2 * horizon) REQUIRE(found.certified);
        }
    }
}

TEST_CASE("a half plane cut to a finite size has the boundary of what is left") {
    const ProgramPtr cut = table_of([&](Scene& scene) {
        const NodeId both = add(scene, "intersection");
        add(scene, "half_plane", both, {{"at", Vec2(0, 0.5)}});
        add(scene, "circle", both, {{"radius", 0.05}, {"at", Vec2(0.4, 0.52)}});
    });
    REQUIRE(cut->fixed.solids[0].lowered);  // as a whole it has one
    CHECK(nearest_of_solid(cut->fixed, 0, {0.4, 0.55}).distance == Approx(0.05).margin(1e-12));
    const double half = std::sqrt(0.05 * 0.05 - 0.02 * 0.02);
    CHECK(nearest_of_solid(cut->fixed, 0, {0.4 + half + 0.03, 0.54}).distance == Approx(0.05).margin(1e-9));  // a corner, not a mitre
}
