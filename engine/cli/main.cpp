// `pinfield`: the headless command. Each subcommand is one file, command_<name>.cpp.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "engine/cli/command.h"
#include "engine/cli/output.h"
#include "engine/core/shown.h"

namespace {

using pinfield::cli::Command;
using pinfield::cli::ExitCode;

void add_commands(const Command& app, ExitCode& exit) {
    using namespace pinfield::cli;
    add_check(app, exit);
    add_explain(app, exit);
    add_new(app, exit);
    add_nodes(app, exit);
    add_schema(app, exit);
    add_eval(app, exit);
    add_simulate(app, exit);
    add_render(app, exit);
    add_format(app, exit);
    add_expand(app, exit);
    add_test(app, exit);
    add_upgrade(app, exit);
    add_bench(app, exit);
    add_completion(app, exit);
}

/// Help and version are answers (stdout, 0); every other complaint of the parser is a wrong command line.
ExitCode answer(const CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
        std::string text;
        if (dynamic_cast<const CLI::CallForHelp*>(&error) || dynamic_cast<const CLI::CallForAllHelp*>(&error))
            text = app.help();
        else
            text = std::string(error.what()) + "\n";
        pinfield::cli::print(text);
        return ExitCode::fine;
    }
    pinfield::cli::tell(fmt::format("pinfield: {}\nRun `pinfield --help`, or `pinfield COMMAND --help`.\n", pinfield::shown(error.what())));
    return ExitCode::usage;
}

ExitCode run(int argc, char** argv) {
    CLI::App app("Pinfield: pinball tables of signed distance fields, without a window.", "pinfield");
    app.set_version_flag("--version", "pinfield " PINFIELD_VERSION);
    app.require_subcommand(1);
    app.footer("Exit codes: 0 fine, 1 the table is wrong or a test failed, 2 wrong usage, 3 a file or device failed.");
    ExitCode exit = ExitCode::fine;
    add_commands(Command(&app), exit);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return answer(app, error);
    }
    return exit;
}

}  // namespace

int main(int argc, char** argv) {
    pinfield::hold_standard_streams();
    try {
        return static_cast<int>(run(argc, argv));
    } catch (const pinfield::cli::Stop& stop) {
        pinfield::cli::tell(stop.findings);
        if (!stop.message.empty()) pinfield::cli::tell(fmt::format("pinfield: {}\n", pinfield::shown(stop.message)));
        return static_cast<int>(stop.code);
    } catch (const std::exception& error) {
        pinfield::cli::tell(fmt::format("pinfield: {}\n", pinfield::shown(error.what())));
        return static_cast<int>(ExitCode::failed);
    }
}
