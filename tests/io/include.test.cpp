// A table in several files: as though all stood in one, and what is wrong told where it stands.
#include <catch2/catch.hpp>

#include <fmt/format.h>

#include "engine/io/include_reader.h"
#include "engine/io/text_patch.h"
#include "engine/io/write_table.h"
#include "engine/scene/expanded.h"
#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

using Files = std::map<std::string, std::string>;

const Files parts{
    {"parts/walls.yaml",
     "pinfield: 1\n"
     "include: [board.yaml]\n"
     "scene:\n"
     "  - box: {id: left_wall, size: [thick, 1], material: wood}\n"
     "  - use: {template: lamp, id: lit, at: [0.2, 0.5]}\n"},
    {"parts/board.yaml",
     "pinfield: 1\n"
     "params: {thick: gap / 2}\n"
     "materials: {wood: {restitution: 0.3}}\n"
     "scene: [group: {id: board, children: [circle: {radius: 1cm}]}]\n"},
    {"parts/lamps.yaml",
     "pinfield: 1\n"
     "include: [../parts/board.yaml]\n"
     "templates: {lamp: {args: {r: 9mm}, nodes: [circle: {id: bulb, radius: r - thick / 10}]}}\n"
     "inputs: {left: Z}\n"},
};
const std::string main_table =
    "pinfield: 1\n"
    "params: {gap: 2cm}\n"
    "include: [parts/walls.yaml, parts/lamps.yaml, \"./parts//board.yaml\"]\n"
    "scene:\n"
    "  - circle: {id: own, radius: thick}\n"
    "  - flipper: {id: bat, at: [0.3, 0.1], input: left}\n"
    "tests: [{run: 1s, expect: [lit.bulb.hits == 0]}]\n";

std::vector<std::string> roots_of(const Reading& reading) {
    std::vector<std::string> out;
    for (const NodeId id : reading.scene.roots()) out.push_back(reading.scene.path(id));
    return out;
}

/// "E0208 parts/walls.yaml:3:7" of every finding.
std::vector<std::string> findings(const Reading& reading) {
    std::vector<std::string> out;
    for (const Diagnostic& found : reading.diagnostics) {
        const LineColumn at = reading.scene.sources.line_column(found.where);
        out.push_back(fmt::format("{} {}:{}:{}", found.code, reading.scene.sources.find(found.where)->name(), at.line, at.column));
    }
    return out;
}

using Findings = std::vector<std::string>;

/// A table that includes these.
std::string including(const std::string& list) { return "pinfield: 1\ninclude: [" + list + "]\nscene: [circle: {}]\n"; }

}  // namespace

TEST_CASE("what an included file says is there as though the table said it") {
    const Reading reading = read_with(main_table, parts);
    INFO(told(reading));
    REQUIRE(reading.diagnostics.empty());
    const Scene& scene = reading.scene;
    CHECK(scene.find("left_wall")->get<Vec2>("size") == Vec2(0.01, 1));
    CHECK(scene.find("lit.bulb")->get<double>("radius") == 0.009 - 0.01 / 10);
    CHECK(scene.find("own")->get<double>("radius") == 0.01);
    CHECK(scene.params.size() == 2);
    CHECK(scene.materials().size() == 1);
    CHECK(scene.inputs.size() == 1);
    CHECK(scene.sources.all().size() == 4);
}

TEST_CASE("nodes of a file are drawn below those of the files that include it") {
    CHECK(roots_of(read_with(main_table, parts)) == Findings{"board", "left_wall", "lit", "own", "bat"});
}

TEST_CASE("a file that is named twice, and in different ways, is read once") {
    int opened = 0;
    const OpenFile folder = folder_of(parts);
    const OpenFile counting = [&](const std::string& path, std::size_t most) { return ++opened, folder(path, most); };
    const auto text = std::make_shared<const SourceText>("table.yaml", main_table);
    const Reading reading = read_table(text, catalog(), {}, counting);
    CHECK(reading.diagnostics.empty());
    CHECK(opened == 3);
    const Reading again = read_again(reading, main_table + "# and a comment\n");
    CHECK(again.diagnostics.empty());
    CHECK(opened == 3);
    CHECK(same_content(reading.scene, again.scene));
}

TEST_CASE("two paths to one file give its nodes once") {
    const OpenFile linked = [](const std::string&, std::size_t) -> Result<FoundFile> {
        return FoundFile{"real.yaml", "pinfield: 1\nscene: [circle: {id: one}]\n"};
    };
    const auto text = std::make_shared<const SourceText>("table.yaml", including("a.yaml, b.yaml, a.yaml, real.yaml"));
    const Reading reading = read_table(text, catalog(), {}, linked);
    CHECK(roots_of(reading) == Findings{"one", "circle[1]"});
    CHECK(roots_of(read_again(reading, text->text())) == Findings{"one", "circle[1]"});
}

TEST_CASE("files that include each other are told by their names, whichever way one comes to them") {
    const Files circle{{"a.yaml", "pinfield: 1\ninclude: [sub/b.yaml]\n"}, {"sub/b.yaml", "pinfield: 1\ninclude: [../a.yaml]\n"}};
    const Reading reading = read_with(including("a.yaml"), circle);
    CHECK(findings(reading) == Findings{"E0231 sub/b.yaml:2:11"});
    CHECK(reading.diagnostics.front().message == "files include each other in a circle: a.yaml -> sub/b.yaml -> a.yaml");
    CHECK(findings(read_with(including("table.yaml"), circle)) == Findings{"E0231 table.yaml:2:11"});
    CHECK(findings(read_with(including("x.yaml"), {{"x.yaml", "pinfield: 1\ninclude: [x.yaml, table.yaml]\n"}})) ==
          Findings{"E0231 x.yaml:2:11", "E0231 x.yaml:2:19"});
    const OpenFile all_one = [](const std::string&, std::size_t) -> Result<FoundFile> {
        return FoundFile{"real.yaml", "pinfield: 1\ninclude: [another.yaml]\n"};
    };
    CHECK(findings(read_table(std::make_shared<const SourceText>("table.yaml", including("a.yaml")), catalog(), {}, all_one)) ==
          Findings{"E0231 real.yaml:2:11"});
}

TEST_CASE("a finding in a file tells the way to it: its files, and the templates and copies that lead there") {
    Files files = parts;
    files["parts/lamps.yaml"] += "scene: [circle: {radius: -1}]\n";
    files["parts/walls.yaml"] += "  - use: {template: lamp, id: bad, with: {r: 0}}\n";
    const Reading reading = read_with(main_table, files);
    CHECK(told(reading) ==
          "parts/lamps.yaml:3:71: error: -0.001 m (r - thick / 10) must be above 0 m [E0208]\n"
          "  templates: {lamp: {args: {r: 9mm}, nodes: [circle: {id: bulb, radius: r - thick / 10}]}}\n"
          "                                                                        ^\n"
          "  in the file parts/lamps.yaml, included at table.yaml:3:29\n"
          "  in the template lamp, asked for at parts/walls.yaml:6:5\n"
          "  in the file parts/walls.yaml, included at table.yaml:3:11\n"
          "parts/lamps.yaml:5:26: error: -1 must be above 0 m [E0208]\n"
          "  scene: [circle: {radius: -1}]\n"
          "                           ^\n"
          "  in the file parts/lamps.yaml, included at table.yaml:3:29\n");
}

TEST_CASE("a file is told once on the way, however many steps are in it") {
    const Reading reading = read_with(including("a.yaml"), {{"a.yaml",
                                                             "pinfield: 1\n"
                                                             "templates: {inner: {nodes: [circle: {radius: -1}]}, outer: {nodes: [use: {template: inner}]}}\n"
                                                             "scene: [use: {template: outer}]\n"}});
    REQUIRE(reading.diagnostics.size() == 1);
    std::vector<std::string> way;
    for (const Via& step : way_to(reading.diagnostics.front(), reading.scene.sources)) way.push_back(step.what);
    CHECK(way == Findings{"the file a.yaml", "the template inner", "the template outer"});
}

TEST_CASE("a name that an included file says, too, is not changed in one of them alone") {
    const Files files{{"a.yaml", "pinfield: 1\nscene:\n  - circle: {id: there, material: wood}\n  - flipper: {id: bat, at: [0.2, 0.1], input: left}\n"}};
    const Reading reading = read_with("pinfield: 1\ninclude: [a.yaml]\nmaterials: {wood: {}, tin: {}}\ninputs: {left: Z, right: X}\n", files);
    INFO(told(reading));
    REQUIRE(reading.ok());
    const auto refusal = [&](const Edit& edit) { return why_invalid(reading.scene, edit).value_or(""); };
    const std::vector<NodeId>& materials = reading.scene.materials();
    CHECK(refusal(Rename{materials[0], "wood", "oak", true}) == "wood is called so in a.yaml:3, too: change both there");
    CHECK(refusal(Rename{{}, "left", "l", true}) == "left is called so in a.yaml:4, too: change both there");
    for (const Edit& edit : {Edit(Rename{materials[1], "tin", "iron", true}), Edit(Rename{{}, "right", "r", true})}) {
        CHECK(refusal(edit).empty());
        CHECK(patch_for(reading, std::span(&edit, 1)));
    }
    CHECK(refusal(Move{reading.scene.roots()[0], {}, 1}) == "there stands in a.yaml:3: change it there");
}

TEST_CASE("a file within a file tells both includes, and its own errors of YAML are told in it") {
    const Reading reading = read_with(including("a.yaml"), {{"a.yaml", "pinfield: 1\ninclude: [b.yaml]\n"}, {"b.yaml", "pinfield: 1\nscene: [circle: {]\n"}});
    CHECK(findings(reading).size() == 1);
    CHECK(told(reading).find("  in the file b.yaml, included at a.yaml:2:11\n  in the file a.yaml, included at table.yaml:2:11\n") != std::string::npos);
    CHECK(findings(read_with(including("a.yaml"), {{"a.yaml", "\xff"}})) == Findings{"E0102 a.yaml:1:1"});
    CHECK(findings(read_with(including("a.yaml"), {{"a.yaml", "# nothing"}})) == Findings{"E0101 a.yaml:1:1"});
    CHECK(findings(read_with(including("a.yaml"), {{"a.yaml", "[circle: {}]"}})) == Findings{"E0201 a.yaml:1:1"});
    CHECK(findings(read_with(including("a.yaml"), {{"a.yaml", "scene: [circle: {}]"}})) == Findings{"E0204 a.yaml:1:1"});
    CHECK(findings(read_with(including("a.yaml"), {{"a.yaml", "pinfield: 2"}})) == Findings{"E0205 a.yaml:1:11"});
    CHECK(findings(read_with(including("a.yaml"), {{"a.yaml", "pinfield: 1\nwalls: []"}})) == Findings{"E0202 a.yaml:2:1"});
}

TEST_CASE("what there is one of for a whole table stands in its own file") {
    const Files files{{"a.yaml", "pinfield: 1\ntable: {}\nphysics: {}\ngame: {}\ntests: []\nscene: []\n"}};
    const Reading reading = read_with(including("a.yaml"), files);
    CHECK(findings(reading) == Findings{"E0230 a.yaml:2:1", "E0230 a.yaml:3:1", "E0230 a.yaml:4:1", "E0230 a.yaml:5:1"});
}

TEST_CASE("a name that two files give is told at the later, which names the earlier") {
    const Files files{{"a.yaml",
                       "pinfield: 1\nparams: {gap: 1cm}\nmaterials: {wood: {}}\ntemplates: {gear: {nodes: []}}\ninputs: {left: Z}\n"
                       "scene: [box: {id: wall, size: [1, gap]}]\n"}};
    const std::string main =
        "pinfield: 1\ninclude: [a.yaml]\nparams: {gap: 2cm}\nmaterials: {wood: {}}\ntemplates: {gear: {nodes: []}}\ninputs: {left: Z}\n"
        "scene: [use: {template: gear, id: wall}, circle: {id: gap}]\n";
    const Reading reading = read_with(main, files);
    CHECK(findings(reading) == Findings{"E0303 table.yaml:3:10", "E0303 table.yaml:4:13", "E0303 table.yaml:5:13", "E0303 table.yaml:6:10",
                                        "E0303 table.yaml:7:35", "E0303 table.yaml:7:55"});
    std::vector<std::string> hints;
    for (const Diagnostic& found : reading.diagnostics) hints.push_back(found.hint);
    CHECK(hints == Findings{"a.yaml:2 has it", "a.yaml:3 has it", "a.yaml:4 has it", "a.yaml:5 has it", "a.yaml:6 has it", "a.yaml:2 has it"});
}

TEST_CASE("params of all files are made of each other in any order, and a circle through files is told") {
    CHECK(read_with("pinfield: 1\ninclude: [a.yaml]\nparams: {x: y / 2, z: 8cm}\nscene: [circle: {radius: x}]\n", {{"a.yaml", "pinfield: 1\nparams: {y: z / 2}"}})
              .scene.find("circle[0]")
              ->get<double>("radius") == 0.02);
    CHECK(findings(read_with("pinfield: 1\ninclude: [a.yaml]\nparams: {x: y}\nscene: [circle: {radius: x}]\n", {{"a.yaml", "pinfield: 1\nparams: {y: x}"}})) ==
          Findings{"E0227 table.yaml:3:13"});
}

TEST_CASE("what is included may hold more than the table uses") {
    const Files library{{"a.yaml", "pinfield: 1\nparams: {unused: 1}\ntemplates: {gear: {nodes: [circle: {}]}, other: {nodes: []}}\n"}};
    CHECK(read_with("pinfield: 1\ninclude: [a.yaml]\nscene: [use: {template: gear}]\n", library).diagnostics.empty());
    CHECK(findings(read_with("pinfield: 1\ninclude: [a.yaml]\n", library)) == Findings{"W0501 table.yaml:1:1"});
    CHECK(read_with("pinfield: 1\ninclude: [a.yaml]\n", {{"a.yaml", "pinfield: 1\nscene: [circle: {}]\n"}}).diagnostics.empty());
}

TEST_CASE("a list of files that is none is told as any wrong shape") {
    CHECK(findings(read_with("pinfield: 1\ninclude: a.yaml\nscene: [circle: {}]\n", {})) == Findings{"E0201 table.yaml:2:10"});
    CHECK(findings(read_with(including("{a: b}, [], '', ~"), {})) ==
          Findings{"E0201 table.yaml:2:11", "E0201 table.yaml:2:19", "E0201 table.yaml:2:23", "E0308 table.yaml:2:27"});
    CHECK(read_with("pinfield: 1\ninclude:\nscene: [circle: {}]\n", {}).diagnostics.empty());
    CHECK(read_with("pinfield: 1\ninclude: []\nscene: [circle: {}]\n", {}).diagnostics.empty());
}

TEST_CASE("a path stays below the table's folder, whoever says it") {
    CHECK(path_below("table.yaml", "parts/a.yaml") == std::string("parts/a.yaml"));
    CHECK(path_below("parts/a.yaml", "b.yaml") == std::string("parts/b.yaml"));
    CHECK(path_below("parts/a.yaml", "../b.yaml") == std::string("b.yaml"));
    CHECK(path_below("parts/sub/a.yaml", "./.././../c//d.yaml") == std::string("c/d.yaml"));
    CHECK(path_below("table.yaml", "x/../a.yaml") == std::string("a.yaml"));
    CHECK(path_below("table.yaml", "...") == std::string("..."));
    for (const char* path : {"/etc/passwd", "../a.yaml", "parts/../../a.yaml", "a\\b.yaml", "C:/a.yaml", "a\n.yaml", ".", "parts/", "parts/..", "\x7f"}) {
        INFO(path);
        CHECK_FALSE(path_below("table.yaml", path));
    }
    CHECK_FALSE(path_below("parts/a.yaml", "../../b.yaml"));
    CHECK(findings(read_with(including("/etc/passwd, ../x.yaml, parts/a.yaml"), {{"parts/a.yaml", "pinfield: 1\ninclude: [../../x.yaml]"}})) ==
          Findings{"E0232 table.yaml:2:11", "E0232 table.yaml:2:24", "E0232 parts/a.yaml:2:11"});
}

TEST_CASE("a table without a file has no folder, and fragments include nothing") {
    CHECK(findings(read(including("a.yaml"))) == Findings{"E0308 test.yaml:2:11"});
}

TEST_CASE("written, a table keeps what it includes and says none of it; expanded, it says all of it") {
    const Reading reading = read_with(main_table, parts);
    const std::string written = write_table(reading.scene);
    CHECK(written.find("include: [parts/walls.yaml, parts/lamps.yaml, \"./parts//board.yaml\"]\n") != std::string::npos);
    for (const char* other : {"left_wall", "thick:", "wood:", "lamp:", "left:"}) CHECK(written.find(other) == std::string::npos);
    const Reading back = read_with(written, parts);
    INFO(written << told(back));
    CHECK(back.diagnostics.empty());
    CHECK(same_content(back.scene, reading.scene));
    CHECK(write_table(back.scene) == written);

    const Scene flat = expanded(reading.scene);
    const std::string whole = write_table(flat);
    const Reading alone = read(whole);
    INFO(whole << told(alone));
    CHECK(alone.diagnostics.empty());
    CHECK(alone.scene.all().size() == reading.scene.all().size());
    CHECK(write_table(alone.scene).find("include") == std::string::npos);
    CHECK(whole.find("  # parts/board.yaml\n  - group:") != std::string::npos);
    CHECK(whole.find("  # parts/walls.yaml\n  - box: {id: left_wall") != std::string::npos);
    CHECK(whole.find("  # table.yaml\n  - circle: {id: own") != std::string::npos);
    CHECK(whole.find("  # parts/board.yaml\n  wood:") != std::string::npos);
}

TEST_CASE("limits count all files of a table") {
    Limits limits;
    limits.includes = 3;
    const std::string part = "pinfield: 1\nscene: [circle: {}, circle: {}]\n";
    const Files files{{"a.yaml", part}, {"b.yaml", part}, {"c.yaml", part}, {"d.yaml", part}};
    CHECK(read_with(including("a.yaml, b.yaml, c.yaml, a.yaml, ./b.yaml"), files, limits).diagnostics.empty());
    CHECK(findings(read_with(including("a.yaml, b.yaml, c.yaml, d.yaml"), files, limits)) == Findings{"E0126 table.yaml:2:35"});

    const std::string main = including("a.yaml, b.yaml");
    limits = {};
    limits.table_bytes = main.size() + 2 * part.size();
    CHECK(read_with(main, files, limits).diagnostics.empty());
    --limits.table_bytes;
    CHECK(findings(read_with(main, files, limits)) == Findings{"E0127 table.yaml:2:19"});

    limits = {};
    limits.file_bytes = part.size() + 40;
    const auto padded = [&](std::size_t more) { return Files{{"a.yaml", part + std::string(40 + more - 1, '#') + "\n"}}; };
    CHECK(read_with(including("a.yaml"), padded(0), limits).diagnostics.empty());
    CHECK(findings(read_with(including("a.yaml"), padded(1), limits)) == Findings{"E0106 table.yaml:2:11"});

    limits = {};
    limits.nodes = 5;
    CHECK(read_with(main, files, limits).diagnostics.empty());
    limits.nodes = 4;
    CHECK(findings(read_with(main, files, limits)) == Findings{"E0110 table.yaml:3:9"});

    limits = {};
    limits.params = 2;
    const Files params{{"a.yaml", "pinfield: 1\nparams: {x: 1, y: 2}\n"}};
    CHECK(read_with(including("a.yaml"), params, limits).diagnostics.empty());
    CHECK(findings(read_with("pinfield: 1\ninclude: [a.yaml]\nparams: {z: 1}\nscene: [circle: {}]\n", params, limits)) == Findings{"E0125 table.yaml:3:9"});
}

TEST_CASE("events are counted over all files, so that many files cost no more than one") {
    const std::string part = "pinfield: 1\nscene: [circle: {}]\n";  // 4 keys and values, 2 lists and maps, and 1 map within
    const Files files{{"a.yaml", part}, {"b.yaml", part}};
    Limits limits;
    for (limits.events = 1; !read_with(including("a.yaml, b.yaml"), files, limits).diagnostics.empty(); ++limits.events)
        CHECK(findings(read_with(including("a.yaml, b.yaml"), files, limits)).front().starts_with("E0108"));
    std::size_t one = 1;
    for (Limits alone; !read(part, alone = {.events = one}).diagnostics.empty();) ++one;
    std::size_t main = 1;
    for (Limits alone; !read("pinfield: 1\ninclude: [a.yaml, b.yaml]\nscene: [circle: {}]\n", alone = {.events = main}).diagnostics.front().code.starts_with("E03");) ++main;
    CHECK(limits.events == main + 2 * one);
    // Read again with a longer text of its own, too.
    const Reading full = read_with(including("a.yaml, b.yaml"), files, limits);
    CHECK(full.ok());
    CHECK(read_again(full, including("a.yaml, b.yaml") + "# longer\n", limits).ok());
    CHECK(findings(read_again(full, including("a.yaml, b.yaml") + "inputs: {}\n", limits)) == Findings{"E0108 b.yaml:2:9"});
}
