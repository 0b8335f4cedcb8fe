// What reading a large table costs, and what a commit of one edit and of forty costs beside it; what it costs to say things once, and to move a
// slider.
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <functional>

#include "engine/core/at.h"
#include "engine/io/load_table.h"
#include "engine/io/param_patch.h"
#include "engine/io/text_patch.h"
#include "engine/io/write_table.h"
#include "engine/scene/catalog.h"
#include "engine/scene/expanded.h"
#include "tests/places.h"

using namespace pinfield;

namespace {

/// Median processor seconds of one call.
double median_time(const std::function<void()>& run) {
    std::vector<double> times;
    for (int i = 0; i < 15; ++i) {
        const std::clock_t start = std::clock();
        run();
        times.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    std::sort(times.begin(), times.end());
    return times[times.size() / 2];
}

/// Some 300 kB of nodes as authors write them.
std::string large_table() {
    std::string text = "pinfield: 1\nscene:\n";
    for (int i = 0; text.size() < 300'000; ++i)
        text += fmt::format("  - circle: {{id: c{}, at: [{}mm, {}mm], radius: 3mm, material: default}}  # post {}\n", i, i % 500, i / 500, i);
    return text;
}

/// A table that says things once against the same written out.
void compare_with_twin(const std::shared_ptr<const Catalog>& catalog, const std::string& path) {
    const Result<Reading> once = load_table(test::source_dir() + "/" + path, catalog);
    if (!once) return fmt::print("{}: {}\n", path, once.error().message);
    const auto source = once->scene.sources.shared_main();
    const auto twin = std::make_shared<const SourceText>("twin.yaml", write_table(expanded(once->scene)));
    const double said = median_time([&] { for (int i = 0; i < 20; ++i) read_table(source, catalog); });
    const double written = median_time([&] { for (int i = 0; i < 20; ++i) read_table(twin, catalog); });
    fmt::print("{}: read_table {:.2f} ms, written out {:.2f} ms: {:.2f} times\n", path, 50 * said, 50 * written, said / written);
}

/// A param that a hundred of ten thousand nodes follow.
void move_slider(const std::shared_ptr<const Catalog>& catalog) {
    std::string text = "pinfield: 1\nparams: {gap: 3mm}\nscene:\n";
    for (int i = 0; i < 10000; ++i)
        text += fmt::format("  - circle: {{at: [{}mm, {}mm], radius: {}}}\n", i % 500, i / 500, i % 100 == 0 ? "gap" : "3mm");
    const Reading reading = read_table(std::make_shared<const SourceText>("params.yaml", text), catalog);
    double value = 0.003;
    const double moved = median_time([&] { scene_with_param(reading, "gap", value += 1e-5).value(); });
    fmt::print("a param of a table of 10000 nodes, of which 100 follow it: {:.1f} ms\n", 1e3 * moved);
}

}  // namespace

int main() {
    const auto catalog = std::make_shared<const Catalog>(built_in_catalog());
    for (const char* path : {"scenes/tables/garden.yaml", "tests/program/moonrise_once.yaml"}) compare_with_twin(catalog, path);
    move_slider(catalog);
    const auto source = std::make_shared<const SourceText>("large.yaml", large_table());
    const Reading reading = read_table(source, catalog);
    std::vector<Edit> edits;
    for (int i = 0; i < 40; ++i) {
        const Node& node = *reading.scene.find(at(reading.scene.roots(), 20 * i));
        SetField edit{node.id, *node.type->find_field("at"), {}, true};
        edit.value = Vec2(0.1 + 0.001 * i, 0.2);
        edits.emplace_back(edit);
    }
    const double read = median_time([&] { read_table(source, catalog); });
    fmt::print("{:.0f} kB, {} nodes: read_table {:.1f} ms\n", static_cast<double>(source->text().size()) / 1000, reading.scene.roots().size(),
               1e3 * read);
    for (const std::size_t count : {std::size_t{1}, edits.size()}) {
        int readings = 0;
        const double commit = median_time([&] { readings = patch_for(reading, std::span(edits).first(count))->readings; });
        fmt::print("commit of {:2} edits {:.1f} ms, {} reading: {:.2f} times read_table\n", count, 1e3 * commit, readings, commit / read);
    }
}
