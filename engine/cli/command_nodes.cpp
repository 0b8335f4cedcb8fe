// pinfield nodes [KEY]: every node with its fields, units, ranges, defaults and exactness.
#include <fmt/format.h>

#include "engine/cli/command.h"
#include "engine/cli/output.h"
#include "engine/io/node_reference.h"
#include "engine/scene/catalog.h"

namespace pinfield::cli {
namespace {

struct Options {
    std::string key;
    bool json = false, markdown = false;
};

void nodes(const Options& options) {
    const Catalog catalog = built_in_catalog();
    const std::vector<const NodeType*> types = referenced_types(catalog, options.key);
    if (types.empty()) throw Stop{ExitCode::usage, fmt::format("there is no node \"{}\"; `pinfield nodes` lists all", options.key)};
    std::string text = options.json ? reference_json(types) : options.markdown ? reference_markdown(types) : reference_text(types);
    if (!text.ends_with('\n')) text += '\n';
    print(text);
}

}  // namespace

void add_nodes(const Command& app, ExitCode& exit) {
    const Command command = app.subcommand("nodes", "List every node with its fields, units, ranges, defaults and exactness");
    const auto options = std::make_shared<Options>();
    command.option("KEY", options->key, "Only this node");
    const Option json = command.flag("--json", options->json, "As JSON");
    command.flag("--markdown", options->markdown, "As Markdown").excludes(json);
    command.callback([options, &exit] {
        nodes(*options);
        exit = ExitCode::fine;
    });
}

}  // namespace pinfield::cli
