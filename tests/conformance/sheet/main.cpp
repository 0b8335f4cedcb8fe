// conformance_sheet: measures every shape and operation, and writes or checks docs/nodes/.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "engine/io/files.h"
#include "engine/io/starters.h"
#include "engine/scene/catalog.h"
#include "tests/conformance/sheet/page.h"
#include "tests/conformance/sheet/picture.h"
#include "tests/places.h"

namespace {

using namespace pinfield;
using namespace pinfield::conformance;
namespace fs = std::filesystem;

const std::string root = test::source_dir() + "/";
constexpr int shape_sets = 12, operation_sets = 4;  // the latter over several sets of children each

template <class T>
T value_or_stop(Result<T> result) {
    if (result) return std::move(*result);
    fmt::print(stderr, "conformance_sheet: {}\n", result.error().message);
    std::exit(3);
}

std::string example_of(const NodeType& type) { return fmt::format("{}scenes/nodes/{}.yaml", root, type.key()); }

/// Its text; the modeline is for text editors.
std::string text_of_example(const NodeType& type) {
    const std::string text = value_or_stop(read_file(example_of(type))), first = modeline("../table.schema.json");
    return text.starts_with(first) ? text.substr(first.size()) : text;
}

std::vector<const NodeType*> measured_types(const Catalog& catalog) {
    std::vector<const NodeType*> out;
    for (const NodeType& type : catalog.types())
        if (type.kernels) out.push_back(&type);
    return out;
}

/// All files of the folder that are text, by name.
std::map<std::string, std::string> sheet(const Catalog& catalog, const Timings& timings) {
    std::vector<Entry> entries;
    for (const NodeType* type : measured_types(catalog)) {
        if (!fs::exists(root + header_of(*type))) value_or_stop<bool>(failure(header_of(*type) + " does not exist"));
        const auto timing = timings.find(type->key());
        const int sets = type->meta.kind == NodeKind::shape ? shape_sets : operation_sets;
        entries.push_back({type, measure(catalog, *type, sets), timing == timings.end() ? Timing{} : timing->second,
                           text_of_example(*type)});
    }
    std::map<std::string, std::string> files{{"README.md", index_of(entries)}, {"timings.csv", csv_of(catalog, timings)}};
    for (const Entry& entry : entries) files.emplace(fmt::format("{}.md", entry.type->key()), page_of(entry));
    return files;
}

Timings timings_of(const std::string& folder) { return value_or_stop(read_timings(value_or_stop(read_file(folder + "/timings.csv")))); }

/// Those that are not known yet.
void add_timings(const Catalog& catalog, Timings& timings) {
    for (const NodeType* type : measured_types(catalog))
        if (!timings.contains(type->key())) timings.emplace(type->key(), time_of(catalog, *type));
}

/// Where two texts first differ, for the person who wonders why.
std::string first_difference(const std::string& now, const std::string& before) {
    std::istringstream a(now), b(before);
    std::string x, y;
    for (int line = 1;; ++line) {
        const bool more_a = static_cast<bool>(std::getline(a, x)), more_b = static_cast<bool>(std::getline(b, y));
        if (!more_a && !more_b) return "";
        if (more_a != more_b || x != y)
            return fmt::format("line {}:\n  is        {}\n  should be {}", line, more_b ? y : "", more_a ? x : "");
    }
}

bool is_fresh(const std::shared_ptr<const Catalog>& catalog, const std::string& folder) {
    std::set<std::string> stale;
    const auto files = sheet(*catalog, timings_of(folder));
    for (const auto& [name, text] : files) {
        const auto path = fmt::format("{}/{}", folder, name);
        const std::string before = fs::exists(path) ? value_or_stop(read_file(path)) : "";
        if (before == text) continue;
        fmt::print("{} is stale, {}\n", path, first_difference(text, before));
        stale.insert(name);
    }
    for (const auto& file : fs::directory_iterator(folder)) {
        const fs::path name = file.path().filename(), page = fs::path(name).replace_extension(".md");
        if (files.contains(name.string()) || (name.extension() == ".png" && files.contains(page.string()))) continue;
        fmt::print("{} belongs to no node\n", file.path().string());
        stale.insert(name.string());
    }
    for (const NodeType* type : measured_types(*catalog))
        if (const auto picture = fmt::format("{}/{}.png", folder, type->key()); !fs::exists(picture)) {
            fmt::print("{} is missing\n", picture);
            stale.insert(picture);
        }
    if (!stale.empty()) fmt::print("Run `conformance_sheet --out {} --keep-timings`.\n", folder);
    return stale.empty();
}

void write(const std::shared_ptr<const Catalog>& catalog, const std::string& folder, bool keep_timings) {
    fs::create_directories(folder);
    Timings timings = keep_timings ? timings_of(folder) : Timings{};
    add_timings(*catalog, timings);
    // Through the file's own rounding, so that a check reads what the pages say.
    const Timings rounded = value_or_stop(read_timings(csv_of(*catalog, timings)));
    for (const auto& [name, text] : sheet(*catalog, rounded)) value_or_stop(write_file(fmt::format("{}/{}", folder, name), text));
    for (const NodeType* type : measured_types(*catalog))
        value_or_stop(draw_example(example_of(*type), catalog, fmt::format("{}/{}.png", folder, type->key())));
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Measures every shape and operation, and writes the conformance sheet.", "conformance_sheet");
    std::string out, checked;
    bool keep_timings = false;
    CLI::Option* writes = app.add_option("--out", out, "Folder to write");
    app.add_option("--check", checked, "Folder to compare instead: exit 1 when a text in it is stale")->excludes(writes);
    app.add_flag("--keep-timings", keep_timings, "Take the nanoseconds that are in the folder's timings.csv from there")->needs(writes);
    app.require_option();
    CLI11_PARSE(app, argc, argv);

    const auto catalog = std::make_shared<const Catalog>(built_in_catalog());
    if (!checked.empty()) return is_fresh(catalog, checked) ? 0 : 1;
    write(catalog, out, keep_timings);
    return 0;
}
