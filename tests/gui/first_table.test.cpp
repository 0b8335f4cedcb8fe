// The table of docs/first-table.md, made in the real window with mouse and keys alone.
#include <catch2/catch.hpp>
#include <string>

#include "tests/gui/real_editor.h"

using namespace pinfield::test;

TEST_CASE("a first table is made from New to saved and played by mouse and keys alone, as docs/first-table.md tells") {
    const fs::path docs = fs::path(source_dir()) / "docs/first-table";
    const Workplace place;
    fs::copy(docs / "steps.yaml", place.in("steps.yaml"));
    const std::string steps = read(place.in("steps.yaml"));
    for (const char* other : {"{set:", "{insert:", "{action:", "{select:", "{paste:"}) CHECK(steps.find(other) == std::string::npos);
    const auto succeeds = [&](const std::string& command) {
        const Outcome outcome = run_command(place, command);
        INFO(outcome.said);
        CHECK(outcome.code == 0);
    };
    succeeds(bin_dir() + "/pinfield-editor --script steps.yaml --size 1280x800");
    CHECK(read(place.in("my_table.yaml")) == read(docs / "my_table.yaml"));
    succeeds(bin_dir() + "/pinfield check my_table.yaml");
    succeeds(bin_dir() + "/pinfield test my_table.yaml");
    int pictures = 0;
    for (const auto& entry : fs::directory_iterator(docs))
        if (entry.path().extension() == ".png") pictures += fs::exists(place.in(entry.path().filename()));
    CHECK(pictures >= 6);
}
