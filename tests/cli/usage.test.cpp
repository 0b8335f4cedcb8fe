#include <catch2/catch.hpp>

#include "tests/cli/run.h"

using namespace pinfield::cli_test;

namespace {
const std::vector<std::string> commands{"check", "explain", "new", "nodes", "schema", "eval", "simulate", "render", "format", "test", "upgrade", "bench", "completion"};
}

TEST_CASE("help and version are answers") {
    const Outcome help = run_pinfield("--help");
    CHECK(help.exit == 0);
    CHECK(help.err.empty());
    for (const std::string& command : commands) {
        CHECK_THAT(help.out, Catch::Contains("\n  " + command));
        const Outcome own = run_pinfield(command + " --help");
        INFO(command);
        CHECK(own.exit == 0);
        CHECK(own.err.empty());
        CHECK_THAT(own.out, Catch::Contains("pinfield " + command));
    }
    const Outcome version = run_pinfield("--version");
    CHECK(version.exit == 0);
    CHECK_THAT(version.out, Catch::StartsWith("pinfield ") && Catch::EndsWith("\n"));
}

TEST_CASE("a wrong command line is exit 2, with words on stderr and nothing on stdout") {
    for (const char* arguments : {"",
                                  "fly",
                                  "--fly",
                                  "check",
                                  "check --fly a.yaml",
                                  "eval scenes/tables/first_table.yaml",
                                  "render scenes/tables/first_table.yaml",
                                  "render scenes/tables/first_table.yaml -o x.png --size 10",
                                  "render scenes/tables/first_table.yaml -o x.png --size 0x5",
                                  "render scenes/tables/first_table.yaml -o x.png --size 100000x100000",
                                  "render scenes/tables/first_table.yaml -o x.png --mode pretty",
                                  "simulate",
                                  "simulate scenes/tables/first_table.yaml --seconds -1",
                                  "simulate scenes/tables/first_table.yaml --seconds nan",
                                  "simulate scenes/tables/first_table.yaml --seconds 1e300",
                                  "simulate scenes/tables/first_table.yaml --seconds much",
                                  "simulate scenes/tables/first_table.yaml --launch 1,2,3",
                                  "simulate scenes/tables/first_table.yaml --launch 1,2,3,x",
                                  "simulate scenes/tables/first_table.yaml --restitution 2",
                                  "simulate scenes/tables/first_table.yaml --integrator magic",
                                  "simulate scenes/tables/first_table.yaml --step 0",
                                  "simulate scenes/tables/first_table.yaml --balls -3",
                                  "simulate scenes/tables/first_table.yaml --seed -1",
                                  "simulate scenes/tables/first_table.yaml --seed 18446744073709551616",
                                  "nodes no_such_node",
                                  "explain E9999",
                                  "new",
                                  "upgrade",
                                  "completion",
                                  "completion fish",
                                  "new \"\"",
                                  "new /tmp/",
                                  "new x --from no_such_starter",
                                  "nodes --json --markdown"}) {
        INFO(arguments);
        const Outcome outcome = run_pinfield(arguments);
        CHECK(outcome.exit == 2);
        CHECK(outcome.out.empty());
        CHECK_FALSE(outcome.err.empty());
    }
}

TEST_CASE("a file that cannot be read is exit 3 and is named") {
    const Scratch scratch;
    for (const std::string& arguments :
         std::vector<std::string>{"check no/such.yaml", "eval no/such.yaml --points p.csv", "eval " + first_table + " --points no/such.csv",
                                  "simulate no/such.yaml", "simulate " + first_table + " --inputs no/such.csv",
                                  "render no/such.yaml -o x.png", "format no/such.yaml", "test no/such.yaml", "upgrade no/such.yaml", "check scenes"}) {
        INFO(arguments);
        const Outcome outcome = run_pinfield(arguments);
        CHECK(outcome.exit == 3);
        CHECK(outcome.out.empty());
        CHECK_THAT(outcome.err, Catch::Contains("no/such") || Catch::Contains("scenes"));
    }
}

TEST_CASE("what cannot be written is exit 3, a full disk included") {
    const Scratch scratch;
    const std::string points = scratch.write("p.csv", "x,y\n0.2,0.3\n");
    for (const std::string& arguments :
         std::vector<std::string>{"render " + first_table + " --size 50x100 -o ", "eval " + first_table + " --points " + points + " -o ",
                                  "simulate " + first_table + " --seconds 0.05 --trace ",
                                  "simulate " + first_table + " --seconds 2 --launch 0.2,0.5,0,0 --events "}) {
        for (const char* target : {"/dev/full", "no/such/folder/x"}) {
            INFO(arguments << target);
            const Outcome outcome = run_pinfield(arguments + target);
            CHECK(outcome.exit == 3);
            CHECK_THAT(outcome.err, Catch::Contains(target));
        }
    }
    for (const std::string& arguments :
         std::vector<std::string>{"--help", "--version", "nodes", "nodes --json", "explain", "completion bash", "schema", "format " + first_table, "test " + first_table,
                                  "eval " + first_table + " --points " + points, "simulate " + first_table + " --seconds 0.01",
                                  "check scenes/invalid/unknown_key.yaml"}) {
        INFO(arguments);
        CHECK(run_pinfield(arguments, "/dev/full").exit == 3);
    }
}

TEST_CASE("a wrong table is exit 1 for every command that needs one, with its diagnostics on stderr") {
    const Scratch scratch;
    const std::string wrong = scratch.write("wrong.yaml", "pinfield: 1\nscene:\n  - circle: {radius: -1}\n");
    const std::string points = scratch.write("p.csv", "x,y\n0.2,0.3\n");
    for (const std::string& arguments :
         std::vector<std::string>{"eval " + wrong + " --points " + points, "simulate " + wrong,
                                  "render " + wrong + " -o " + (scratch / "x.png"), "format " + wrong, "test " + wrong}) {
        INFO(arguments);
        const Outcome outcome = run_pinfield(arguments);
        CHECK(outcome.exit == 1);
        CHECK(outcome.out.empty());
        CHECK_THAT(outcome.err, Catch::Contains("wrong.yaml:3:") && Catch::Contains("error: ") && Catch::Contains("[E"));
    }
}
