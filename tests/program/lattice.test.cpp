// Infinite repetition against the same copies written out, which are known to be right.
#include <catch2/catch.hpp>

#include "engine/core/at.h"
#include "engine/core/rng.h"
#include "engine/program/evaluate.h"
#include "tests/program/tables.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

/// A child that a lattice is made of, of several kinds: small in its cell, off its centre, reaching over several cells, a CSG tree whose
/// own formula is only a bound, and one that is known by its formula alone.
void add_child(Scene& scene, NodeId parent, int kind) {
    const Vec2 at = kind == 1 ? Vec2(0.021, -0.017) : Vec2(0, 0);
    switch (kind) {
        case 0:
        case 1: add(scene, "box", parent, {{"size", Vec2(0.02, 0.01)}, {"at", at}, {"turn", 25.0}}); return;
        case 2: add(scene, "segment", parent, {{"a", Vec2(-0.13, -0.05)}, {"b", Vec2(0.11, 0.07)}, {"thickness", 0.004}}); return;
        case 3: {
            const NodeId lens = add(scene, "intersection", parent);
            add(scene, "circle", lens, {{"radius", 0.03}, {"at", Vec2(-0.024, 0)}});
            add(scene, "circle", lens, {{"radius", 0.03}, {"at", Vec2(0.024, 0.003)}});
            return;
        }
        default: add(scene, "ellipse", parent, {{"radii", Vec2(0.03, 0.008)}, {"turn", 50.0}});
    }
}

constexpr int kinds = 5;

/// A solid that is asked for beside the one that stands for it.
struct Pair {
    ProgramPtr program, written_out;

    /// How much farther away the lattice says it is.
    double apart(const Vec2& p) const {
        const Nearest a = nearest_of_solid(program->fixed, first(*program), p), b = written(p);
        CHECK(std::fabs(length(a.gradient) - 1) < 1e-9);
        return a.distance - b.distance;
    }
    Nearest written(const Vec2& p) const { return nearest_of_solid(written_out->fixed, first(*written_out), p); }
    static int first(const Program& program) {
        for (std::size_t i = 0; i < program.fixed.solids.size(); ++i)
            if (!program.fixed.solids[i].is_domain) return static_cast<int>(i);
        return -1;
    }
};

template <class Add>
Pair pair_of(Add add_solid) {
    Scene endless(catalog()), finite(catalog());
    add_solid(endless, true);
    add_solid(finite, false);
    return {compiled(endless), compiled(finite)};
}

NodeId add_lattice(Scene& scene, NodeId parent, bool infinite, const Vec2& step) {
    if (infinite) return add(scene, "repeat_infinite", parent, {{"step", step}, {"turn", 10.0}, {"at", Vec2(0.01, 0.02)}});
    const Vec2 count(step.x() > 0 ? 13 : 1, step.y() > 0 ? 13 : 1);
    return add(scene, "repeat", parent, {{"count", count}, {"step", step}, {"turn", 10.0}, {"at", Vec2(0.01, 0.02)}});
}

}  // namespace

TEST_CASE("copies without end are as far away as copies written out, however far the child reaches") {
    for (int kind = 0; kind < kinds; ++kind)
        for (const Vec2& step : {Vec2(0.07, 0.05), Vec2(0.07, 0), Vec2(0, 0.09)}) {
            INFO("child " << kind << ", step " << step.x() << ", " << step.y());
            const Pair pair = pair_of([&](Scene& scene, bool infinite) { add_child(scene, add_lattice(scene, {}, infinite, step), kind); });
            CounterRng rng(17);
            for (int i = 0; i < 500; ++i) {  // well within the finite one
                const double x = rng.in(-0.2, 0.2);
                const Vec2 p(x, rng.in(-0.2, 0.2));
                const double apart = pair.apart(p);
                INFO("(" << p.x() << ", " << p.y() << ") " << apart);
                REQUIRE(apart > -1e-9);
                // Where copies cross, the depth in one of them is less than that in all.
                if (kind != 2 || pair.written(p).distance > 0) REQUIRE(apart < 1e-9);
            }
        }
}

TEST_CASE("what a lattice cuts out of a plate is cut exactly") {
    for (int kind = 0; kind < kinds; ++kind) {
        INFO("child " << kind);
        const Pair pair = pair_of([&](Scene& scene, bool infinite) {
            const NodeId plate = add(scene, "difference", {});
            add(scene, "circle", plate, {{"radius", 0.15}});
            add_child(scene, add_lattice(scene, plate, infinite, {0.07, 0.06}), kind);
        });
        CHECK(at(pair.program->fixed.solids, Pair::first(*pair.program)).lowered);
        CounterRng rng(18);
        for (int i = 0; i < 2000; ++i) {
            const double x = rng.in(-0.2, 0.2);
            REQUIRE(std::fabs(pair.apart({x, rng.in(-0.2, 0.2)})) < 1e-9);
        }
    }
}

TEST_CASE("what has no end, or reaches over thousands of cells, is not repeated without end") {
    Scene endless(catalog());
    add(endless, "half_plane", add(endless, "repeat_infinite", {}));
    const auto without_end = compile(endless);
    REQUIRE_FALSE(without_end);
    CHECK(without_end.error()[0].code == "E0209");
    CHECK(without_end.error()[0].message == "what has no end cannot be repeated without end");

    Scene crowded(catalog());
    add(crowded, "circle", add(crowded, "repeat_infinite", {}, {{"step", Vec2(0.001, 0.001)}}), {{"radius", 0.05}});
    const auto too_many = compile(crowded);
    REQUIRE_FALSE(too_many);
    CHECK(too_many.error()[0].code == "E0209");
}

TEST_CASE("repetitions that multiply beyond a second's work are refused before anything is made of them") {
    Scene scene(catalog());
    NodeId innermost;
    for (int depth = 0; depth < 6; ++depth) innermost = add(scene, "repeat", innermost, {{"count", Vec2(4, 4)}});
    add(scene, "circle", innermost);
    const auto refused = compile(scene);
    REQUIRE_FALSE(refused);
    CHECK(refused.error()[0].code == "E0112");
    Scene plain(catalog());  // one alone has its own limit
    add(plain, "circle", add(plain, "repeat", {}, {{"count", Vec2(32, 32)}}));
    CHECK(compile(plain));
}
