// pinfield check FILE...: what is wrong with tables, and where.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "engine/cli/command.h"
#include "engine/cli/json.h"
#include "engine/cli/output.h"
#include "engine/cli/table.h"
#include "engine/program/compile.h"
#include "engine/scene/catalog.h"

namespace pinfield::cli {
namespace {

struct Options {
    std::vector<std::string> files;
    bool json = false;
};

JsonObject json_of(const Diagnostic& diagnostic, const SourceText& source) {
    const LineColumn place = source.place(diagnostic.where.begin);
    return JsonObject()
        .add("file", source.name())
        .add("line", place.line)
        .add("column", place.column)
        .add("severity", diagnostic.severity == Severity::error ? "error" : "warning")
        .add("code", diagnostic.code)
        .add("message", diagnostic.message)
        .add("hint", diagnostic.hint);
}

/// Findings of the reader and, when it is content, of the compiler.
Diagnostics findings(const LoadedTable& loaded) {
    Diagnostics all = loaded.diagnostics;
    if (!loaded.ok()) return all;
    if (const auto program = compile(loaded.scene); !program) all.insert(all.end(), program.error().begin(), program.error().end());
    return all;
}

Exit check(const Options& options) {
    const auto catalogue = std::make_shared<const Catalogue>(built_in_catalogue());
    Exit exit = Exit::fine;
    std::vector<std::string> objects;
    for (const std::string& file : options.files) {
        const Result<LoadedTable> loaded = load_table(file, catalogue);
        if (!loaded) {
            fmt::print(stderr, "pinfield: {}\n", loaded.error().message);
            exit = Exit::failed;
            continue;
        }
        const Diagnostics all = findings(*loaded);
        if (has_errors(all) && exit == Exit::fine) exit = Exit::wrong;
        if (!options.json) print(text_of(all, *loaded->source));
        for (const Diagnostic& diagnostic : all) objects.push_back(json_of(diagnostic, *loaded->source).text());
    }
    if (options.json) print(json_array(objects) + "\n");
    return exit;
}

}  // namespace

void add_check(CLI::App& app, Exit& exit) {
    CLI::App* command = app.add_subcommand("check", "Tell all that is wrong with tables, with file, line and column");
    const auto options = std::make_shared<Options>();
    command->add_option("FILE", options->files, "Table files")->required();
    command->add_flag("--json", options->json, "Print an array of findings");
    command->callback([options, &exit] { exit = check(*options); });
}

}  // namespace pinfield::cli
