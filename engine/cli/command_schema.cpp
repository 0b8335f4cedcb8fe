// pinfield schema: JSON Schema of the table format, for editors that complete and check YAML.

#include "engine/cli/command.h"
#include "engine/cli/output.h"
#include "engine/io/json_schema.h"
#include "engine/scene/catalog.h"

namespace pinfield::cli {

void add_schema(const Command& app, ExitCode& exit) {
    const Command command = app.subcommand("schema", "Print the JSON Schema (draft-07) of the table format");
    command.callback([&exit] {
        std::string text = json_schema(built_in_catalog());
        if (!text.ends_with('\n')) text += '\n';
        print(text);
        exit = ExitCode::fine;
    });
}

}  // namespace pinfield::cli
