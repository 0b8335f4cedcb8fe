// The layer table, kept. Debian's headers all sit in one folder that every target can see: no linker could keep it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/places.h"

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// One row: which files, which project files they may include, which third parties. All are beginnings of paths.
struct Row {
    std::string files;
    Words project;
    Words third_party;
};

// fmt and tl::expected are how core speaks (text, Result): who may include core may name them.
const Words vocabulary{"fmt/", "tl/expected.hpp"};
const Words whole_engine{"engine/"};
const Words open_gl{"GLFW/", "GL/", "GLES3/", "AL/"};
const Words imgui{"imgui"};

Words operator+(Words a, const Words& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// The table of the architecture. A file belongs to the row with the longest beginning of its path.
const std::vector<Row>& layer_table() {
    static const std::vector<Row> table{
        {"engine/core/", {}, {"Eigen/"}},
        {"engine/reflect/", {"engine/core/"}, {"Eigen/"}},
        {"engine/expression/", {"engine/core/"}, {}},
        {"engine/sdf/", {"engine/core/", "engine/reflect/", "engine/expression/"}, {"Eigen/", "xsimd/"}},
        {"engine/scene/", {"engine/core/", "engine/reflect/", "engine/sdf/"}, {"Eigen/"}},
        {"engine/io/",
         {"engine/core/", "engine/reflect/", "engine/expression/", "engine/scene/", "engine/io/"},
         {"Eigen/", "yaml-cpp/", "nlohmann/", "stb/"}},
        // fsync before rename: what no C++ library offers, and POSIX (emscripten too) does.
        {"engine/io/files",
         {"engine/core/", "engine/io/"},
         {"sys/file.h", "sys/stat.h", "unistd.h", "fcntl.h"}},
        // Closed descriptors and named pipes, likewise.
        {"engine/io/output_file", {"engine/core/", "engine/io/"}, {"unistd.h", "fcntl.h"}},
        {"engine/program/", {"engine/core/", "engine/reflect/", "engine/sdf/", "engine/scene/"}, {"Eigen/", "xsimd/"}},
        {"engine/physics/", {"engine/core/", "engine/program/", "engine/scene/parts/", "engine/sdf/piece.h"}, {"Eigen/"}},
        {"engine/game/", {"engine/core/", "engine/scene/", "engine/program/", "engine/physics/"}, {}},
        {"engine/rules/", {"engine/core/", "engine/reflect/", "engine/scene/", "engine/physics/"}, {}},
        {"engine/cli/", whole_engine, {"Eigen/", "CLI/"}},
        {"editor/", whole_engine + Words{"editor/journal."}, {"Eigen/"}},
        // Locks and synced files: what no C++ library offers.
        {"editor/journal.", {"engine/core/"}, {"sys/file.h", "sys/stat.h", "unistd.h", "fcntl.h"}},
        {"editor/app.", whole_engine + Words{"editor/"}, {"Eigen/", "imgui"}},
        {"editor/main.", whole_engine + Words{"editor/"}, {"CLI/"}},
        {"editor/panels/", whole_engine + Words{"editor/"}, {"Eigen/", "imgui"}},
        {"editor/widgets/", whole_engine + Words{"editor/"}, {"Eigen/", "imgui"}},
        {"editor/theme/", whole_engine + Words{"editor/"}, {"Eigen/", "imgui"}},
        // Only here may anything belong to one operating system.
        {"editor/platform/",
         {"engine/core/", "engine/program/"},
         open_gl + imgui + Words{"Eigen/", "sys/", "unistd.h", "fcntl.h"}},
        {"editor/render/", {"engine/core/", "engine/program/", "editor/platform/"}, open_gl + Words{"Eigen/"}},
        {"editor/audio/", {"engine/core/", "engine/program/"}, open_gl},
    };
    return table;
}

bool starts_with_any(std::string_view path, const Words& beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(), [&](const std::string& b) { return path.starts_with(b); });
}

const Row* row_of(std::string_view path) {
    const Row* best = nullptr;
    for (const Row& row : layer_table())
        if (path.starts_with(row.files) && (!best || row.files.size() > best->files.size())) best = &row;
    return best;
}

/// Calls visit(line number, line) for each line.
template <class Visit>
void for_lines(const std::string& text, Visit visit) {
    std::istringstream lines(text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) visit(number, line);
}

/// What is wrong with one #include, or nothing.
std::string fault_of_include(const std::string& path, const Row& row, const std::string& name, bool quoted) {
    const bool in_header = path.ends_with(".h");
    if (quoted) {
        if (!name.starts_with("engine/") && !name.starts_with("editor/")) return "is not named from the project's root";
        // A row sees itself; within the editor, the rows with a folder of their own see their folder only.
        const Row* theirs = row_of(name);
        if (theirs == &row || starts_with_any(name, row.project)) return "";
        return "is not in the row of " + row.files;
    }
    if (name.find('.') == std::string::npos && name.find('/') == std::string::npos) return "";  // the standard library
    if (starts_with_any(name, vocabulary)) return "";
    if (!starts_with_any(name, row.third_party)) return "is no third party of " + row.files;
    if (in_header && row.files == "engine/io/" && !name.starts_with("Eigen/")) return "belongs in .cpp files only";
    return "";
}

Words faults_of_includes(const std::string& path, const std::string& text) {
    static const std::regex include(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
    const Row* row = row_of(path);
    if (!row) return {path + ": belongs to no row of the layer table"};
    Words faults;
    for_lines(text, [&](int number, const std::string& line) {
        std::smatch match;
        if (!std::regex_search(line, match, include)) return;
        const std::string fault = fault_of_include(path, *row, match[2], match[1] == "\"");
        if (!fault.empty()) faults.push_back(path + ":" + std::to_string(number) + ": " + match[2].str() + " " + fault);
    });
    return faults;
}

/// The functions whose last bit differs between maths libraries. sqrt, fabs, floor, fmod are exact by IEEE 754.
Words faults_of_mathematics(const std::string& path, const std::string& text) {
    static const std::regex call(
        R"(std::(sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|exp|exp2|expm1|log|log2|log10|log1p|pow|cbrt|hypot|fma)\b)");
    Words faults;
    for_lines(text, [&](int number, const std::string& line) {
        const std::string code = line.substr(0, line.find("//"));
        if (std::regex_search(code, call))
            faults.push_back(path + ":" + std::to_string(number) + ": use engine/core/trig.h");
    });
    return faults;
}

/// A file that must be long says why near its top.
Words faults_of_length(const std::string& path, const std::string& text) {
    constexpr int most_lines = 450, head = 15;
    int lines = 0;
    bool excused = false;
    for_lines(text, [&](int number, const std::string& line) {
        lines = number;
        excused = excused || (number <= head && line.find("// Long because:") != std::string::npos);
    });
    if (lines <= most_lines || excused) return {};
    return {path + ": " + std::to_string(lines) + " lines, and no \"// Long because:\" in the first " +
            std::to_string(head)};
}

const std::regex& quoted_include() {
    static const std::regex include(R"~(^\s*#\s*include\s*"([^"]+)")~");
    return include;
}

std::string text_of(const std::string& path) {
    std::ifstream stream(fs::path(pinfield::test::source_dir()) / path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Which of the forbidden files, named by the beginnings of their paths, a file includes, by itself or through others: each with the way
/// there. `text_of(path)` reads a file.
template <class TextOf>
Words ways_to(const Words& forbidden, const std::string& path, const TextOf& text_of) {
    std::map<std::string, std::string> way{{path, path}};
    Words open{path}, found;
    while (!open.empty()) {
        const std::string file = open.back();
        open.pop_back();
        for_lines(text_of(file), [&](int, const std::string& line) {
            std::smatch match;
            if (!std::regex_search(line, match, quoted_include()) || way.contains(match[1])) return;
            way[match[1]] = way[file] + " > " + match[1].str();
            if (starts_with_any(match[1].str(), forbidden)) found.push_back(way[match[1]]);
            else open.push_back(match[1]);
        });
    }
    return found;
}

/// Sources under the given folders of the project, sorted, with their texts.
template <class Judge>
Words faults_in(const Words& folders, Judge judge) {
    const fs::path root = pinfield::test::source_dir();
    std::vector<fs::path> files;
    for (const std::string& folder : folders) {
        if (!fs::exists(root / folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(root / folder))
            if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    REQUIRE(files.size() > 10);
    Words faults;
    for (const fs::path& file : files) {
        const std::string path = fs::relative(file, root).generic_string();
        faults = faults + judge(path, text_of(path));
    }
    return faults;
}

std::string listed(const Words& faults) {
    std::string text;
    for (const std::string& fault : faults) text += fault + "\n";
    return text;
}

}  // namespace

TEST_CASE("every include is in its row of the layer table") {
    CHECK(listed(faults_in({"engine", "editor"}, faults_of_includes)) == "");
}

TEST_CASE("nothing reachable from a Program or the physics calls a transcendental of the C library") {
    const Words folders{"engine/core",  "engine/reflect", "engine/expression", "engine/sdf",
                        "engine/scene", "engine/program", "engine/physics"};
    CHECK(listed(faults_in(folders, faults_of_mathematics)) == "");
}

/// What decides how balls move, and what a world holds of it.
const Words the_sweep{"engine/physics/sweep_", "engine/physics/state.h", "engine/physics/motion.h", "engine/physics/mechanisms/"};

TEST_CASE("the auditor includes nothing of the sweep that it checks, directly or through others") {
    CHECK(listed(ways_to(the_sweep, "engine/physics/audit.cpp", text_of)) == "");
}

TEST_CASE("a way to a forbidden file is reported, however long") {
    const std::map<std::string, std::string> files{{"a.cpp", "#include \"a.h\"\n#include <map>\n"},
                                                   {"a.h", "#include \"b.h\"\n"},
                                                   {"b.h", "#include \"a.h\"\n  # include \"c/d.h\"\n"}};
    const auto text_of = [&](const std::string& path) { return files.contains(path) ? files.at(path) : std::string(); };
    CHECK(ways_to({"c/"}, "a.cpp", text_of) == Words{"a.cpp > a.h > b.h > c/d.h"});
    CHECK(ways_to({"d/"}, "a.cpp", text_of).empty());
    CHECK(ways_to({"engine/physics/sweep_"}, "engine/physics/state.h", ::text_of).size() > 0);
}

TEST_CASE("no source is longer than 450 lines without a reason in its head") {
    CHECK(listed(faults_in({"engine", "editor", "tests"}, faults_of_length)) == "");
}

TEST_CASE("an include outside its row is reported with its line") {
    CHECK(faults_of_includes("engine/core/a.h",
                             "#include \"engine/core/b.h\"\n#include <vector>\n#include <Eigen/Core>\n")
              .empty());
    CHECK(faults_of_includes("engine/core/a.h", "\n  # include \"engine/sdf/b.h\"\n") ==
          Words{"engine/core/a.h:2: engine/sdf/b.h is not in the row of engine/core/"});
    CHECK(faults_of_includes("engine/physics/a.cpp", "#include \"engine/scene/scene.h\"\n").size() == 1);
    CHECK(faults_of_includes("engine/io/a.cpp", "#include \"engine/program/program.h\"\n").size() == 1);
    CHECK(faults_of_includes("engine/sdf/nodes/a.h", "#include \"b.h\"\n").size() == 1);
    CHECK(faults_of_includes("engine/program/a.cpp", "#include <yaml-cpp/yaml.h>\n").size() == 1);
    CHECK(faults_of_includes("engine/io/a.cpp", "#include <yaml-cpp/yaml.h>\n").empty());
    CHECK(faults_of_includes("engine/io/a.h", "#include <yaml-cpp/yaml.h>\n").size() == 1);
    CHECK(faults_of_includes("engine/io/a.cpp", "#include <unistd.h>\n").size() == 1);
    CHECK(faults_of_includes("editor/document.cpp", "#include <imgui.h>\n").size() == 1);
    CHECK(faults_of_includes("editor/document.cpp", "#include \"editor/panels/inspector.h\"\n").size() == 1);
    CHECK(faults_of_includes("editor/panels/a.cpp", "#include <imgui.h>\n#include \"editor/document.h\"\n").empty());
    CHECK(faults_of_includes("editor/panels/a.cpp", "#include <GLFW/glfw3.h>\n").size() == 1);
    CHECK(faults_of_includes("editor/platform/a.cpp", "#include \"engine/io/yaml_reader.h\"\n").size() == 1);
    CHECK(faults_of_includes("engine/elsewhere/a.h", "").size() == 1);
}

TEST_CASE("a call of the C library's transcendentals is reported, one in a comment is not") {
    CHECK(faults_of_mathematics("a.cpp", "x = std::sqrt(y);\nx = std::cos(y);\n") ==
          Words{"a.cpp:2: use engine/core/trig.h"});
    CHECK(faults_of_mathematics("a.cpp", "x = pinfield::cosine(y);  // not std::cos\n").empty());
}

TEST_CASE("a long file is reported unless it says why it is long") {
    const std::string long_text(451, '\n');
    CHECK(faults_of_length("a.h", std::string(450, '\n')).empty());
    CHECK(faults_of_length("a.h", long_text).size() == 1);
    CHECK(faults_of_length("a.h", "// A table.\n// Long because: it is a table.\n" + long_text).empty());
    CHECK(faults_of_length("a.h", long_text + "// Long because: nobody reads the head.\n").size() == 1);
}
