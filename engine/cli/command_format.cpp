// pinfield format FILE: the canonical form of a table, to stdout; the file itself is never written.

#include "engine/cli/command.h"
#include "engine/cli/output.h"
#include "engine/cli/table.h"
#include "engine/io/write_table.h"

namespace pinfield::cli {

void add_format(const Command& app, ExitCode& exit) {
    const Command command = app.subcommand("format", "Print a table in its canonical form");
    const auto file = std::make_shared<std::string>();
    command.option("FILE", *file, "Table file").required().offer(Offer::Kind::tables);
    command.callback([file, &exit] {
        print(write_table(open_table(*file).scene));
        exit = ExitCode::fine;
    });
}

}  // namespace pinfield::cli
