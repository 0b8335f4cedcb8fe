// What reading a large table costs, and what a commit of one edit and of forty costs beside it.
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <functional>

#include "engine/core/at.h"
#include "engine/io/text_patch.h"
#include "engine/scene/catalog.h"

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

}  // namespace

int main() {
    const auto catalog = std::make_shared<const Catalog>(built_in_catalog());
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
