// pinfield check FILE...: what is wrong with tables, and where; with --verbose also what the distance of each node may be trusted for.
#include <fmt/format.h>

#include "engine/cli/command.h"
#include "engine/cli/json.h"
#include "engine/cli/output.h"
#include "engine/cli/table.h"
#include "engine/core/shown.h"
#include "engine/game/pockets.h"
#include "engine/game/starts.h"
#include "engine/program/compile.h"
#include "engine/program/distance_quality.h"
#include "engine/scene/catalog.h"

namespace pinfield::cli {
namespace {

struct Options {
    std::vector<std::string> files;
    bool json = false, verbose = false, pockets = false;
};

JsonObject json_of(const Place& where, const Sources& sources) {
    const LineColumn place = sources.line_column(where);
    const SourceText* source = sources.find(where);
    return JsonObject().add("file", source ? source->name() : "").add("line", place.line).add("column", place.column);
}

/// The way to a finding: each file, template and copy that it is in.
std::string json_of_way(const Diagnostic& diagnostic, const Sources& sources) {
    std::vector<std::string> steps;
    for (const Via& step : way_to(diagnostic, sources)) steps.push_back(json_of(step.where, sources).add("in", step.what).add("how", step.how).text());
    return json_array(steps);
}

JsonObject json_of(const Diagnostic& diagnostic, const char* severity, const Sources& sources) {
    return json_of(diagnostic.where, sources)
        .add("severity", severity)
        .add("code", diagnostic.code)
        .add("message", diagnostic.message)
        .add("hint", diagnostic.hint)
        .add_raw("way", json_of_way(diagnostic, sources));
}

/// What is known of a node's distance.
struct Note {
    Place where;
    std::string node;
    int depth = 0;  ///< 0: stands in the scene; else how deep in its tree
    DistanceQuality quality;
};

std::vector<Note> notes_of(const Program& program, const Scene& scene) {
    const std::map<NodeId, DistanceQuality> qualities = distance_qualities_of(program);
    const std::map<NodeId, std::string> paths = scene.paths();
    std::vector<Note> notes;
    for (const NodeId id : scene.all()) {
        const auto quality = qualities.find(id);
        if (quality == qualities.end() || id == scene.table().id) continue;
        const Node& node = *scene.find(id);
        int depth = 0;
        for (NodeId above = node.parent; above && qualities.contains(above); above = scene.find(above)->parent) ++depth;
        notes.push_back({node.key, paths.at(id), depth, quality->second});
    }
    return notes;
}

const char* word(Side side) { return side == Side::exact ? "exact" : "bound"; }

std::string message_of(const Note& note) {
    const Exactness& formula = note.quality.formula;
    return fmt::format("{} is {} outside, {} inside, L = {:.4g}{}", note.node, word(formula.outside), word(formula.inside),
                       formula.lipschitz,
                       !note.quality.boundary_known ? ""
                       : note.quality.fit_error == 0
                           ? ", its boundary is known: exact on both sides"
                           : fmt::format(", its boundary is fitted: right on both sides within {:.1g} m", note.quality.fit_error));
}

std::string lines_of(const std::vector<Note>& notes, const Sources& sources) {
    std::string text;
    for (const Note& note : notes) {
        const LineColumn at = sources.line_column(note.where);
        const SourceText* source = sources.find(note.where);
        text += fmt::format("{}:{}:{}: note: {:{}}{}\n", source ? shown(source->name()) : "", at.line, at.column, "", 2 * note.depth, shown(message_of(note)));
    }
    return text;
}

/// A finding with more to read: what a program would ask for.
JsonObject json_of(const Note& note, const Sources& sources) {
    const Exactness& formula = note.quality.formula;
    return json_of(Diagnostic{"", Severity::warning, message_of(note), note.where, ""}, "note", sources)
        .add("node", note.node)
        .add("outside", word(formula.outside))
        .add("inside", word(formula.inside))
        .add("lipschitz", formula.lipschitz)
        .add("boundary_known", note.quality.boundary_known)
        .add("boundary_fitted", note.quality.fit_error > 0)
        .add("fit_error", note.quality.fit_error);
}

/// Findings of the reader and, when it is content, of the compiler; notes on what it made.
struct Findings {
    Diagnostics diagnostics;
    std::vector<Note> notes;
};

Findings findings_of(const Reading& loaded, const Options& options) {
    Findings out{loaded.diagnostics, {}};
    if (!loaded.ok()) return out;
    const auto program = compile(loaded.scene);
    const Diagnostics more = program ? doubts_of(**program, loaded.scene) : program.error();
    out.diagnostics.insert(out.diagnostics.end(), more.begin(), more.end());
    if (program && options.pockets) {
        const Diagnostics pockets = pocket_warnings(**program, loaded.scene);
        out.diagnostics.insert(out.diagnostics.end(), pockets.begin(), pockets.end());
    }
    if (program && options.verbose) out.notes = notes_of(**program, loaded.scene);
    return out;
}

/// The code to read more about: the first error's, or else the first warning's.
void note_code(const Diagnostics& found, std::string& code) {
    for (const Diagnostic& diagnostic : found)
        if (code.empty() || (code.front() == 'W' && diagnostic.severity == Severity::error)) code = diagnostic.code;
}

ExitCode check(const Options& options) {
    const auto catalog = std::make_shared<const Catalog>(built_in_catalog());
    ExitCode exit = ExitCode::fine;
    std::vector<std::string> objects;
    std::string code;
    for (const std::string& file : options.files) {
        const Result<Reading> loaded = load_table(file, catalog);
        if (!loaded) {
            tell(fmt::format("pinfield: {}\n", shown(loaded.error().message)));
            exit = ExitCode::failed;
            continue;
        }
        const Findings found = findings_of(*loaded, options);
        if (has_errors(found.diagnostics) && exit == ExitCode::fine) exit = ExitCode::wrong;
        note_code(found.diagnostics, code);
        if (!options.json) print(text_of(found.diagnostics, loaded->scene.sources) + lines_of(found.notes, loaded->scene.sources));
        for (const Diagnostic& diagnostic : found.diagnostics) {
            const char* severity = diagnostic.severity == Severity::error ? "error" : "warning";
            objects.push_back(json_of(diagnostic, severity, loaded->scene.sources).text());
        }
        for (const Note& note : found.notes) objects.push_back(json_of(note, loaded->scene.sources).text());
    }
    if (options.json) print(json_array(objects) + "\n");
    else if (!code.empty()) print(fmt::format("`pinfield explain {}` tells more, with an example of wrong and of right.\n", code));
    return exit;
}

}  // namespace

void add_check(const Command& app, ExitCode& exit) {
    const Command command = app.subcommand("check", "Tell all that is wrong with tables, with file, line and column");
    const auto options = std::make_shared<Options>();
    command.option("FILE", options->files, "Table files").required().offer(Offer::Kind::tables);
    command.flag("--json", options->json, "Print an array of findings");
    command.flag("--verbose", options->verbose, "Tell of every node with a distance how far that may be trusted");
    command.flag("--pockets", options->pockets, "Tell where slow balls come to rest and nothing plays them");
    command.callback([options, &exit] { exit = check(*options); });
}

}  // namespace pinfield::cli
