// scenes/invalid: each file says in its first lines which codes `check` tells of it, and where.
#include <catch2/catch.hpp>
#include <filesystem>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "engine/core/error_codes.h"
#include "engine/game/starts.h"
#include "engine/io/load_table.h"
#include "engine/program/compile.h"
#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;
namespace fs = std::filesystem;

namespace {

/// Of each first line: `# expect E0203 4:15`, `# expect E0203 parts/gears.yaml:4:15` for what stands in another file, and the way to it, from the
/// innermost outwards: `# via the template gear, asked for at templates.yaml:9:5`.
std::vector<std::string> expected(const std::string& text) {
    std::vector<std::string> out;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line) && (line.starts_with("# expect ") || line.starts_with("# via "));)
        out.push_back(line.substr(2));
    return out;
}

/// What these lines say of a reading. Files go by their paths from the scene's folder.
std::vector<std::string> found(const Reading& result, const fs::path& scene) {
    const Sources& sources = result.scene.sources;
    const auto told_place = [&](const Place& place) {
        const LineColumn at = sources.line_column(place);
        const SourceText* source = sources.find(place);
        const std::string file = fs::path(source ? source->name() : "nowhere").lexically_relative(scene.parent_path()).generic_string();
        return fmt::format("{}:{}:{}", file, at.line, at.column);
    };
    std::vector<std::string> out;
    for (const Diagnostic& d : result.diagnostics) {
        const std::string place = told_place(d.where), own = scene.filename().string() + ":";
        out.push_back(fmt::format("expect {} {}", d.code, place.starts_with(own) ? place.substr(own.size()) : place));
        for (const Via& step : way_to(d, sources)) out.push_back(fmt::format("via {}, {} at {}", step.what, step.how, told_place(step.where)));
    }
    return out;
}

/// Codes that no committed file can show, and where they are shown instead.
const std::set<std::string> elsewhere{
    "E0102", "E0103", "E0106", "E0108",
    "E0109", "E0110", "E0111", "E0122",  // hostile.test.cpp and table_reader.test.cpp
    "E0123", "E0124",                    // tests/expression/expression.test.cpp
    "E0125",                             // tests/io/params.test.cpp
    "E0126", "E0127",                    // tests/io/include.test.cpp
    "W0503",                             // tests/program/distance_quality.test.cpp
    "W0510",                             // pockets.test.cpp
    "E0601",                             // script_reader.test.cpp
};

/// What reader, compiler and the judges of a running table find.
Reading judged(const fs::path& scene) {
    Reading result = *load_table(scene.string(), catalog());
    if (!result.ok()) return result;
    const auto program = compile(result.scene);
    const Diagnostics more = program ? doubts_of(**program, result.scene) : program.error();
    result.diagnostics.insert(result.diagnostics.end(), more.begin(), more.end());
    return result;
}

}  // namespace

TEST_CASE("each invalid scene gets exactly the codes it announces, where it announces them") {
    const auto files = scene_files("invalid");
    CHECK(files.size() >= 120);
    for (const auto& path : files) {
        const Reading result = judged(path);
        INFO(path.filename().string() << "\n" << told(result));
        REQUIRE_FALSE(expected(file_text(path)).empty());
        CHECK(found(result, path) == expected(file_text(path)));
    }
}

TEST_CASE("every error code is shown by a scene or a test of its own") {
    std::set<std::string> shown = elsewhere;
    for (const auto& path : scene_files("invalid"))
        for (const std::string& line : expected(file_text(path)))
            if (line.starts_with("expect ")) shown.insert(line.substr(7, 5));
    for (const ErrorCode& code : error_codes()) {
        INFO(code.name);
        CHECK(shown.count(std::string(code.code)) == 1);
    }
}

TEST_CASE("codes and names are unique and tell their severity") {
    std::set<std::string_view> codes, names;
    for (const ErrorCode& code : error_codes()) {
        CHECK(codes.insert(code.code).second);
        CHECK(names.insert(code.name).second);
        CHECK((code.code.front() == 'E' || code.code.front() == 'W'));
        CHECK_FALSE(code.meaning.empty());
    }
    CHECK(diagnose(Code::empty_scene, {}, "x").severity == Severity::warning);
    CHECK(entry(Code::unknown_node).code == "E0203");
}
