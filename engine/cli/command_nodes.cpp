// pinfield nodes [KEY]: every node with its fields, units, ranges, defaults and exactness.
#include <fmt/format.h>

#include "engine/cli/command.h"
#include "engine/cli/output.h"
#include "engine/io/node_reference.h"
#include "engine/physics/event.h"
#include "engine/scene/catalog.h"

namespace pinfield::cli {
namespace {

struct Options {
    std::string key;
    bool json = false, markdown = false;
};

std::string events_text() {
    std::string out = "\nEvents, as `simulate --events` writes them (speed in m/s):\n";
    for (int kind = 0; kind < event_kinds; ++kind)
        out += fmt::format("    {:<12} {}\n", name(static_cast<EventKind>(kind)), meaning(static_cast<EventKind>(kind)));
    return out;
}

std::string events_markdown() {
    std::string out = "\n## Events\n\nAs `simulate --events` writes them; speeds are in m/s.\n\n| event | means |\n|---|---|\n";
    for (int kind = 0; kind < event_kinds; ++kind)
        out += fmt::format("| `{}` | {} |\n", name(static_cast<EventKind>(kind)), meaning(static_cast<EventKind>(kind)));
    return out;
}

std::vector<std::string> node_keys() {
    const Catalog catalog = built_in_catalog();
    std::vector<std::string> keys;
    for (const NodeType* type : referenced_types(catalog)) keys.emplace_back(type->key());
    return keys;
}

void nodes(const Options& options) {
    const Catalog catalog = built_in_catalog();
    const std::vector<const NodeType*> types = referenced_types(catalog, options.key);
    if (types.empty()) throw Stop{ExitCode::usage, fmt::format("there is no node \"{}\"; `pinfield nodes` lists all", options.key), ""};
    std::string text = options.json ? reference_json(types) : options.markdown ? reference_markdown(types) : reference_text(types);
    if (options.key.empty() && !options.json)
        text += options.markdown ? fmt::format("\n{}{}", units_markdown(), events_markdown()) : fmt::format("\n{}{}", units_text(), events_text());
    if (!text.ends_with('\n')) text += '\n';
    print(text);
}

}  // namespace

void add_nodes(const Command& app, ExitCode& exit) {
    const Command command = app.subcommand("nodes", "List every node with its fields, units, ranges, defaults and exactness");
    const auto options = std::make_shared<Options>();
    command.option("KEY", options->key, "Only this node").offer(node_keys());
    const Option json = command.flag("--json", options->json, "As JSON");
    command.flag("--markdown", options->markdown, "As Markdown").excludes(json);
    command.callback([options, &exit] {
        nodes(*options);
        exit = ExitCode::fine;
    });
}

}  // namespace pinfield::cli
