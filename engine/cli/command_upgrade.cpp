// pinfield upgrade TABLE: makes a table of an older version of the format one of the newest.
#include <fmt/format.h>

#include "engine/cli/command.h"
#include "engine/cli/output.h"
#include "engine/cli/table.h"
#include "engine/core/error_codes.h"
#include "engine/core/shown.h"
#include "engine/io/yaml_tree.h"
#include "engine/scene/catalog.h"

namespace pinfield::cli {
namespace {

/// What keeps the version from being known: the text is no YAML map, has no version, or one that this program does not read. What else is
/// wrong with a table is for `check` to tell.
Diagnostics doubts_of_version(const Reading& table) {
    const bool is_map = table.tree && table.tree->root && table.tree->root->kind == YamlKind::map;
    Diagnostics out;
    for (const Diagnostic& found : table.diagnostics) {
        const bool is_version = found.code == entry(Code::missing_version).code || found.code == entry(Code::unknown_version).code;
        if (is_version || !is_map) out.push_back(found);
    }
    return out;
}

void upgrade(const std::string& file) {
    const Reading table = value_or_stop(load_table(file, std::make_shared<const Catalog>(built_in_catalog())));
    const Diagnostics doubts = doubts_of_version(table);
    if (!doubts.empty()) throw Stop{ExitCode::wrong, "", text_of(doubts, table.scene.sources)};
    // There is one version. What a second changes would be rewritten here, by patches of the author's text (engine/io/text_patch.h).
    print(fmt::format("{} is written for version 1 of the format, the newest: nothing is to be done\n", shown(file)));
}

}  // namespace

void add_upgrade(const Command& app, ExitCode& exit) {
    const Command command = app.subcommand("upgrade", "Make a table of an older version of the format one of the newest");
    const auto file = std::make_shared<std::string>();
    command.option("FILE", *file, "Table file").required().offer(Offer::Kind::tables);
    command.callback([file, &exit] {
        upgrade(*file);
        exit = ExitCode::fine;
    });
}

}  // namespace pinfield::cli
