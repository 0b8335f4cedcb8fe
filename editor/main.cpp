// pinfield-editor: opens a table, plays it, edits it. Exit codes as the headless command's: 0 fine, 1 a script's step failed or the
// table is wrong, 2 usage, 3 no file or no window, 128 + n ended by signal n.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "editor/app.h"
#include "editor/starters.h"
#include "editor/keep_preferences.h"
#include "editor/keep_work.h"
#include "editor/script.h"
#include "engine/core/shown.h"
#include "engine/io/files.h"
#include "engine/io/output_file.h"
#include "engine/io/script_reader.h"
#include "engine/scene/catalog.h"

namespace {

using namespace pinfield;
using namespace pinfield::editor;

enum ExitCode { fine = 0, wrong = 1, usage = 2, no_device = 3, by_signal = 128 };

struct Arguments {
    std::string file, script, screenshot, journals, preferences, size = "1440x900";
    int frames = -1;
    int ticks_per_frame = 0;
    std::optional<double> font_size;
};

int complain(int code, const std::string& text) {
    std::fprintf(stderr, "pinfield-editor: %s\n", shown(text).c_str());
    return code;
}

/// "1280x800" into both numbers.
bool read_size(const std::string& text, int& width, int& height) {
    int read = 0;
    return std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &read) == 2 && static_cast<std::size_t>(read) == text.size() &&
           width >= 320 && height >= 240 && width <= 8192 && height <= 8192;
}

Result<AppState> first_state(const std::string& file) {
    const auto catalog = std::make_shared<const Catalog>(built_in_catalog());
    if (file.empty()) return AppState(catalog, Document::untitled(catalog, starters().front().text));
    Result<Document> document = Document::open(file, catalog);
    if (!document) return tl::unexpected(document.error());
    return AppState(catalog, std::move(*document));
}

/// The script, ready to run; or nothing, with all its errors printed, when it is no script.
std::optional<ScriptRunner> read_steps(const std::string& path, const std::string& text) {
    SourceText source(path, text);
    Script script = read_script(source);
    for (const Diagnostic& problem : script.diagnostics) std::fprintf(stderr, "%s\n", format(problem, Sources(source)).c_str());
    if (has_errors(script.diagnostics)) return std::nullopt;
    return ScriptRunner(std::move(source), std::move(script));
}

int run_editor(const Arguments& arguments) {
    AppOptions options;
    if (!read_size(arguments.size, options.width, options.height)) return complain(usage, "--size wants WIDTHxHEIGHT, such as 1280x800");
    // A run that nobody watches goes by ticks alone, never by the clock.
    const bool scripted = !arguments.script.empty() || arguments.frames >= 0;
    options.ticks_per_frame = arguments.ticks_per_frame > 0 ? arguments.ticks_per_frame : scripted ? 16 : 0;
    options.listen = !scripted;

    std::optional<ScriptRunner> script;
    if (!arguments.script.empty()) {
        const Result<std::string> text = read_file(arguments.script);
        if (!text) return complain(no_device, text.error().message);
        script = read_steps(arguments.script, *text);
        if (!script) return wrong;
    }
    Result<AppState> state = first_state(arguments.file);
    if (!state) return complain(no_device, state.error().message);
    if (!arguments.preferences.empty()) load_preferences(*state, arguments.preferences);
    else if (!scripted) load_preferences(*state, preferences_folder());
    if (arguments.font_size) state->preferences.font_size = *arguments.font_size;
    state->preferences_file.pass_over(state->preferences);
    if (!arguments.journals.empty()) keep_work(*state, arguments.journals);
    else if (!scripted) keep_work(*state, journal_folder());
    if (!scripted && !journal_folder().empty()) state->recent = RecentFiles(journal_folder() + "/recent");
    state->recent.add(state->document.path());
    Result<std::unique_ptr<App>> app = App::open(std::move(*state), options);
    if (!app) return complain(no_device, app.error().message);

    std::string failure;
    int signal = 0;
    if (script) {
        failure = (*app)->run(std::move(*script));
    } else if (arguments.frames >= 0) {
        for (int i = 0; i < arguments.frames && !(*app)->state().quit; ++i) (*app)->frame();
    } else {
        signal = (*app)->run();
    }
    if (signal != 0) return by_signal + signal;
    if (!arguments.screenshot.empty()) {
        const Result<bool> written = (*app)->screenshot(arguments.screenshot);
        if (!written) return complain(no_device, written.error().message);
    }
    return failure.empty() ? fine : complain(wrong, failure);
}

}  // namespace

int main(int argc, char** argv) {
    hold_standard_streams();
    Arguments arguments;
    CLI::App cli{"Pinfield's editor: play a table while you change it."};
    cli.add_option("FILE", arguments.file, "Table to open; without one, a new table");
    cli.add_option("--script", arguments.script, "Steps to run (YAML); exits with 0, or 1 naming the step that failed");
    cli.add_option("--frames", arguments.frames, "Exit after so many frames")->check(CLI::NonNegativeNumber);
    cli.add_option("--screenshot", arguments.screenshot, "Write the window as a PNG before exiting");
    cli.add_option("--journals", arguments.journals,
                   "Folder in which unsaved work is kept, and found after a crash; $XDG_STATE_HOME/pinfield, or none with --script or --frames");
    cli.add_option("--size", arguments.size, "Window size, WIDTHxHEIGHT")->capture_default_str();
    cli.add_option("--ticks-per-frame", arguments.ticks_per_frame, "Ticks a frame; 0: by the clock, 16 with --script or --frames")
        ->check(CLI::Range(0, 100000));
    cli.add_option("--preferences", arguments.preferences,
                   "Folder in which preferences are kept; $XDG_CONFIG_HOME/pinfield, or none with --script or --frames");
    cli.add_option("--font-size", arguments.font_size, "Size of the text, and of everything with it; for this run, in place of the preferred one")
        ->check(CLI::Range(least_font_size, most_font_size));
    cli.set_version_flag("--version", "pinfield-editor " PINFIELD_VERSION);
    try {
        cli.parse(argc, argv);
    } catch (const CLI::Success& done) {
        return cli.exit(done);
    } catch (const CLI::ParseError& error) {
        cli.exit(error);
        return usage;
    }
    try {
        return run_editor(arguments);
    } catch (const std::exception& error) {
        return complain(no_device, error.what());
    }
}
