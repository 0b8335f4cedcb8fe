#include "editor/recent.h"

#include <catch2/catch.hpp>

#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

TEST_CASE("what was opened or saved last comes first, once, and what is gone is left out") {
    const Folder folder;
    const RecentFiles recent(folder.file("state/recent"));
    CHECK(recent.paths().empty());
    std::vector<std::string> tables;
    for (const char* name : {"a.yaml", "b.yaml", "c.yaml"}) tables.push_back(folder.write(name, pen));
    for (const std::string& table : tables) recent.add(table);
    CHECK(recent.paths() == std::vector{tables[2], tables[1], tables[0]});
    recent.add(tables[0]);
    CHECK(recent.paths() == std::vector{tables[0], tables[2], tables[1]});
    std::filesystem::remove(tables[2]);
    CHECK(recent.paths() == std::vector{tables[0], tables[1]});
    for (int i = 0; i < 20; ++i) recent.add(folder.write("t" + std::to_string(i), pen));
    CHECK(recent.paths().size() == 10);
    CHECK(recent.paths().front() == folder.file("t19"));
}

TEST_CASE("without a place for it, or where it cannot be written, nothing is remembered and nothing is lost") {
    const Folder folder;
    RecentFiles().add(folder.write("a.yaml", pen));
    CHECK(RecentFiles().paths().empty());
    folder.write("state", "a file, not a folder");
    const RecentFiles recent(folder.file("state/recent"));
    recent.add(folder.file("a.yaml"));
    CHECK(recent.paths().empty());
    CHECK(folder.read("state") == "a file, not a folder");
}

TEST_CASE("opening and saving a table put it first") {
    const Folder folder;
    AppState state = opened_state(folder);
    state.recent = RecentFiles(folder.file("state/recent"));
    open_file(state, folder.write("other.yaml", pen));
    CHECK(state.recent.paths() == std::vector{folder.file("other.yaml")});
    run(state, "file.save_as");
    state.dialog_path = folder.file("third.yaml");
    run(state, "dialog.accept");
    CHECK(state.recent.paths() == std::vector{folder.file("third.yaml"), folder.file("other.yaml")});
}
