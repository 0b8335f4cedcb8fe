// my_shape TABLE OUT.png: reads a table that has shields in it, draws it, drops balls on it and says what they hit.
#include "shield.h"

#include <fmt/format.h>

#include <map>
#include <memory>

#include "engine/io/load_table.h"
#include "engine/io/png.h"
#include "engine/physics/audit.h"
#include "engine/physics/world.h"
#include "engine/program/compile.h"
#include "engine/program/raster.h"
#include "engine/scene/catalog.h"
#include "engine/sdf/own_node.h"

using namespace pinfield;

namespace {

void print(const Diagnostics& diagnostics, const Sources& sources) {
    for (const Diagnostic& diagnostic : diagnostics) fmt::print(stderr, "{}\n", format(diagnostic, sources));
}

bool draw(const Program& program, const std::string& path) {
    constexpr double pixels_per_metre = 1600;
    Raster raster;
    raster.width = static_cast<int>(program.size.x() * pixels_per_metre);
    raster.height = static_cast<int>(program.size.y() * pixels_per_metre);
    raster.window = {{0, 0}, program.size};
    rasterize(program.fixed, ground_layer, sdf::best_isa(), raster);
    const auto written = write_png(path, raster.width, raster.height, shaded_picture(raster, program));
    if (!written) fmt::print(stderr, "{}\n", written.error().message);
    return written.has_value();
}

/// Balls roll from the spawns, and again when the drain has had them. True when none ever overlapped a solid.
bool play(const Scene& scene, const ProgramPtr& program, double seconds) {
    World world(program);
    world.record_paths(true);
    world.add_spawned_balls();
    Auditor auditor;
    std::map<std::string, int> hits;
    int drained = 0;
    while (world.time() < seconds) {
        world.step();
        auditor.after_tick(world);
        for (const Event& event : world.events()) {
            const Node* node = scene.find(event.node);
            if (event.kind == EventKind::hit && node && node->type->key() == "shield") ++hits[scene.path(node->id)];
            if (event.kind != EventKind::drain) continue;
            ++drained;
            world.put_back(event.ball);
        }
    }
    fmt::print("{} balls for {} s: {} drained\n", world.balls().size(), seconds, drained);
    for (const auto& [name, count] : hits) fmt::print("  {:<12} hit {:>3} times\n", name, count);
    const AuditReport& audit = auditor.report();
    fmt::print("  audit        {} segments, worst depth {:.3g} m, {} crossings\n", audit.segments, audit.worst_depth, audit.crossings);
    return !hits.empty() && audit.crossings == 0 && audit.worst_depth < 1e-6;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return fmt::print(stderr, "usage: my_shape TABLE OUT.png\n"), 2;

    // The one line that makes a shape part of the language: reader, schema, editor and physics go by the catalog.
    auto catalog = std::make_shared<Catalog>(built_in_catalog());
    add_scene_type(*catalog, sdf::sdf_node_type<my::Shield>());

    const auto table = load_table(argv[1], catalog);
    if (!table) return fmt::print(stderr, "{}\n", table.error().message), 3;
    print(table->diagnostics, table->scene.sources);
    if (!table->ok()) return 1;
    const auto program = compile(table->scene);
    if (!program) return print(program.error(), table->scene.sources), 1;

    if (!draw(**program, argv[2])) return 3;
    return play(table->scene, *program, 20) ? 0 : 1;
}
