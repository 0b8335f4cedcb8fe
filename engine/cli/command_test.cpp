// pinfield test FILE: runs the `tests:` of a table.
#include <fmt/format.h>

#include "engine/cli/command.h"
#include "engine/cli/json.h"
#include "engine/cli/output.h"
#include "engine/cli/table.h"
#include "engine/core/shown.h"
#include "engine/game/table_test.h"

namespace pinfield::cli {
namespace {

struct Options {
    std::string file;
    bool json = false;
};

struct Verdict {
    std::string name;
    std::vector<std::string> failures;  ///< each expectation that did not hold, with what was there instead
};

Verdict judge(const Table& table, const TableTest& test, std::size_t index) {
    Verdict verdict{test.name.empty() ? fmt::format("test {}", index + 1) : test.name, {}};
    for (const TestFailure& failure : run_table_test(table.program, table.scene, test)) {
        const LineColumn place = table.scene.sources.line_column(failure.where);
        verdict.failures.push_back(
            fmt::format("{}:{}:{}: {}", table.scene.sources.main().name(), place.line, place.column, failure.message));
    }
    return verdict;
}

std::string text_of(const std::vector<Verdict>& verdicts, int failed) {
    std::string text;
    for (const Verdict& verdict : verdicts) {
        text += fmt::format("{} {}\n", verdict.failures.empty() ? "pass" : "FAIL", shown(verdict.name));
        for (const std::string& failure : verdict.failures) text += fmt::format("     {}\n", shown(failure));
    }
    return text + fmt::format("{} passed, {} failed\n", static_cast<int>(verdicts.size()) - failed, failed);
}

std::string json_of(const std::vector<Verdict>& verdicts, int failed) {
    std::vector<std::string> tests;
    for (const Verdict& verdict : verdicts) {
        std::vector<std::string> failures;
        for (const std::string& failure : verdict.failures) failures.push_back(json_text(failure));
        tests.push_back(JsonObject()
                            .add("name", verdict.name)
                            .add("passed", verdict.failures.empty())
                            .add_raw("failures", json_array(failures))
                            .text());
    }
    return JsonObject()
               .add("passed", static_cast<int>(verdicts.size()) - failed)
               .add("failed", failed)
               .add_raw("tests", json_array(tests))
               .text() +
           "\n";
}

ExitCode test(const Options& options) {
    const Table table = open_table(options.file);
    std::vector<Verdict> verdicts;
    int failed = 0;
    for (std::size_t i = 0; i < table.scene.tests.size(); ++i) {
        verdicts.push_back(judge(table, table.scene.tests[i], i));
        if (!verdicts.back().failures.empty()) ++failed;
    }
    print(options.json ? json_of(verdicts, failed) : text_of(verdicts, failed));
    return failed == 0 ? ExitCode::fine : ExitCode::wrong;
}

}  // namespace

void add_test(const Command& app, ExitCode& exit) {
    const Command command = app.subcommand("test", "Run a table's own tests");
    const auto options = std::make_shared<Options>();
    command.option("FILE", options->file, "Table file").required().offer(Offer::Kind::tables);
    command.flag("--json", options->json, "Print the results as JSON");
    command.callback([options, &exit] { exit = test(*options); });
}

}  // namespace pinfield::cli
