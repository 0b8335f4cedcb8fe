// The real editor, window and all, driven by scripts as a user's hands would drive it. Needs a display.
#include <catch2/catch.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/gui/real_editor.h"

using namespace pinfield::test;

namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

/// Lines of `after` that differ from `before`; both must have the same number of lines.
std::vector<std::string> changed_lines(const std::string& before, const std::string& after) {
    const auto a = lines_of(before), b = lines_of(after);
    REQUIRE(a.size() == b.size());
    std::vector<std::string> changed;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i] != b[i]) changed.push_back(b[i]);
    return changed;
}

}  // namespace

TEST_CASE("the editor opens a table, runs some frames, leaves a picture and exits") {
    const Workplace place;
    const Outcome outcome = run_editor(place, "table.yaml --frames 20 --size 1280x800 --screenshot shot.png");
    INFO(outcome.said);
    REQUIRE(outcome.code == 0);
    const std::string png = read(place.in("shot.png"));
    CHECK(png.substr(1, 3) == "PNG");
    CHECK(png.size() > 20'000);
    CHECK(read(place.table()) == read(fs::path(source_dir()) / "scenes/tables/first_table.yaml"));
}

TEST_CASE("dragging a bumper with the mouse while balls roll, then saving, changes one line of the file") {
    const Workplace place;
    const std::string before = read(place.table());
    const Outcome outcome = run_script(place, R"(
- {key: {press: Space, ticks: 700}}
- {wait: {ticks: 400}}
- {drag: {from: [0.300, 0.800], to: [0.312, 0.810], with: [LeftControl]}}
- {expect: {node: pop_top, field: at, value: [312mm, 810mm], tolerance: 0.6mm}}
- {wait: {ticks: 100}}
- {action: file.save}
- {screenshot: after.png}
)");
    INFO(outcome.said);
    REQUIRE(outcome.code == 0);
    const auto changed = changed_lines(before, read(place.table()));
    REQUIRE(changed.size() == 1);
    CHECK(changed[0].find("pop_top") != std::string::npos);
    CHECK(fs::exists(place.in("after.png")));
}

TEST_CASE("a drag that is undone leaves nothing to save") {
    const Workplace place;
    const std::string before = read(place.table());
    const Outcome outcome = run_script(place, R"(
- {drag: {from: [0.300, 0.800], to: [0.320, 0.790]}}
- {action: edit.undo}
- {expect: {node: pop_top, field: at, value: [300mm, 800mm], tolerance: 0.001mm}}
- {action: edit.redo}
- {action: edit.undo}
)");
    INFO(outcome.said);
    REQUIRE(outcome.code == 0);
    CHECK(read(place.table()) == before);
}

TEST_CASE("the same script leaves the same picture, whatever the clock says") {
    const Workplace place;
    const std::string steps =
        "- {key: {press: Space, ticks: 700}}\n- {wait: {ticks: 1500}}\n- {action: view.isolines}\n- {screenshot: a.png}\n";
    REQUIRE(run_script(place, steps).code == 0);
    const std::string first = read(place.in("a.png"));
    fs::remove(place.in("a.png"));
    REQUIRE(run_script(place, steps).code == 0);
    CHECK(first == read(place.in("a.png")));
}

TEST_CASE("a script's failing step is named and the exit code is 1") {
    const Workplace place;
    const Outcome outcome = run_script(place, "- {wait: {ticks: 10}}\n- {expect: {node: pop_top, field: radius, value: 99mm}}\n");
    INFO(outcome.said);
    CHECK(outcome.code == 1);
    CHECK(outcome.said.find("radius") != std::string::npos);
}

TEST_CASE("wrong command lines are 2 and files that are not there are 3") {
    const Workplace place;
    CHECK(run_editor(place, "--no-such-flag").code == 2);
    CHECK(run_editor(place, "table.yaml --frames 1 --size big").code == 2);
    CHECK(run_editor(place, "nowhere.yaml --frames 1").code == 3);
    CHECK(run_editor(place, "--version").code == 0);
    CHECK(run_editor(place, "--help").code == 0);
}

TEST_CASE("an editor that is killed in the middle of its work offers it at the next start; Enter restores it, and it can be saved") {
    const Workplace place;
    const std::string before = read(place.table());
    write(place.in("edit.yaml"), R"(
- {drag: {from: [0.300, 0.800], to: [0.312, 0.810], with: [LeftControl]}}
- {wait: {ticks: 16}}
- {screenshot: edited.png}
- {wait: {ticks: 10000000}}
)");
    const std::string kill_when_edited = " & until [ -e edited.png ] || ! kill -0 $! 2>/dev/null; do sleep 0.1; done; kill -KILL $!; wait $!";
    const Outcome killed = run_editor(place, "table.yaml --script edit.yaml --journals journals --size 1280x800", kill_when_edited);
    INFO(killed.said);
    REQUIRE(killed.code == 128 + 9);
    CHECK(read(place.table()) == before);
    REQUIRE_FALSE(fs::is_empty(place.in("journals")));

    write(place.in("steps.yaml"), R"(
- {screenshot: offer.png}
- {key: {press: Enter, ticks: 20}}
- {expect: {node: pop_top, field: at, value: [312mm, 810mm], tolerance: 0.6mm}}
- {action: file.save}
- {wait: {ticks: 16}}
)");
    const Outcome restored = run_editor(place, "table.yaml --script steps.yaml --journals journals --size 1280x800");
    INFO(restored.said);
    REQUIRE(restored.code == 0);
    CHECK(changed_lines(before, read(place.table())).size() == 1);
    CHECK(fs::is_empty(place.in("journals")));
}
