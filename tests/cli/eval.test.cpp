#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>

#include "tests/cli/run.h"

using namespace pinfield::cli_test;

namespace {

struct Row {
    double x, y, distance, grad_x, grad_y;
    std::string node;
    bool certified;
};

std::vector<Row> rows_of(const std::string& csv) {
    const std::vector<std::string> lines = lines_of(csv);
    REQUIRE_FALSE(lines.empty());
    REQUIRE(lines[0] == "x,y,distance,grad_x,grad_y,node,certified");
    std::vector<Row> rows;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        Row row{};
        REQUIRE(std::sscanf(lines[i].c_str(), "%lf,%lf,%lf,%lf,%lf", &row.x, &row.y, &row.distance, &row.grad_x, &row.grad_y) == 5);
        const std::size_t last = lines[i].rfind(','), node = lines[i].rfind(',', last - 1) + 1;
        row.node = lines[i].substr(node, last - node);
        row.certified = lines[i].substr(last + 1) == "1";
        REQUIRE((row.certified || lines[i].substr(last + 1) == "0"));
        rows.push_back(row);
    }
    return rows;
}

std::vector<Row> eval(const std::string& scene, const std::string& points, const std::string& flags = "") {
    const Scratch scratch;
    const std::string table = scratch.write("t.yaml", "pinfield: 1\ntable: {size: [1, 1]}\n" + scene);
    const Outcome outcome = run_pinfield("eval " + table + " --points " + scratch.write("p.csv", "x,y\n" + points) + " " + flags);
    INFO(outcome.err);
    REQUIRE(outcome.exit == 0);
    return rows_of(outcome.out);
}

}  // namespace

TEST_CASE("eval gives the closed form of a circle, its gradient and its id") {
    const std::vector<Row> rows =
        eval("scene:\n  - circle: {id: disc, radius: 100mm, at: [0.5, 0.5]}\n", "0.8,0.9\n0.5,0.55\n0.5,0.6\n", "--shapes-only");
    REQUIRE(rows.size() == 3);
    CHECK(rows[0].distance == Approx(0.4).epsilon(1e-15));
    CHECK(rows[0].grad_x == Approx(0.6).epsilon(1e-15));
    CHECK(rows[0].grad_y == Approx(0.8).epsilon(1e-15));
    CHECK(rows[0].node == "disc");
    CHECK(rows[1].distance == Approx(-0.05).epsilon(1e-14));
    CHECK(std::abs(rows[2].distance) < 1e-16);
    CHECK(rows[2].grad_y == Approx(1));
}

TEST_CASE("a point so far out that no formula can tell its distance is refused, with its line") {
    const Scratch scratch;
    const std::string table = scratch.write("t.yaml", "pinfield: 1\nscene:\n  - circle: {}\n  - ellipse: {}\n");
    const auto outcome_of = [&](const std::string& point) {
        return run_pinfield("eval " + table + " --points " + scratch.write("p.csv", "x,y\n0,0\n" + point + "\n"));
    };
    CHECK(outcome_of("1e50,-1e50").exit == 0);
    CHECK(outcome_of("1e50,-1e50").out.find("inf") == std::string::npos);
    for (const char* point : {"1e155,0", "0,-1e51"}) {
        CHECK(outcome_of(point).exit == 3);
        CHECK_THAT(outcome_of(point).err, Catch::Contains("p.csv:3: "));
    }
}

TEST_CASE("a table without a domain node has its size as the domain, and --shapes-only leaves it out") {
    const std::string scene = "scene:\n  - circle: {id: disc, radius: 100mm, at: [0.5, 0.5]}\n";
    const std::vector<Row> all = eval(scene, "0.5,0.03\n0.5,-0.25\n0.5,0.35\n");
    CHECK(all[0].distance == Approx(0.03).epsilon(1e-12));
    CHECK(all[0].grad_y == Approx(1));
    CHECK(all[1].distance == Approx(-0.25).epsilon(1e-12));
    CHECK(all[2].node == "disc");
    const std::vector<Row> shapes = eval(scene, "0.5,0.03\n", "--shapes-only");
    CHECK(shapes[0].distance == Approx(0.37).epsilon(1e-12));
}

TEST_CASE("a path names what has no id, and the winning leaf answers inside a difference") {
    const std::vector<Row> rows = eval(
        "scene:\n  - difference:\n      children:\n        - box: {size: [0.4, 0.4], at: [0.5, 0.5]}\n"
        "        - circle: {id: bite, radius: 0.1, at: [0.5, 0.5]}\n",
        "0.8,0.5\n0.5,0.53\n", "--shapes-only");
    CHECK(rows[0].distance == Approx(0.1).epsilon(1e-12));
    CHECK_THAT(rows[0].node, Catch::Contains("box[0]"));
    CHECK(rows[1].distance == Approx(0.07).epsilon(1e-12));
    CHECK(rows[1].node == "bite");
}

TEST_CASE("flippers and plungers stand at rest, sensors are no obstacle") {
    const std::vector<Row> rows = eval(
        "scene:\n  - flipper: {id: bat, at: [0.3, 0.5], rest: -90, swing: 60}\n  - drain: {at: [0.7, 0.5], size: [0.1, 0.1]}\n  - spawn: "
        "{at: [0.7, 0.8]}\n",
        "0.3,0.6\n0.3,0.4\n0.7,0.5\n", "--shapes-only");
    CHECK(rows[0].distance == Approx(0.1 - 0.0116).epsilon(1e-12));
    CHECK(rows[0].node == "bat");
    CHECK(rows[1].distance == Approx(0.03 - 0.007).epsilon(1e-12));
    CHECK(rows[2].distance > 0.3);
}

TEST_CASE("eval certifies a true distance and nothing else: of solids that overlap, abut or are uncovered, and of movers over them") {
    // Two boxes side by side, [0.2, 0.4] and [0.4, 0.6], and a bat that hangs over the right one's middle.
    const std::string boxes =
        "scene:\n  - box: {id: left, size: [0.2, 0.2], at: [0.3, 0.5]}\n  - box: {id: right, size: [0.2, 0.2], at: [0.5, 0.5]}\n";
    const std::string bat = "  - flipper: {id: bat, at: [0.52, 0.55], rest: 0, swing: 60, length: 100mm}\n";
    struct Case {
        const char* what;
        std::string scene, point;
        bool certified;
    };
    const std::vector<Case> cases = {
        {"in the open", boxes, "0.5,0.8", true},
        {"the shortest way out is up", boxes, "0.3,0.57", true},
        {"the shortest way out leads into the neighbour", boxes, "0.37,0.5", false},
        {"on the shared edge", boxes, "0.4,0.5", false},
        {"on the outline", boxes, "0.3,0.6", true},
        {"near the outline, with the domain's floor far away", boxes, "0.3,0.6000001", true},
        {"the way out to the right is free", boxes, "0.57,0.55", true},
        {"the way out to the right is under the bat", boxes + bat, "0.57,0.55", false},
        {"within the bat and the box, where the way up is free", boxes + bat, "0.53,0.55", true},
        {"the bat alone", boxes + bat, "0.618,0.55", true},
        {"left of both, by the left box", boxes + bat, "0.1,0.5", true},
        {"where a blend acts",
         "scene:\n  - smooth_union: {k: 50mm, children: [circle: {radius: 0.1, at: [0.4, 0.5]}, circle: {radius: 0.1, at: [0.6, 0.5]}]}\n",
         "0.5,0.8", false},
        {"far from where a blend acts",
         "scene:\n  - smooth_union: {k: 10mm, children: [circle: {radius: 0.1, at: [0.4, 0.5]}, circle: {radius: 0.1, at: [0.6, 0.5]}]}\n",
         "0.2,0.5", true},
    };
    for (const Case& c : cases) {
        INFO(c.what);
        for (const char* flags : {"", "--shapes-only"}) CHECK(eval(c.scene, c.point + "\n", flags)[0].certified == c.certified);
    }
}

TEST_CASE("eval prints enough digits that nothing is lost, and writes the same to a file") {
    const Scratch scratch;
    const std::string table = scratch.write("t.yaml", "pinfield: 1\nscene:\n  - circle: {radius: 10mm, at: [0.1, 0.1]}\n");
    const std::string points = scratch.write("p.csv", "x,y\n0.1234567890123456789,0.3\n");
    const Outcome printed = run_pinfield("eval " + table + " --shapes-only --points " + points);
    const Outcome written = run_pinfield("eval " + table + " --shapes-only --points " + points + " -o " + (scratch / "o.csv"));
    REQUIRE(printed.exit == 0);
    REQUIRE(written.exit == 0);
    CHECK(written.out.empty());
    CHECK(slurp(scratch / "o.csv") == printed.out);
    const Row row = rows_of(printed.out)[0];
    CHECK(row.x == 0.1234567890123456789);
    const double dx = row.x - 0.1, dy = 0.3 - 0.1;
    CHECK(row.distance == Approx(std::sqrt(dx * dx + dy * dy) - 0.01).epsilon(2e-16 * 8));
}

TEST_CASE("a table of points must be one") {
    const Scratch scratch;
    for (const char* text : {"", "0,0\n", "x;y\n", "x,y\n1\n", "x,y\n1,2,3\n", "x,y\n1,two\n", "x,y\n1,nan\n"}) {
        INFO(text);
        const Outcome outcome = run_pinfield("eval " + first_table + " --points " + scratch.write("p.csv", text));
        CHECK(outcome.exit == 3);
        CHECK_THAT(outcome.err, Catch::Contains("p.csv:"));
    }
    const Outcome relaxed =
        run_pinfield("eval " + first_table + " --points " + scratch.write("p.csv", "\xEF\xBB\xBFx, y\r\n 0.2 , 0.3\r\n\r\n"));
    CHECK(relaxed.exit == 0);
    CHECK(lines_of(relaxed.out).size() == 2);
}
