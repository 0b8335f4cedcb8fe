// pinfield expand FILE: a table with everything written out that its author says once and uses often, to stdout.

#include "engine/cli/command.h"
#include "engine/cli/output.h"
#include "engine/cli/table.h"
#include "engine/io/write_table.h"
#include "engine/scene/expanded.h"

namespace pinfield::cli {

void add_expand(const Command& app, ExitCode& exit) {
    const Command command = app.subcommand("expand", "Print a table in one file, without params, templates and copies: the nodes they make, as numbers");
    const auto file = std::make_shared<std::string>();
    command.option("FILE", *file, "Table file").required();
    command.callback([file, &exit] {
        print(write_table(expanded(open_table(*file).scene)));
        exit = ExitCode::fine;
    });
}

}  // namespace pinfield::cli
