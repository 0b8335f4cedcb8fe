// What the documents say is tried here, so that it stays true.
#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>

#include "tests/cli/run.h"
#include "tests/places.h"

using namespace pinfield::cli_test;
namespace fs = std::filesystem;

namespace {

std::string block_after(const std::string& text, const std::string& heading, const std::string& fence) {
    const std::size_t begin = text.find(fence + "\n", text.find(heading));
    REQUIRE(begin != text.npos);
    const std::size_t first = begin + fence.size() + 1;
    return text.substr(first, text.find("```", first) - first);
}

/// Does the map name this file: itself, as `stem.*`, by its folder, or as `command_*.cpp`?
bool is_mapped(const std::string& section, const fs::path& file) {
    const std::string name = file.filename().string(), stem = file.stem().string();
    for (const std::string& entry : {std::string("`").append(name).append("`"), std::string("`").append(stem).append(".*`")})
        if (section.find(entry) != section.npos) return true;
    return name.starts_with("command_") && section.find("`command_*.cpp`") != section.npos;
}

}  // namespace

TEST_CASE("the README's first table has at most ten lines, is right, and plays") {
    const std::string yaml = block_after(slurp(fs::path(pinfield::test::source_dir()) / "README.md"), "## Your first table", "```yaml");
    CHECK(lines_of(yaml).size() <= 10);
    const Scratch scratch;
    const std::string table = scratch.write("my_table.yaml", yaml);
    const Outcome checked = run_pinfield("check " + table);
    INFO(checked.out);
    CHECK(checked.exit == 0);
    CHECK(checked.out.empty());
    const Outcome played = run_pinfield("simulate " + table + " --seconds 5 --json");
    CHECK(played.exit == 0);
    CHECK_THAT(played.out, Catch::Contains("\"escaped\": 0,") && Catch::Contains("\"kick\""));
}

TEST_CASE("the README's simulation says what the command prints, but for the time it took") {
    const std::vector<std::string> shown = lines_of(
        block_after(slurp(fs::path(pinfield::test::source_dir()) / "README.md"), "## The command", "```console"));
    const std::string prompt = "$ pinfield ";
    REQUIRE(shown.size() > 2);
    REQUIRE(shown[0].starts_with(prompt));
    const Outcome played = run_pinfield(shown[0].substr(prompt.size()));
    INFO(played.err);
    REQUIRE(played.exit == 0);
    const std::vector<std::string> printed = lines_of(played.out);
    REQUIRE(printed.size() == shown.size() - 1);
    const auto timeless = [](const std::string& line) { return line.substr(0, line.find(") in ")); };
    for (std::size_t i = 0; i < printed.size(); ++i) CHECK(timeless(printed[i]) == timeless(shown[i + 1]));
}

TEST_CASE("the map of the engine names every file") {
    const fs::path engine = fs::path(pinfield::test::source_dir()) / "engine";
    const std::string map = slurp(engine / "README.md");
    for (const auto& layer : fs::directory_iterator(engine)) {
        if (!layer.is_directory()) continue;
        const std::string name = layer.path().filename().string();
        const std::size_t begin = map.find("\n## " + name + ":");
        INFO(name);
        REQUIRE(begin != map.npos);
        const std::string section = map.substr(begin, map.find("\n## ", begin + 1) - begin);
        for (const auto& entry : fs::directory_iterator(layer)) {
            INFO(entry.path());
            if (entry.is_directory())
                CHECK_THAT(section, Catch::Contains(std::string("`").append(entry.path().filename().string()).append("/`")));
            else if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
                CHECK(is_mapped(section, entry.path()));
        }
    }
}
