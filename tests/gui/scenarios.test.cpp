// Scenarios: one thing each that an author does in the real window, with mouse and keys. A script in scenarios/<family>/<name>.yaml works
// on the family's table.yaml, else on scenarios/workshop.yaml, and saves; what the file is then differs from what it was by just the lines
// of <name>.diff. No .diff: by none.
// PINFIELD_SCENARIOS=<folder> keeps the pictures and the differences found there, to be looked at.
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "tests/gui/real_editor.h"

using namespace pinfield::test;

namespace {

fs::path scenarios() { return fs::path(source_dir()) / "tests/gui/scenarios"; }

std::vector<fs::path> scripts_of(const std::string& family) {
    std::vector<fs::path> scripts;
    for (const auto& entry : fs::directory_iterator(scenarios() / family))
        if (entry.path().extension() == ".yaml" && entry.path().filename() != "table.yaml") scripts.push_back(entry.path());
    std::sort(scripts.begin(), scripts.end());
    return scripts;
}

fs::path table_of(const std::string& family) {
    const fs::path own = scenarios() / family / "table.yaml";
    return fs::exists(own) ? own : scenarios() / "workshop.yaml";
}

/// Lines that went ("-...") and came ("+...").
std::string difference(const Workplace& place, const fs::path& table) {
    run_command(place, "diff --unchanged-line-format= --old-line-format='-%L' --new-line-format='+%L' '" +
                           table.string() + "' table.yaml > found.diff; true");
    return read(place.in("found.diff"));
}

void keep(const Workplace& place, const std::string& family, const std::string& name) {
    const char* const where = std::getenv("PINFIELD_SCENARIOS");
    if (!where) return;
    const fs::path folder = fs::path(where) / family;
    fs::create_directories(folder);
    for (const auto& entry : fs::directory_iterator(place.folder)) {
        const std::string file = entry.path().filename().string();
        if (entry.path().extension() != ".png" && file != "found.diff") continue;
        const std::string kept = file == "end.png" ? name + ".png" : file == "found.diff" ? name + ".diff" : name + "." + file;
        fs::copy_file(entry.path(), folder / kept, fs::copy_options::overwrite_existing);
    }
}

/// The table holds while it is worked on; at the end there is a picture, and Ctrl+S.
std::string whole_script(const fs::path& script) {
    return "- {key: {press: F6}}\n" + read(script) +
           "\n- {wait: {ticks: 16}}\n- {screenshot: end.png}\n- {key: {press: S, with: [LeftControl]}}\n";
}

void play(const std::string& family) {
    const std::vector<fs::path> scripts = scripts_of(family);
    REQUIRE(scripts.size() >= 3);
    for (const fs::path& script : scripts) {
        const Workplace place(table_of(family));
        const Outcome outcome = run_script(place, whole_script(script));
        const std::string found = difference(place, table_of(family));
        keep(place, family, script.stem().string());
        INFO(family << "/" << script.stem().string() << "\n" << outcome.said);
        CHECK(outcome.code == 0);
        CHECK(found == read(fs::path(script).replace_extension(".diff")));
    }
}

}  // namespace

TEST_CASE("scenarios: nodes are selected by clicks, boxes, keys and rows") { play("selecting"); }
TEST_CASE("scenarios: nodes are moved, turned, scaled and lined up by hand") { play("moving"); }
TEST_CASE("scenarios: a node's own handles change its numbers and points") { play("handles"); }
TEST_CASE("scenarios: nodes are added, wrapped, unwrapped, copied and put elsewhere") { play("structure"); }
TEST_CASE("scenarios: nodes are cut, copied and pasted as text") { play("clipboard"); }
TEST_CASE("scenarios: values are typed, chosen and taken back in the inspector") { play("inspector"); }
TEST_CASE("scenarios: rows of the tree are renamed, found and dragged") { play("tree"); }
TEST_CASE("scenarios: what is said once is changed where it comes from") { play("reuse"); }
TEST_CASE("scenarios: the text itself is edited") { play("source"); }
TEST_CASE("scenarios: a picture is laid under the table and brought to size") { play("underlay"); }
TEST_CASE("scenarios: steps are undone, redone and gone to, and commands found") { play("history"); }
