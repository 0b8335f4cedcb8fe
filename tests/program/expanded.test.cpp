// A table with params, templates, copies and pairs compiles into the program of its expanded twin, bit for bit.
#include "engine/scene/expanded.h"

#include <catch2/catch.hpp>
#include <algorithm>
#include <filesystem>
#include <sstream>

#include "engine/core/rng.h"
#include "engine/io/load_table.h"
#include "engine/io/write_table.h"
#include "engine/program/evaluate.h"
#include "tests/io/split_table.h"
#include "tests/places.h"
#include "tests/program/same_program.h"
#include "tests/program/tables.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

/// The program, with the dots of made ids as expanded() writes them.
Program with_plain_names(const Scene& scene) {
    Program program = *compiled(scene);
    for (Part& part : program.parts) std::replace(part.name.begin(), part.name.end(), '.', '_');
    return program;
}

Scene read_scene(const std::string& text) {
    const Reading reading = read_table(std::make_shared<const SourceText>("test.yaml", text), catalog());
    for (const Diagnostic& d : reading.diagnostics) UNSCOPED_INFO(format(d, reading.scene.sources));
    REQUIRE(reading.ok());
    return reading.scene;
}

const std::string written_once =
    "pinfield: 1\n"
    "params: {gap: 46mm, teeth: {value: 9, min: 3, max: 24, step: 1}, petal: 18mm * 1.6}\n"
    "materials: {rubber: {}, goo: {}}\n"
    "templates:\n"
    "  gear:\n"
    "    args: {r: 46mm, dir: 1, skin: rubber}\n"
    "    nodes:\n"
    "      - difference:\n"
    "          turn: 60 * dir\n"
    "          material: $skin\n"
    "          children:\n"
    "            - circle: {radius: r}\n"
    "            - circle: {radius: r / 4}\n"
    "            - repeat_polar: {count: teeth, children: [box: {size: [5mm, r / 3], at: [0, r]}]}\n"
    "scene:\n"
    "  - use: {template: gear, id: gear, at: [0.20, 0.62], with: {r: \"clamp(2 * gap, 30mm, 46mm)\"}}\n"
    "  - use: {template: gear, id: small, at: [0.1, 0.8], with: {r: 1cm * i, dir: -1, skin: goo}, copies: {count: 2, step: [2 * gap, 0]}}\n"
    "  - bumper: {id: pop, at: [0.26, 0.80], radius: 24mm, copies: {count: 3, around: [0.26, 0.75]}}\n"
    "  - flipper: {id: flip, at: [0.17, 0.12], length: 70mm, rest: -30, swing: 51, input: [left, right], pair: 0.26}\n"
    "  - smooth_union: {material: goo, k: 1cm, children: [circle: {radius: 18mm, at: [0.22, 0.40]}, circle: {radius: petal, at: [0.28, 0.42]}]}\n"
    "inputs: {left: Z, right: Slash}\n";

// The same by hand. 0.26 + (0.8 - 0.75) turned by 120 degrees is written as a table's author would: with an expression.
const std::string by_hand =
    "pinfield: 1\n"
    "materials: {rubber: {}, goo: {}}\n"
    "scene:\n"
    "  - group:\n"
    "      id: gear\n"
    "      at: [0.20, 0.62]\n"
    "      children:\n"
    "        - difference:\n"
    "            turn: 60\n"
    "            material: rubber\n"
    "            children:\n"
    "              - circle: {radius: 46mm}\n"
    "              - circle: {radius: 11.5mm}\n"
    "              - repeat_polar: {count: 9, children: [box: {size: [5mm, 46mm / 3], at: [0, 46mm]}]}\n"
    "  - group:\n"
    "      id: small\n"
    "      children:\n"
    "        - group:\n"
    "            id: small_1\n"
    "            at: [0.1, 0.8]\n"
    "            children:\n"
    "              - difference:\n"
    "                  turn: -60\n"
    "                  material: goo\n"
    "                  children:\n"
    "                    - circle: {radius: 1cm}\n"
    "                    - circle: {radius: 2.5mm}\n"
    "                    - repeat_polar: {count: 9, children: [box: {size: [5mm, 1cm / 3], at: [0, 1cm]}]}\n"
    "        - group:\n"
    "            id: small_2\n"
    "            at: [0.1 + 92mm, 0.8]\n"
    "            children:\n"
    "              - difference:\n"
    "                  turn: -60\n"
    "                  material: goo\n"
    "                  children:\n"
    "                    - circle: {radius: 2cm}\n"
    "                    - circle: {radius: 5mm}\n"
    "                    - repeat_polar: {count: 9, children: [box: {size: [5mm, 2cm / 3], at: [0, 2cm]}]}\n"
    "  - group:\n"
    "      id: pop\n"
    "      children:\n"
    "        - bumper: {id: pop_1, at: [0.26, 0.80], radius: 24mm}\n"
    "        - bumper: {id: pop_2, at: [0.26 - sin(120) * (0.80 - 0.75), 0.75 + cos(120) * (0.80 - 0.75)], radius: 24mm, turn: 120}\n"
    "        - bumper: {id: pop_3, at: [0.26 - sin(240) * (0.80 - 0.75), 0.75 + cos(240) * (0.80 - 0.75)], radius: 24mm, turn: 240}\n"
    "  - group:\n"
    "      id: flip\n"
    "      children:\n"
    "        - flipper: {id: flip_left, at: [0.17, 0.12], length: 70mm, rest: -30, swing: 51, input: left}\n"
    "        - flipper: {id: flip_right, at: [2 * 0.26 - 0.17, 0.12], length: 70mm, rest: -30, swing: 51, input: right, flip: x}\n"
    "  - smooth_union: {material: goo, k: 1cm, children: [circle: {radius: 18mm, at: [0.22, 0.40]}, circle: {radius: 18mm * 1.6, at: [0.28, 0.42]}]}\n"
    "inputs: {left: Z, right: Slash}\n";

/// The program of a table in files, its nodes with the ids that they have in one.
Program of_files(const SplitTable& split, const Scene& one) {
    const OpenFile open = [&](const std::string& path, std::size_t) -> Result<FoundFile> { return FoundFile{path, split.files.at(path)}; };
    Reading many = read_table(std::make_shared<const SourceText>("table.yaml", split.main), catalog(), {}, open);
    for (const Diagnostic& d : many.diagnostics) UNSCOPED_INFO(format(d, many.scene.sources));
    REQUIRE(many.ok());
    many.scene.take_ids_of(one);
    return *compiled(many.scene);
}

/// Canonical text, taken apart: an entry begins two columns in.
TableEntries entries_of(const std::string& canonical) {
    TableEntries out;
    std::istringstream lines(canonical);
    std::vector<std::string>* entries = nullptr;
    for (std::string line; std::getline(lines, line);) {
        if (line == "pinfield: 1") continue;
        const bool is_dealt = line == "params:" || line == "materials:" || line == "templates:" || line == "scene:";
        if (line[0] != ' ') entries = is_dealt ? &out.sections.emplace_back(line.substr(0, line.size() - 1), std::vector<std::string>()).second : nullptr;
        if (!entries) out.of_the_whole += line + '\n';
        else if (line[0] == ' ' && line[2] != ' ') entries->push_back(line.substr(2));
        else if (line[0] == ' ') entries->back() += '\n' + line;
    }
    return out;
}

}  // namespace

TEST_CASE("a table dealt to files compiles into the program of the table in one, bit for bit") {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        CounterRng rng(seed);
        const TableEntries entries = some_entries(rng);
        const Scene one = read_scene(in_one(entries));
        CHECK(difference(of_files(Dealer(rng).deal(entries), one), *compiled(one)).empty());
    }
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(source_dir()) / "scenes" / "tables")) {
        if (entry.path().extension() != ".yaml") continue;
        INFO(entry.path().string());
        const Scene one = read_scene(write_table(load_table(entry.path().string(), catalog())->scene));
        for (std::uint64_t seed = 0; seed < 4; ++seed) {
            CounterRng rng(seed);
            CHECK(difference(of_files(Dealer(rng).deal(entries_of(write_table(one))), one), *compiled(one)).empty());
        }
    }
}

TEST_CASE("what is said once compiles into what is written out by hand") {
    CHECK(difference(with_plain_names(read_scene(written_once)), *compiled(read_scene(by_hand))).empty());
    CHECK(difference(with_plain_names(read_scene(written_once)), with_plain_names(expanded(read_scene(written_once)))).empty());
}

TEST_CASE("every shipped table compiles into the program of its expanded text") {
    int tables = 0;
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(source_dir()) / "scenes" / "tables")) {
        if (entry.path().extension() != ".yaml") continue;
        INFO(entry.path().string());
        const Scene scene = load_table(entry.path().string(), catalog())->scene;
        CHECK(difference(with_plain_names(scene), *compiled(read_scene(write_table(expanded(scene))))).empty());
        ++tables;
    }
    CHECK(tables >= 2);
}

TEST_CASE("Moonrise said once has the solids of Moonrise, and is its expanded twin bit for bit") {
    const auto table = [](const char* path) { return load_table((std::filesystem::path(source_dir()) / path).string(), catalog())->scene; };
    const Scene once = table("tests/program/moonrise_once.yaml"), moonrise = table("scenes/tables/first_table.yaml");
    CHECK(difference(with_plain_names(once), *compiled(read_scene(write_table(expanded(once))))).empty());

    const ProgramPtr a = compiled(once), b = compiled(moonrise);
    CounterRng rng(20);
    for (int i = 0; i < 20000; ++i) {
        const Vec2 p(rng.in(0, 0.52), rng.in(0, 1.06));
        INFO(p.x() << ", " << p.y());
        CHECK(nearest(a->fixed, p, ground_layer, 1).distance == Approx(nearest(b->fixed, p, ground_layer, 1).distance).margin(1e-12));
    }
}
