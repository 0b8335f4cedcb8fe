// pinfield new NAME [--from STARTER]: a table to begin with, that reads, tests and plays, with its schema where text editors look for it.
#include <fmt/format.h>

#include <filesystem>

#include "engine/cli/command.h"
#include "engine/cli/output.h"
#include "engine/core/closest.h"
#include "engine/core/shown.h"
#include "engine/io/files.h"
#include "engine/io/json_schema.h"
#include "engine/io/starters.h"
#include "engine/scene/catalog.h"

namespace pinfield::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view schema_name = "table.schema.json";

struct Options {
    std::string name;
    std::string from{starters().front().key};
};

/// A line each, with what they are.
std::string starter_lines() {
    std::string out;
    for (const Starter& starter : starters()) out += fmt::format("  {:<10} {}\n", starter.key, starter.doc);
    return out;
}

std::string why_no_name(const std::string& name) {
    const fs::path path(name);
    return path.filename().empty() || path.stem() == "." || path.stem() == ".." ? fmt::format("\"{}\" names no file", name) : "";
}

const Starter& starter_called(const std::string& key) {
    std::vector<std::string_view> keys;
    for (const Starter& starter : starters()) {
        if (starter.key == key) return starter;
        keys.push_back(starter.key);
    }
    throw Stop{ExitCode::usage, fmt::format("there is no starter \"{}\"; {}", key, suggestion(key, keys)), starter_lines()};
}

/// What a table is called whose file is called so: "deep_garden" is Deep garden.
std::string name_for(const std::string& stem) {
    std::string name = shown(stem);
    for (char& c : name)
        if (c == '_' || c == '-') c = ' ';
    if (name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
    return name;
}

/// The schema as a path from the table's folder: the one beside it, or in the folder above as in scenes/; there may be none beside it yet.
std::string schema_path(const fs::path& table) {
    std::error_code ignored;
    const fs::path folder = table.parent_path();
    const std::string name(schema_name);
    return !fs::exists(folder / name, ignored) && fs::exists(folder / ".." / name, ignored) ? "../" + name : name;
}

/// Writes the schema where there is none. One that is there stays, and is told when it is of another version.
void write_schema(const std::string& path, const Catalog& catalog) {
    std::error_code ignored;
    const std::string schema = json_schema(catalog);
    if (!fs::exists(path, ignored)) value_or_stop(save_file(path, schema, std::nullopt));
    else if (const auto there = read_file(path); !there || *there != schema)
        tell(fmt::format("pinfield: {} is not this version's schema; `pinfield schema` prints that\n", shown(path)));
}

void make_table(const Options& options) {
    const Starter& starter = starter_called(options.from);
    fs::path path(options.name);
    if (path.extension() != ".yaml" && path.extension() != ".yml") path += ".yaml";
    const auto catalog = std::make_shared<const Catalog>(built_in_catalog());
    const std::string schema = schema_path(path);
    const std::string text = value_or_stop(new_table(starter, name_for(path.stem().string()), schema, catalog));
    value_or_stop(save_file(path.string(), text, std::nullopt));
    write_schema((path.parent_path() / schema).string(), *catalog);
    print(fmt::format("{}: {}\n", shown(path.string()), starter.doc));
}

}  // namespace

void add_new(const Command& app, ExitCode& exit) {
    const Command command = app.subcommand("new", "Write a table to begin with, and its schema for text editors");
    const auto options = std::make_shared<Options>();
    command.option("NAME", options->name, "Of the table's file; .yaml is added").required().check(why_no_name).offer(Offer::Kind::files);
    std::vector<std::string> keys;
    for (const Starter& starter : starters()) keys.emplace_back(starter.key);
    command.option("--from", options->from, fmt::format("Which to begin with: {}", fmt::join(keys, ", "))).show_default().offer(keys);
    command.callback([options, &exit] {
        make_table(*options);
        exit = ExitCode::fine;
    });
}

}  // namespace pinfield::cli
