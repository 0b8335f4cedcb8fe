#include "engine/program/raster.h"

#include <catch2/catch.hpp>

#include "engine/core/at.h"
#include "engine/program/evaluate.h"
#include "engine/scene/playfield.h"
#include "tests/program/tables.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

Vec2 pixel_centre(const Raster& r, int x, int y) {
    const Vec2 pixel = r.window.size().cwiseQuotient(Vec2(r.width, r.height));
    return {r.window.lo.x() + (x + 0.5) * pixel.x(), r.window.hi.y() - (y + 0.5) * pixel.y()};
}

/// Of all visible solids by themselves: each one's true distance where it is known.
double least_distance(const Field& field, const Vec2& p) {
    double least = infinity;
    for (int i = 0; i < static_cast<int>(field.solids.size()); ++i)
        if (at(field.solids, i).visible) least = std::min(least, nearest_of_solid(field, i, p).distance);
    return least;
}

/// Of an empty raster, once it is filled.
double worst_error(const Field& field, Raster raster, sdf::Isa isa) {
    rasterize(field, ground_layer, isa, raster);
    double worst = 0;
    for (int y = 0; y < raster.height; ++y)
        for (int x = 0; x < raster.width; ++x) {
            const auto drawn = static_cast<double>(at(raster.distance, y * raster.width + x));
            worst = std::max(worst, std::fabs(least_distance(field, pixel_centre(raster, x, y)) - drawn));
        }
    return worst;
}

}  // namespace

TEST_CASE("every pixel of a raster is the least of the solids' distances there, for each instruction set") {
    Scene scene = playfield(catalog(), 80);
    RandomTree(scene, 5, false).grow({}, 3);
    const ProgramPtr program = compiled(scene);
    for (const sdf::Isa isa : {sdf::Isa::sse2, sdf::Isa::avx2}) {
        if (isa > sdf::best_isa()) continue;
        // Not a multiple of a tile.
        CHECK(worst_error(program->fixed, Raster{203, 157, Box2::of({-0.1, -0.2}, {0.6, 0.9}), {}, {}}, isa) < 2e-6);
    }
}

TEST_CASE("around a tree, or what is known by a formula alone, a pixel is the true distance") {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        INFO(seed);
        Scene scene(catalog());
        RandomTree(scene, seed, seed % 2 == 0).grow({}, 3);
        CHECK(worst_error(compiled(scene)->fixed, Raster{160, 160, Box2::centred(1, 1), {}, {}}, sdf::best_isa()) < 4e-6);
    }
    Scene scene(catalog());
    const NodeId twisted = add(scene, "twist", {}, {{"at", Vec2(0.3, 0.3)}, {"radius", 0.2}});
    add(scene, "star", twisted, {{"outer", 0.2}, {"inner", 0.1}});
    const NodeId drop = add(scene, "smooth_union", add(scene, "round", {}, {{"radius", 0.005}, {"at", Vec2(0.7, 0.7)}}));
    add(scene, "box", drop, {{"size", Vec2(0.3, 0.1)}});
    add(scene, "ellipse", drop, {{"radii", Vec2(0.05, 0.15)}});
    CHECK(worst_error(compiled(scene)->fixed, Raster{160, 160, Box2::of({0, 0}, {1, 1}), {}, {}}, sdf::best_isa()) < 2e-6);
    set(*scene.find(twisted), "visible", false);
    const NodeId around = add(scene, "twist", add(scene, "round", {}, {{"radius", 0.005}, {"at", Vec2(0.3, 0.3)}}), {{"radius", 0.2}});
    add(scene, "star", around, {{"outer", 0.2}, {"inner", 0.1}});
    CHECK(worst_error(compiled(scene)->fixed, Raster{160, 160, Box2::of({0, 0}, {1, 1}), {}, {}}, sdf::best_isa()) < 2e-6);
}

TEST_CASE("deep in two solids that overlap each pixel is the deeper one's, whichever comes first") {
    Scene scene(catalog());
    set(scene.table(), "size", Vec2(1, 1));
    for (const double x : {0.4, 0.6, 0.4}) add(scene, "circle", {}, {{"radius", 0.35}, {"at", Vec2(x, 0.5)}});
    const ProgramPtr program = compiled(scene);
    Raster raster{1000, 1000, Box2::of({0, 0}, {1, 1}), {}, {}};
    rasterize(program->fixed, ground_layer, sdf::best_isa(), raster);
    double worst = 0;
    for (int x = 0; x < raster.width; ++x) {
        const double truth = least_distance(program->fixed, pixel_centre(raster, x, 500));
        worst = std::max(worst, std::fabs(truth - static_cast<double>(at(raster.distance, 500 * raster.width + x))));
    }
    CHECK(worst < 2e-6);
}

TEST_CASE("a pixel in a solid shows the material of the leaf that it belongs to") {
    Scene scene(catalog());
    set(scene.table(), "size", Vec2(1, 1));
    for (const char* name : {"wood", "steel"}) scene.add_material(name);
    const NodeId both = add(scene, "union", {}, {{"material", std::string("wood")}});
    add(scene, "box", both, {{"size", Vec2(0.2, 0.2)}, {"at", Vec2(0.3, 0.5)}});
    add(scene, "box", both, {{"size", Vec2(0.2, 0.2)}, {"at", Vec2(0.7, 0.5)}, {"material", std::string("steel")}});
    const ProgramPtr program = compiled(scene);
    Raster raster{100, 100, Box2::of({0, 0}, {1, 1}), {}, {}};
    rasterize(program->fixed, ground_layer, sdf::best_isa(), raster);
    CHECK(raster.material[50 * 100 + 30] == 1);
    CHECK(raster.material[50 * 100 + 70] == 2);
}

TEST_CASE("a mover is laid over the static field where it is") {
    Scene scene(catalog());
    set(scene.table(), "size", Vec2(1, 1));
    add(scene, "flipper", {}, {{"at", Vec2(0.5, 0.5)}});
    const ProgramPtr program = compiled(scene);
    Raster raster{200, 200, Box2::of({0, 0}, {1, 1}), {}, {}};
    rasterize(program->fixed, ground_layer, sdf::best_isa(), raster);
    const Mover& mover = program->movers[0];
    const Similarity world_from_mover{0, 1, 1, false, mover.pivot};  // a quarter turn: the bat points up
    rasterize_over(mover, world_from_mover, sdf::best_isa(), raster);
    for (int y = 0; y < 200; y += 3)
        for (int x = 0; x < 200; x += 3) {
            const Vec2 p = pixel_centre(raster, x, y);
            const double truth = std::min(least_distance(program->fixed, p),
                                          least_distance(mover.field, world_from_mover.inverse() * p));
            REQUIRE(static_cast<double>(at(raster.distance, y * 200 + x)) ==
                    Approx(truth).margin(2e-6));
        }
}

TEST_CASE("a window without solids is empty and still has a color") {
    Program program;
    program.materials.emplace_back();
    Raster raster{20, 10, Box2::of({0, 0}, {0.2, 0.1}), {}, {}};
    rasterize(program.fixed, ground_layer, sdf::best_isa(), raster);
    CHECK(raster.material[0] == -1);
    CHECK(shaded_picture(raster, program).size() == 600);
    const auto empty = isoline_picture(raster, 0.01);
    CHECK(empty.size() == 600);
    raster.distance.assign(200, 5000);
    CHECK(isoline_picture(raster, 0.01) == empty);
}

TEST_CASE("sampling again only what an edit can have changed gives the raster of the edited field, bit for bit") {
    int partial = 0, whole = 0;
    for (std::uint64_t seed = 1; seed <= 24; ++seed) {
        INFO(seed);
        Scene scene = playfield(catalog(), 60);
        RandomTree(scene, seed, seed % 2 == 0).grow({}, 3);
        CounterRng rng(seed, 77);
        ProgramPtr before = compiled(scene);
        Raster raster{211, 307, Box2::of({-0.05, -0.05}, {0.57, 0.95}), {}, {}};
        rasterize(before->fixed, ~LayerMask{0}, sdf::best_isa(), raster);
        for (int edit = 0; edit < 6; ++edit) {
            const auto& roots = scene.roots();
            Node& node = *scene.find(roots[static_cast<std::size_t>(rng.in(0, static_cast<double>(roots.size()) - 0.01))]);
            if (!node.type->find_field("at")) continue;
            if (edit == 3)
                set(node, "visible", false);
            else
                set(node, "at", Vec2(node.get<Vec2>("at") + Vec2(rng.in(-0.1, 0.1), rng.in(-0.1, 0.1))));
            const ProgramPtr after = compiled(scene);
            const std::vector<float> old = raster.distance;
            const PixelBox changed = rasterize_changes(before->fixed, after->fixed, ~LayerMask{0}, sdf::best_isa(), raster);
            Raster fresh{raster.width, raster.height, raster.window, {}, {}};
            rasterize(after->fixed, ~LayerMask{0}, sdf::best_isa(), fresh);
            const bool same_distances = raster.distance == fresh.distance, same_materials = raster.material == fresh.material;
            CHECK(same_distances);
            CHECK(same_materials);
            int outside = 0;
            for (int y = 0; y < raster.height; ++y)
                for (int x = 0; x < raster.width; ++x) {
                    const bool inside = x >= changed.left && x < changed.right && y >= changed.top && y < changed.bottom;
                    outside += !inside && at(old, y * raster.width + x) != at(fresh.distance, y * raster.width + x);
                }
            CHECK(outside == 0);
            const int area = (changed.right - changed.left) * (changed.bottom - changed.top);
            (area < raster.width * raster.height ? partial : whole) += 1;
            before = after;
        }
    }
    CHECK(partial > whole);  // else nothing is gained
}
