// Whose surface it is: the weights of a tree's leaves.
#include <catch2/catch.hpp>

#include <cmath>

#include "engine/core/at.h"
#include "engine/program/evaluate.h"
#include "tests/program/blend_weights.h"
#include "tests/program/tables.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

constexpr const char* families[] = {"quadratic", "cubic", "quartic", "circular", "exponential", "chamfer", "stairs"};

Vec2 random_point(CounterRng& random) {
    const double x = random.in(-1, 1);
    return {x, random.in(-1, 1)};
}

/// Trees of discs and boxes under all kinds of operations.
void grow(Scene& scene, NodeId parent, int depth, CounterRng& random) {
    const auto pick = [&](int n) { return static_cast<int>(random.uniform() * n); };
    const Vec2 at = 0.4 * random_point(random);
    if (depth == 0) {
        if (pick(2)) add(scene, "circle", parent, {{"radius", random.in(0.1, 0.4)}, {"at", at}});
        else add(scene, "box", parent, {{"size", Vec2(random.in(0.1, 0.6), random.in(0.1, 0.6))}, {"at", at}, {"turn", random.in(0, 360)}});
        return;
    }
    constexpr std::string_view folds[] = {"smooth_union", "smooth_intersection", "smooth_difference", "union", "intersection", "xor"};
    constexpr std::string_view unary[] = {"mirror", "complement", "round", "onion", "twist", "repeat_polar"};
    if (pick(3) == 0) return grow(scene, add(scene, unary[pick(6)], parent, {{"scale", random.in(0.5, 1.5)}}), depth - 1, random);
    const std::string_view fold = folds[pick(6)];
    const NodeId id = add(scene, fold, parent, {{"at", Vec2(0.3 * at)}});
    if (fold.starts_with("smooth")) {
        set(*scene.find(id), "k", random.in(0.01, 0.2));
        set(*scene.find(id), "family", std::string(families[pick(7)]));
    }
    for (int i = 2 + pick(2); i > 0; --i) grow(scene, id, depth - 1, random);
}

}  // namespace

TEST_CASE("blend weights of any tree are positive, add up to one, name each leaf once, and the winner's is the greatest") {
    int shared = 0, several_winners = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        INFO("seed " << seed);
        Scene scene(catalog());
        CounterRng random(seed);
        grow(scene, {}, 1 + static_cast<int>(seed % 3), random);
        const ProgramPtr program = compiled(scene);
        const Field& field = program->fixed;
        for (int i = 0; i < 60; ++i) {
            const Vec2 p = random_point(random);
            int winner = -1;
            evaluate_tree(field, field.solids[0].root, p, &winner);
            const std::vector<BlendWeight> weights = blend_weights(field, field.solids[0].root, p);
            double sum = 0, greatest = 0, of_winner = 0;
            for (std::size_t k = 0; k < weights.size(); ++k) {
                REQUIRE(at(field.ops, weights[k].leaf).child_count == 0);
                REQUIRE(weights[k].weight > 0);
                if (k > 0) REQUIRE(weights[k - 1].leaf < weights[k].leaf);
                sum += weights[k].weight;
                greatest = std::max(greatest, weights[k].weight);
                if (weights[k].leaf == winner) of_winner = weights[k].weight;
            }
            REQUIRE(sum == Approx(1).epsilon(1e-12));
            REQUIRE(of_winner == Approx(greatest).epsilon(1e-12));
            shared += weights.size() > 1;
            several_winners += weights.size() > 2;
        }
    }
    CHECK(shared > 500);
    CHECK(several_winners > 100);
}

TEST_CASE("at the seam of two equal discs each has half of a blend, and a hard union hands all to one") {
    for (const char* family : families) {
        INFO(family);
        for (const bool smooth : {true, false}) {
            Scene scene(catalog());
            const NodeId both = add(scene, smooth ? "smooth_union" : "union");
            if (smooth) set(*scene.find(both), "family", std::string(family));
            add(scene, "circle", both, {{"radius", 0.25}, {"at", Vec2(-0.5, 0)}});
            add(scene, "circle", both, {{"radius", 0.25}, {"at", Vec2(0.5, 0)}});
            const ProgramPtr program = compiled(scene);
            const Field& field = program->fixed;
            const std::vector<BlendWeight> seam = blend_weights(field, field.solids[0].root, {0, 0.375});
            const bool divides = smooth && family != std::string_view("stairs");  // every point of stairs is of one step's face
            REQUIRE(seam.size() == (divides ? 2 : 1));
            for (const BlendWeight& w : seam) CHECK(w.weight == Approx(divides ? 0.5 : 1).epsilon(1e-12));
            // Far to one side nothing but the exponential blend knows of the other.
            const std::vector<BlendWeight> left = blend_weights(field, field.solids[0].root, {-0.8, 0});
            CHECK(left[0].weight == Approx(1));
            if (!smooth || family != std::string_view("exponential")) CHECK(left.size() == 1);
        }
    }
}

TEST_CASE("a gradient is the weighted sum of the leaves' own") {
    CounterRng random(9);
    for (const char* operation : {"smooth_union", "smooth_intersection", "union", "intersection"})
        for (const char* family : families) {
            Scene scene(catalog());
            const NodeId all = add(scene, operation);
            if (std::string_view(operation).starts_with("smooth")) {
                set(*scene.find(all), "family", std::string(family));
                set(*scene.find(all), "k", 0.1);
            }
            for (int i = 0; i < 4; ++i) add(scene, "circle", all, {{"radius", 0.3}, {"at", random_point(random)}});
            const ProgramPtr program = compiled(scene);
            const Field& field = program->fixed;
            if (field.solids[0].is_domain) continue;  // the discs have nothing in common
            for (int i = 0; i < 100; ++i) {
                const Vec2 p = random_point(random);
                Vec2 sum(0, 0);
                for (const BlendWeight& w : blend_weights(field, field.solids[0].root, p))
                    sum += w.weight * evaluate_tree(field, w.leaf, p).gradient;
                INFO(operation << " " << family << " at " << p.transpose());
                REQUIRE(length(sum - evaluate_tree(field, field.solids[0].root, p).gradient) < 1e-12);
            }
        }
}
