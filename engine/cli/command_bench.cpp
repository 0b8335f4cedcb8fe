// pinfield bench: how fast physics, raster and parameter edits are, on a generated playfield of 200 obstacles, one thread.
#include <fmt/format.h>
#include <array>

#include <algorithm>
#include <chrono>

#include "engine/cli/command.h"
#include "engine/cli/json.h"
#include "engine/cli/output.h"
#include "engine/physics/bench.h"
#include "engine/program/compile.h"
#include "engine/program/patch.h"
#include "engine/program/raster.h"
#include "engine/scene/catalog.h"
#include "engine/scene/playfield.h"

namespace pinfield::cli {
namespace {

constexpr int obstacles = 200, balls = 100, ticks = 2000, pixels = 1024;
constexpr double speed = 1;  // m/s

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return n % 2 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

/// Median wall time of `runs` calls, seconds.
template <class Work>
double time_of(int runs, Work&& work) {
    std::vector<double> times;
    for (int i = 0; i < runs; ++i) {
        const auto start = std::chrono::steady_clock::now();
        work();
        times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return median(std::move(times));
}

double ball_steps_per_second(const ProgramPtr& program, int runs) {
    std::vector<double> rates;
    for (int i = 0; i < runs; ++i) rates.push_back(bench_simulation(program, balls, speed, ticks).ball_steps_per_second);
    return median(std::move(rates));
}

double raster_seconds(const Program& program, sdf::Isa isa, int runs) {
    Raster raster;
    raster.width = raster.height = pixels;
    raster.window = {{0, 0}, program.size};
    return time_of(runs, [&] { rasterize(program.fixed, ground_layer, isa, raster); });
}

/// Moves one obstacle to and fro.
double patch_seconds(Scene& scene, const ProgramPtr& program, int runs) {
    const Node& node = *scene.find(scene.roots().at(scene.roots().size() / 2));
    const int at = *node.type->find_field("at");
    const Vec2 home = node.get<Vec2>("at");
    ProgramPtr current = program;
    int count = 0;
    return time_of(runs, [&] {
        apply(scene, {node.id, at, home + Vec2(0, 1e-4 * (++count % 2)), true});
        ProgramPtr next = patch(*current, scene, std::array{FieldChange{node.id, at}});
        if (!next) throw Stop{ExitCode::failed, "a parameter edit was refused by patch()", ""};
        current = std::move(next);
    });
}

void bench(bool json, int runs) {
    Scene scene = playfield(std::make_shared<const Catalog>(built_in_catalog()), obstacles);
    const auto compiled = compile(scene);
    if (!compiled) throw Stop{ExitCode::failed, "the generated playfield does not compile", ""};
    const ProgramPtr program = *compiled;
    const double rate = ball_steps_per_second(program, runs);
    const double raster = raster_seconds(*program, sdf::best_isa(), 10 * runs);
    const double raster_sse2 = raster_seconds(*program, sdf::Isa::sse2, 10 * runs);
    const double edit = patch_seconds(scene, program, 200 * runs);
    const double whole = time_of(10 * runs, [&] { (void)compile(scene); });
    const std::string_view isa = sdf::best_isa() == sdf::Isa::avx2 ? "avx2" : "sse2";
    if (json) {
        print(JsonObject()
                  .add("obstacles", obstacles)
                  .add("balls", balls)
                  .add("ball_steps_per_second", rate)
                  .add("raster_pixels", pixels)
                  .add("raster_isa", isa)
                  .add("raster_seconds", raster)
                  .add("raster_sse2_seconds", raster_sse2)
                  .add("patch_seconds", edit)
                  .add("compile_seconds", whole)
                  .text() +
              "\n");
        return;
    }
    print(
        fmt::format("generated playfield: {} obstacles, {} elastic balls, {:g} m/s, one thread; medians\n"
                    "  physics  {:8.2f} million ball-steps/s\n"
                    "  raster   {:8.2f} ms for {} x {} ({}), {:.2f} ms (sse2)\n"
                    "  patch    {:8.4f} ms for a moved obstacle\n"
                    "  compile  {:8.2f} ms\n",
                    obstacles, balls, speed, rate * 1e-6, raster * 1e3, pixels, pixels, isa, raster_sse2 * 1e3, edit * 1e3, whole * 1e3));
}

}  // namespace

void add_bench(const Command& app, ExitCode& exit) {
    const Command command = app.subcommand("bench", "Measure physics, raster and parameter edits on a generated playfield");
    const auto json = std::make_shared<bool>(false);
    const auto runs = std::make_shared<int>(5);
    command.flag("--json", *json, "Print the figures as JSON");
    command.option("--runs", *runs, "Runs that each median is taken over").range(1, 1000).show_default();
    command.callback([json, runs, &exit] {
        bench(*json, *runs);
        exit = ExitCode::fine;
    });
}

}  // namespace pinfield::cli
