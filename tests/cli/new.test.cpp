#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/io/starters.h"
#include "tests/cli/run.h"

using namespace pinfield::cli_test;
using nlohmann::json;
namespace fs = std::filesystem;

TEST_CASE("every starter becomes a table that is read without a word, passes its tests, and is played without an escape") {
    for (const pinfield::Starter& starter : pinfield::starters()) {
        const Scratch scratch;
        const std::string table = scratch / "deep_garden.yaml";
        const Outcome made = run_pinfield("new " + (scratch / "deep_garden") + " --from " + std::string(starter.key));
        INFO(starter.key << made.err);
        CHECK(made.exit == 0);
        CHECK(made.err.empty());
        const std::string text = slurp(table);
        CHECK_THAT(text, Catch::StartsWith("# yaml-language-server: $schema=table.schema.json\n") && Catch::Contains("name: Deep garden,"));
        CHECK(slurp(scratch / "table.schema.json") == run_pinfield("schema").out);
        const Outcome checked = run_pinfield("check " + table);
        CHECK(checked.exit == 0);
        CHECK(checked.out.empty());
        const Outcome tested = run_pinfield("test " + table);
        INFO(tested.out);
        CHECK(tested.exit == 0);
        CHECK((starter.key == "blank") == (tested.out == "0 passed, 0 failed\n"));
        const json played = json::parse(run_pinfield("simulate " + table + " --seconds 20 --demo --audit --json").out);
        CHECK(played["escaped"] == 0);
        CHECK(played["events"]["hit"] > 0);
    }
}

TEST_CASE("a new table takes no file's place") {
    const Scratch scratch;
    const std::string table = scratch.write("mine.yaml", "all my work\n");
    for (const std::string& name : {table, scratch / "mine"}) {
        const Outcome refused = run_pinfield("new " + name);
        CHECK(refused.exit == 3);
        CHECK_THAT(refused.err, Catch::Contains("mine.yaml exists already"));
    }
    CHECK(slurp(table) == "all my work\n");
    CHECK_FALSE(fs::exists(scratch / "table.schema.json"));
    CHECK(run_pinfield("new " + (scratch / "no_such_folder/mine")).exit == 3);
}

TEST_CASE("a schema beside the new table or in the folder above is the one it names, and stays as it is") {
    const Scratch scratch;
    const std::string schema = run_pinfield("schema").out;
    scratch.write("table.schema.json", schema);
    fs::create_directory(scratch / "tables");
    const Outcome made = run_pinfield("new " + (scratch / "tables/one.yml"));
    CHECK(made.err.empty());
    CHECK_THAT(slurp(scratch / "tables/one.yml"), Catch::StartsWith("# yaml-language-server: $schema=../table.schema.json\n"));
    CHECK_FALSE(fs::exists(scratch / "tables/table.schema.json"));
    scratch.write("tables/table.schema.json", "{}\n");
    const Outcome other = run_pinfield("new " + (scratch / "tables/two"));
    CHECK(other.exit == 0);
    CHECK_THAT(other.err, Catch::Contains("is not this version's schema"));
    CHECK_THAT(slurp(scratch / "tables/two.yaml"), Catch::StartsWith("# yaml-language-server: $schema=table.schema.json\n"));
    CHECK(slurp(scratch / "tables/table.schema.json") == "{}\n");
}

TEST_CASE("whatever a file is called, its table reads") {
    for (const char* name : {"a", "two words", "#1", "- x", "it's", "\"quoted\"", "null", "a: b", "{x", "*", "&", "naïve ☃", "\xff", "1e3", "tab\there", "x\ny"}) {
        const Scratch scratch;
        std::string quoted = "'";
        for (const char c : scratch / name) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
        quoted += "'";
        const Outcome made = run_pinfield("new " + quoted);
        INFO(name << made.err);
        CHECK(made.exit == 0);
        const Outcome checked = run_pinfield("check " + quoted.substr(0, quoted.size() - 1) + ".yaml'");
        INFO(checked.out);
        CHECK(checked.exit == 0);
    }
}

TEST_CASE("an unknown starter is asked back, with all there are") {
    const Outcome refused = run_pinfield("new x --from clasic");
    CHECK(refused.exit == 2);
    CHECK_THAT(refused.err, Catch::Contains("there is no starter \"clasic\"; did you mean classic?"));
    for (const pinfield::Starter& starter : pinfield::starters())
        CHECK_THAT(refused.err, Catch::Contains("  " + std::string(starter.key) + " ") && Catch::Contains(std::string(starter.doc)));
    CHECK_FALSE(fs::exists(fs::path(pinfield::test::source_dir()) / "x.yaml"));
}
