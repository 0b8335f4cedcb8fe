// pinfield completion SHELL: a script that completes commands, options, files and words in a shell.

#include "engine/cli/command.h"
#include "engine/cli/completion.h"
#include "engine/cli/output.h"

namespace pinfield::cli {

void add_completion(const Command& app, ExitCode& exit) {
    const Command command = app.subcommand("completion", "Print a script for a shell that completes commands: source <(pinfield completion bash)");
    const auto shell = std::make_shared<std::string>();
    command.option("SHELL", *shell, "bash").required().one_of({"bash"});
    command.callback([app, shell, &exit] {  // shell: kept for the parser to write to
        print(bash_completion(app.form()));
        exit = ExitCode::fine;
    });
}

}  // namespace pinfield::cli
