// The script that `pinfield completion bash` prints, in a real bash, against what --help says.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>

#include "tests/cli/run.h"

using namespace pinfield::cli_test;

namespace {

using Words = std::vector<std::string>;

/// What bash completes the last word to, sorted. Bash itself splits words at =, which these have apart.
Words completed(const Words& words, const std::string& folder = pinfield::test::source_dir()) {
    const Scratch scratch;
    std::string line = "COMP_WORDS=(pinfield";
    for (const std::string& word : words) line.append(" '").append(word).append("'");
    const std::string script = "source <('" + pinfield::test::bin_dir() + "/pinfield' completion bash)\ncd '" + folder + "'\n" + line +
                               ")\nCOMP_CWORD=" + std::to_string(words.size()) + "\n_pinfield\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n";
    const std::string file = scratch.write("try.bash", script), out = scratch / "out";
    REQUIRE(std::system(("bash " + file + " > " + out + " 2>&1").c_str()) == 0);
    Words found = lines_of(slurp(out));
    std::erase(found, "");
    std::sort(found.begin(), found.end());
    return found;
}

/// The first long name of each option, and the subcommands, that a help text lists.
Words options_of(const std::string& help) {
    static const std::regex option(R"(\n  (?:-\w,)?(--[\w-]+))");
    Words out;
    for (std::sregex_iterator match(help.begin(), help.end(), option), end; match != end; ++match) out.push_back((*match)[1]);
    std::sort(out.begin(), out.end());
    return out;
}

Words commands_of(const std::string& help) {
    Words out;
    static const std::regex command(R"(\n  ([a-z]+) )");
    const std::string below = help.substr(help.find("Subcommands:"));
    for (std::sregex_iterator match(below.begin(), below.end(), command), end; match != end; ++match) out.push_back((*match)[1]);
    std::sort(out.begin(), out.end());
    return out;
}

}  // namespace

TEST_CASE("bash takes the script without a word") {
    const Scratch scratch;
    const std::string file = scratch.write("pinfield.bash", run_pinfield("completion bash").out), out = scratch / "out";
    CHECK(std::system(("bash -n " + file + " > " + out + " 2>&1").c_str()) == 0);
    CHECK(slurp(out).empty());
}

TEST_CASE("every command and option of the help is completed, and none else") {
    const std::string help = run_pinfield("--help").out;
    const Words commands = commands_of(help);
    CHECK(commands.size() >= 12);
    CHECK(completed({""}) == commands);
    CHECK(completed({"-"}) == options_of(help));
    for (const std::string& command : commands) {
        INFO(command);
        const Words options = options_of(run_pinfield(command + " --help").out);
        CHECK(std::count(options.begin(), options.end(), "--help") == 1);
        CHECK(completed({command, "--"}) == options);
    }
}

TEST_CASE("words that an option or a command takes are completed, with a blank or with =") {
    CHECK(completed({"re"}) == Words{"render"});
    CHECK(completed({"render", "--mo"}) == Words{"--mode"});
    CHECK(completed({"render", "--mode", ""}) == Words{"isolines", "shaded"});
    CHECK(completed({"render", "--mode", "=", "sh"}) == Words{"shaded"});
    CHECK(completed({"render", "--mode", "="}) == Words{"isolines", "shaded"});
    CHECK(completed({"nodes", "smooth_"}) == Words{"smooth_difference", "smooth_intersection", "smooth_union"});
    CHECK(completed({"explain", "E020"}).size() == 9);
    CHECK(completed({"new", "x", "--from", "h"}) == Words{"homework"});
    CHECK(completed({"completion", ""}) == Words{"bash"});
    CHECK(completed({"simulate", "--seconds", ""}).empty());
    CHECK(completed({"no_such_command", ""}).empty());
}

TEST_CASE("tables are completed where tables are due, any file where any is, and folders on the way, whatever they are called") {
    const Scratch scratch;
    for (const char* name : {"a.yaml", "b.yml", "a.csv", "a b.yaml", "it's $HOME.yaml"}) scratch.write(name, "");
    std::filesystem::create_directory(scratch / "deep");
    scratch.write("deep/c.yaml", "");
    const std::string folder = scratch / "";
    CHECK(completed({"check", ""}, folder) == Words{"a b.yaml", "a.yaml", "b.yml", "deep", "it\'s $HOME.yaml"});
    CHECK(completed({"check", "a.yaml", "a"}, folder) == Words{"a b.yaml", "a.yaml"});
    CHECK(completed({"check", "deep/"}, folder) == Words{"deep/c.yaml"});
    CHECK(completed({"eval", "--points", "a."}, folder) == Words{"a.csv", "a.yaml"});
    CHECK(completed({"render", "-o", "de"}, folder) == Words{"deep"});
}
