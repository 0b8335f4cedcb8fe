// scenes/invalid: each file says in its first lines which codes `check` tells of it, and where.
#include <catch2/catch.hpp>
#include <set>
#include <sstream>

#include "engine/core/error_codes.h"
#include "engine/game/starts.h"
#include "engine/program/compile.h"
#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

/// "E0203 4:15" of each first line of the form `# expect E0203 4:15`.
std::vector<std::string> expected(const std::string& text) {
    std::vector<std::string> out;
    std::istringstream lines(text);
    const std::string mark = "# expect ";
    for (std::string line; std::getline(lines, line) && line.starts_with(mark);)
        out.push_back(line.substr(mark.size()));
    return out;
}

/// Codes that no committed file can show, and where they are shown instead.
const std::set<std::string> elsewhere{
    "E0102", "E0103", "E0106", "E0108",
    "E0109", "E0110", "E0111", "E0122",  // hostile.test.cpp and table_reader.test.cpp
    "E0123", "E0124",                    // tests/expression/expression.test.cpp
    "E0125",                             // tests/io/params.test.cpp
    "W0503",                             // tests/program/distance_quality.test.cpp
    "W0510",                             // pockets.test.cpp
    "E0601",                             // script_reader.test.cpp
};

/// What reader, compiler and the judges of a running table find.
Reading judged(const std::string& text) {
    Reading result = read(text);
    if (!result.ok()) return result;
    const auto program = compile(result.scene);
    const Diagnostics more = program ? doubts_of(**program, result.scene) : program.error();
    result.diagnostics.insert(result.diagnostics.end(), more.begin(), more.end());
    return result;
}

}  // namespace

TEST_CASE("each invalid scene gets exactly the codes it announces, where it announces them") {
    const auto files = scene_files("invalid");
    CHECK(files.size() >= 25);
    for (const auto& path : files) {
        const std::string text = file_text(path);
        const Reading result = judged(text);
        INFO(path.filename().string() << "\n" << told(result));
        REQUIRE_FALSE(expected(text).empty());
        CHECK(codes_and_places(result) == expected(text));
    }
}

TEST_CASE("every error code is shown by a scene or a test of its own") {
    std::set<std::string> shown = elsewhere;
    for (const auto& path : scene_files("invalid"))
        for (const std::string& line : expected(file_text(path))) shown.insert(line.substr(0, 5));
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
