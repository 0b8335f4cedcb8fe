// Medians of what the program layer costs, on the generated playfield: `bench_program [picture-prefix]` also draws it.
#include <array>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <functional>

#include "engine/core/at.h"
#include "engine/core/rng.h"
#include "engine/io/load_table.h"
#include "engine/io/png.h"
#include "engine/program/compile.h"
#include "engine/program/evaluate.h"
#include "engine/program/patch.h"
#include "engine/program/raster.h"
#include "engine/scene/catalog.h"
#include "engine/scene/playfield.h"

using namespace pinfield;

namespace {

/// Of this process alone: a busy machine would count in the wall clock's.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Median seconds of one call, over several batches.
double median_time(int calls, const std::function<void()>& run) {
    std::vector<double> times;
    for (int batch = 0; batch < 9; ++batch) {
        const double start = cpu_seconds();
        for (int i = 0; i < calls; ++i) run();
        times.push_back((cpu_seconds() - start) / calls);
    }
    std::sort(times.begin(), times.end());
    return times[times.size() / 2];
}

std::vector<Vec2> free_points(const Program& program, int n) {
    CounterRng random(5);
    std::vector<Vec2> points;
    while (static_cast<int>(points.size()) < n) {
        const double x = random.in(0, program.size.x());
        const Vec2 p(x, random.in(0, program.size.y()));
        if (nearest(program.fixed, p).distance > 0) points.push_back(p);
    }
    return points;
}

void bench_queries(const Program& program) {
    const std::vector<Vec2> points = free_points(program, 4096);
    const auto per_point = [&](const char* what, auto&& query) {
        double sum = 0;
        const double t = median_time(3, [&] {
            for (const Vec2& p : points) sum += query(p);
        });
        fmt::print("{:<44} {:8.1f} ns   (sum {:.6g})\n", what, 1e9 * t / static_cast<double>(points.size()), sum);
    };
    per_point("nearest_outside, reach 0.03 m",
              [&](const Vec2& p) { return nearest_outside(program.fixed, p, ground_layer, 0.03).distance; });
    per_point("nearest_outside, no reach",
              [&](const Vec2& p) { return nearest_outside(program.fixed, p, ground_layer, infinity).distance; });
    per_point("nearest", [&](const Vec2& p) { return nearest(program.fixed, p).distance; });
    per_point("overlapping, box of 0.03 m", [&](const Vec2& p) {
        int count = 0;
        program.fixed.bvh.overlapping(Box2{p, p}.grown(0.015), [&](int) { ++count; });
        return count;
    });
}

void bench_raster(const Program& program, const std::string& picture) {
    Raster raster{1024, 1024, Box2::of({-0.01, -0.01}, program.size + Vec2(0.01, 0.01)), {}, {}};
    for (const sdf::Isa isa : {sdf::Isa::sse2, sdf::Isa::avx2}) {
        if (isa > sdf::best_isa()) continue;
        const double t = median_time(5, [&] { rasterize(program.fixed, ground_layer, isa, raster); });
        fmt::print("{:<44} {:8.2f} ms\n",
                   isa == sdf::Isa::avx2 ? "raster 1024 x 1024, avx2" : "raster 1024 x 1024, sse2", 1e3 * t);
    }
    std::vector<unsigned char> rgb;
    fmt::print("{:<44} {:8.2f} ms\n", "shaded picture 1024 x 1024",
               1e3 * median_time(1, [&] { rgb = shaded_picture(raster, program); }));
    if (picture.empty()) return;
    raster.height = 1024;
    raster.width = static_cast<int>(1024 * program.size.x() / program.size.y());
    rasterize(program.fixed, ground_layer, sdf::best_isa(), raster);
    for (const Mover& mover : program.movers)
        rasterize_over(mover, Similarity{mover.cosine, mover.sine, 1, false, mover.pivot}, sdf::best_isa(), raster);
    for (const bool shaded : {true, false}) {
        rgb = shaded ? shaded_picture(raster, program) : isoline_picture(raster, 0.010);
        const auto written = write_png(picture + (shaded ? "_shaded.png" : "_isolines.png"), raster.width, raster.height, rgb);
        if (!written) fmt::print("{}\n", written.error().message);
    }
}

void bench(const std::string& name, Scene& scene, const std::string& picture) {
    const auto program = compile(scene);
    if (!program) {
        fmt::print("{}: {}\n", name, program.error()[0].message);
        return;
    }
    const Field& field = (*program)->fixed;
    fmt::print("{}: {} solids, {} ops, {} pieces, {} trees\n", name, field.solids.size(), field.ops.size(),
               field.pieces.size(), field.tree_solids.size());
    fmt::print("{:<44} {:8.1f} us\n", "compile", 1e6 * median_time(5, [&] {
                                                     if (!compile(scene)) std::abort();
                                                 }));
    NodeId last = scene.roots().back();
    const int place = *scene.find(last)->type->find_field("at");
    const double t = median_time(50, [&] {
        std::get<Vec2>(at(scene.find(last)->fields, place).value).x() += 1e-7;
        if (!patch(**program, scene, std::array{FieldChange{last, place}})) std::abort();
    });
    fmt::print("{:<44} {:8.1f} us\n", "patch of one solid's place", 1e6 * t);
    bench_queries(**program);
    bench_raster(**program, picture);
}

}  // namespace

int main(int argc, char** argv) {
    const std::string prefix = argc > 1 ? argv[1] : "";
    const auto catalog = std::make_shared<const Catalog>(built_in_catalog());
    Scene field = playfield(catalog, 200);
    bench("playfield", field, prefix.empty() ? "" : prefix + "playfield");
    if (argc > 2) {
        auto table = load_table(argv[2], catalog);
        if (table && table->ok()) bench(argv[2], table->scene, prefix + "table");
    }
    return 0;
}
