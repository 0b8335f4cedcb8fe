// The edges of the command: streams that are closed or full, names from strangers, outputs over inputs, inputs without end.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/run.h"

using namespace pinfield::cli_test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// As run_pinfield(), but with redirections of one's own: what one would type after the arguments.
int exit_of(const std::string& arguments, const std::string& redirections) {
    const std::string command = std::string("cd ") + pinfield::test::source_dir() + " && " + pinfield::test::bin_dir() + "/pinfield " +
                                arguments + " " + redirections;
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// No byte that a terminal obeys, but line breaks; U+0080 to U+009F and what turns text round included.
bool is_harmless(const std::string& text) {
    for (const char c : text)
        if ((static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == 0x7f || static_cast<unsigned char>(c) == 0xff) return false;
    for (const char* bad : {"\u0085", "\u009b", "\u202e", "\u2066"})
        if (text.find(bad) != std::string::npos) return false;
    return true;
}

// A gigabyte; none under ASan, whose shadow alone reserves terabytes of addresses.
#ifdef __SANITIZE_ADDRESS__
const std::string memory_limit;
#else
const std::string memory_limit = "ulimit -v 1000000; ";
#endif

std::size_t files_in(const std::string& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

const std::string evil_yaml =
    "pinfield: 1\ntable: {name: \"evil\\e[31m\\a\\x85\\u202Ename\\nline: error: none\"}\n"
    "scene:\n  - spawn: {at: [0.3, 0.3]}\n";

}  // namespace

TEST_CASE("where stderr is closed or full, the exit code is what it would be") {
    const Scratch scratch;
    const std::string wrong = scratch.write("wrong.yaml", "pinfield: 1\nscene:\n  - circle: {radius: -1}\n");
    const std::string doubtful = scratch.write("doubtful.yaml", "pinfield: 1\nscene:\n  - circle: {at: [0.2, 0.2]}\n  - spawn: {at: [0.2, 0.2]}\n");
    for (const std::string& arguments :
         std::vector<std::string>{"check no/such.yaml", "check " + wrong, "simulate " + wrong, "simulate " + doubtful + " --seconds 0.01",
                                  "format " + wrong, "render " + wrong + " -o x.png", "eval " + first_table + " --points no/such", "nodes no_such_node",
                                  "test no/such.yaml", "fly", "simulate " + first_table + " --seconds x"}) {
        const int usual = exit_of(arguments, ">/dev/null 2>/dev/null");
        INFO(arguments << " exits " << usual);
        CHECK(usual < 4);
        CHECK(exit_of(arguments, ">/dev/null 2>&-") == usual);
        CHECK(exit_of(arguments, ">/dev/null 2>/dev/full") == usual);
    }
}

TEST_CASE("where stdout is closed or full, results are exit 3, whatever becomes of stderr, and no file takes stdout's place") {
    const Scratch scratch;
    const std::string trace = scratch / "trace.csv", usual = scratch / "usual.csv";
    const std::string simulate = "simulate " + first_table + " --seconds 0.01 --trace ";
    REQUIRE(exit_of(simulate + usual, ">/dev/null") == 0);
    for (const char* redirections : {">&- 2>/dev/null", ">/dev/full 2>/dev/null", ">&- 2>&-", ">/dev/full 2>/dev/full", "<&- >&- 2>&-"}) {
        INFO(redirections);
        for (const std::string& arguments : {std::string("--help"), "format " + first_table, simulate + trace}) CHECK(exit_of(arguments, redirections) == 3);
        CHECK(slurp(trace) == slurp(usual));
        CHECK(exit_of("render " + first_table + " --size 20x40 -o " + (scratch / "x.png"), redirections) == 0);
        CHECK(slurp(scratch / "x.png").substr(1, 3) == "PNG");
    }
}

TEST_CASE("a reader that goes away is exit 3 without a word, and kills nobody") {
    const Scratch scratch;
    const std::string out = scratch / "exit", err = scratch / "err";
    const std::string command = std::string("(") + pinfield::test::bin_dir() + "/pinfield nodes --markdown 2>" + err + "; echo $? >" + out + ") | true";
    static_cast<void>(std::system(command.c_str()));
    for (int i = 0; i < 100 && slurp(out).empty(); ++i) usleep(20'000);
    const std::string exit = slurp(out);
    CHECK((exit == "3\n" || exit == "0\n"));  // 0: all of it fitted into the pipe before the reader went
    CHECK(slurp(err).empty());
}

TEST_CASE("names, keys and paths from strangers reach no terminal raw") {
    const Scratch scratch;
    const std::string evil = scratch.write("evil\n\x1b[31m\xff\u202e\".yaml", evil_yaml + "  - circle: {radius: -1}\n  - \"cir\\e[2Jcle\": {}\n");
    const std::string fine = scratch.write("fine.yaml", evil_yaml);
    const std::string lines = scratch.write("i.csv", "tick,input,value\n1,in\x1b[31m,1\n");
    const std::string gone = scratch / "gone\n\x1b]0;title\a";
    const std::string raw = scratch.write("raw.yaml", "pinfield: 1\nscene:\n  - \"cir\u009bcle\u202e\": {}  # \u202e\n");
    for (const std::string& arguments : std::vector<std::string>{"check '" + evil + "'", "simulate '" + evil + "'", "test '" + evil + "'", "check '" + raw + "'",
                                                                 "check --verbose '" + fine + "'", "simulate --seconds 0.01 '" + fine + "'",
                                                                 "simulate '" + fine + "' --inputs " + lines, "check '" + gone + "'", "nodes '" + gone + "'",
                                                                 "'" + gone + "'", "simulate " + fine + " --launch '" + gone + "'",
                                                                 "render " + fine + " -o '" + gone + "/x.png'"}) {
        const Outcome outcome = run_pinfield(arguments);
        INFO(arguments << "\n" << outcome.out << outcome.err);
        CHECK(outcome.exit <= 3);
        CHECK(is_harmless(outcome.out + outcome.err));
        CHECK_THAT(outcome.out + outcome.err, !Catch::Contains("\nline: error: none"));
    }
    CHECK_THAT(run_pinfield("simulate --seconds 0.01 " + fine).out, Catch::StartsWith("evil\\x1b[31m\\x07\\x85\\u202ename\\nline: error: none: "));
    CHECK_THAT(run_pinfield("check '" + raw + "'").out, Catch::Contains("  # \\u202e\n      ^\n"));
}

TEST_CASE("JSON is valid and says the same whatever stands in paths and names; what format prints is data and stays as it is") {
    const Scratch scratch;
    for (const std::string name : {"a\nb", "\x1b[31m\a", "\xff\xfe\xc3", "\u202e\U000e0041\u0085", "\"\\", "\x7f"}) {
        const std::string path = scratch.write(name + ".yaml", evil_yaml + "  - circle: {radius: -1}\n");
        const Outcome outcome = run_pinfield("check --json '" + path + "'");
        INFO(outcome.out << outcome.err);
        CHECK(is_harmless(outcome.out));
        const json findings = json::parse(outcome.out);
        REQUIRE(findings.size() == 1);
        if (name[0] != '\xff') CHECK(findings[0]["file"] == path);
    }
    const std::string fine = scratch.write("fine.yaml", evil_yaml);
    CHECK(json::parse(run_pinfield("simulate --json --seconds 0.01 " + fine).out)["table"] == "evil\x1b[31m\a\u0085\u202ename\nline: error: none");
    const std::string canonical = scratch.write("canonical.yaml", run_pinfield("format " + fine).out);
    CHECK(json::parse(run_pinfield("simulate --json --seconds 0.01 " + canonical).out)["table"] == "evil\x1b[31m\a\u0085\u202ename\nline: error: none");
}

TEST_CASE("a run that fails half way leaves an output as it was, and nothing beside it") {
    const Scratch scratch;
    const std::string points = scratch.write("p.csv", "x,y\n0.2,0.3\n0.2,0.4\n0.2,much\n");
    const std::string out = scratch.write("old.csv", "old\n"), table = scratch.write("t.yaml", slurp(fs::path(pinfield::test::source_dir()) / first_table));
    const std::size_t files = files_in(scratch / ".");
    CHECK(run_pinfield("eval " + table + " --points " + points + " -o " + out).exit == 3);
    CHECK(slurp(out) == "old\n");
    for (const char* option : {"--trace ", "--events "}) {
        CHECK(exit_of("simulate " + table + " --seconds 5 --launch 0.2,0.5,1,0 " + option + out, ">/dev/null 2>/dev/null") == 0);
        CHECK(slurp(out).size() > 4096);
        scratch.write("old.csv", "old\n");
        const std::string limited = std::string("sh -c 'trap \"\" XFSZ; ulimit -f 4; exec ") + pinfield::test::bin_dir() + "/pinfield simulate " + table +
                                    " --seconds 5 --launch 0.2,0.5,1,0 " + option + out + " >/dev/null 2>/dev/null'";
        const int status = std::system(limited.c_str());
        CHECK(WEXITSTATUS(status) == 3);
        CHECK(slurp(out) == "old\n");
        CHECK(files_in(scratch / ".") == files);
    }
}

TEST_CASE("an output that is an input, by whatever name, is refused before anything is written") {
    const Scratch scratch;
    const std::string text = slurp(fs::path(pinfield::test::source_dir()) / first_table);
    const std::string table = scratch.write("t.yaml", text), points = scratch.write("p.csv", "x,y\n0,0\n");
    fs::create_symlink("t.yaml", scratch / "soft.yaml");
    fs::create_hard_link(table, scratch / "hard.yaml");
    for (const char* name : {"t.yaml", "soft.yaml", "hard.yaml"})
        for (const std::string& command : {"render " + table + " -o ", "eval " + table + " --points " + points + " -o ",
                                           "simulate " + table + " --seconds 0.01 --trace ", "simulate " + table + " --seconds 0.01 --events "}) {
            INFO(command << name);
            CHECK(run_pinfield(command + (scratch / name)).exit == 2);
            CHECK(slurp(table) == text);
        }
}

TEST_CASE("a dash is stdout for every output, and nothing else comes with it") {
    const Scratch scratch;
    const std::string points = scratch.write("p.csv", "x,y\n0.2,0.3\n");
    const Outcome picture = run_pinfield("render " + first_table + " --size 20x40 -o -");
    REQUIRE(run_pinfield("render " + first_table + " --size 20x40 -o " + (scratch / "x.png")).exit == 0);
    CHECK(picture.exit == 0);
    CHECK(picture.out == slurp(scratch / "x.png"));
    CHECK_FALSE(fs::exists(fs::path(pinfield::test::source_dir()) / "-"));
    REQUIRE(run_pinfield("simulate " + first_table + " --seconds 0.01 --trace " + (scratch / "t.csv")).exit == 0);
    for (const char* name : {"-", "/dev/stdout"}) {
        const Outcome trace = run_pinfield("simulate " + first_table + " --seconds 0.01 --trace " + name);
        CHECK(trace.out == slurp(scratch / "t.csv"));
        CHECK_THAT(trace.err, Catch::Contains("state hash"));
    }
    CHECK(run_pinfield("simulate " + first_table + " --trace - --events /dev/stdout").exit == 2);
    for (const std::string& arguments : {"render " + first_table + " -o ''", "eval " + first_table + " --points " + points + " -o ''",
                                         "simulate " + first_table + " --trace ''"})
        CHECK(run_pinfield(arguments).exit == 2);
}

TEST_CASE("inputs without end, and lines without end, are refused at once") {
    const Scratch scratch;
    const std::string limit = memory_limit + "timeout 20 " + pinfield::test::bin_dir() + std::string("/pinfield ");
    const auto exit = [&](const std::string& arguments) {
        const std::string command = std::string("cd ") + pinfield::test::source_dir() + "; " + limit + arguments + " >/dev/null 2>/dev/null";
        return WEXITSTATUS(std::system(command.c_str()));
    };
    CHECK(exit("eval " + first_table + " --points /dev/zero") == 3);
    CHECK(exit("simulate " + first_table + " --inputs /dev/zero") == 3);
    CHECK(exit("check /dev/zero") == 3);
    const std::string endless = "(echo tick,input,value; yes 1,plunge,1) | ";
    const std::string command = std::string("cd ") + pinfield::test::source_dir() + "; " + memory_limit + endless + "timeout 20 " +
                                pinfield::test::bin_dir() + "/pinfield simulate " + first_table + " --inputs /dev/stdin >/dev/null 2>/dev/null";
    CHECK(WEXITSTATUS(std::system(command.c_str())) == 3);
    const std::string longest = std::string(5000, '1');
    CHECK_THAT(run_pinfield("eval " + first_table + " --points " + scratch.write("l.csv", "x,y\n" + longest + ",1\n")).err, Catch::Contains(":2: the line is longer"));
}

TEST_CASE("./play names a table that is not there and is exit 3, before it builds anything") {
    const std::string play = std::string(pinfield::test::source_dir()) + "/play ";
    const Scratch scratch;
    for (const std::string& table : std::vector<std::string>{"''", "no/such/x", "'" + (scratch / "gone\x1b[31m") + "'", scratch / "."}) {
        const std::string err = scratch / "err";
        const int status = std::system((play + table + " >/dev/null 2>" + err + " </dev/null").c_str());
        INFO(table << ": " << slurp(err));
        CHECK(WEXITSTATUS(status) == 3);
        CHECK_THAT(slurp(err), Catch::StartsWith("There is no table "));
        CHECK(is_harmless(slurp(err)));
    }
}

TEST_CASE("a demo plays any table: it presses what inputs there are, and drops a ball where there is no spawn") {
    const Scratch scratch;
    const std::string bare = scratch.write("bare.yaml", "pinfield: 1\nscene:\n  - circle: {at: [0.2, 0.2]}\n");
    const json dropped = json::parse(run_pinfield("simulate --json --demo --seconds 2 " + bare).out);
    CHECK(dropped["balls"] == 1);
    CHECK(dropped["events"].contains("hit"));
    const json played = json::parse(run_pinfield("simulate --json --demo --seconds 10 " + first_table).out);
    CHECK(played["events"]["press"] >= 30);
    CHECK(played["events"].contains("launch"));
    CHECK(run_pinfield("simulate --demo --inputs x.csv " + first_table).exit == 2);
}

TEST_CASE("small and fast balls cost no more than others, and are audited as they are") {
    const Scratch scratch;
    const std::string tiny = scratch.write("tiny.yaml", "pinfield: 1\nphysics: {ball_radius: 1e-9}\nscene:\n  - circle: {radius: 10mm, at: [0.2, 0.3]}\n");
    for (const char* launch : {"0.1,0.1,1e3,1e3", "0.1,0.1,1e6,1e5", "0.1,0.1,0.1,0.1"}) {
        const json summary = json::parse(run_pinfield("simulate --json --seconds 0.1 " + tiny + " --launch " + launch).out);
        CHECK(summary["wall_seconds"].get<double>() < 1);
        CHECK(summary["escaped"] == 0);
        CHECK(summary["capped_ticks"].is_number());
    }
}

TEST_CASE("of thirty thousand layers one is told, at its place") {
    const Scratch scratch;
    std::string text = "pinfield: 1\nscene:\n";
    for (int i = 0; i < 29'000; ++i) text += "  - circle: {layer: l" + std::to_string(i) + "}\n";
    const Outcome outcome = run_pinfield("check " + scratch.write("t.yaml", text));
    CHECK(outcome.exit == 1);
    CHECK_THAT(outcome.out, Catch::Contains("t.yaml:34:5: error: l31 is one layer more than the 32 that are possible"));
    CHECK(lines_of(outcome.out).size() == 5);
}
