#include <array>
#include <catch2/catch.hpp>
#include <memory>

#include "engine/io/same_content.h"
#include "engine/core/at.h"
#include "engine/io/json_schema.h"
#include "engine/io/node_reference.h"
#include "engine/io/table_reader.h"
#include "engine/io/text_patch.h"
#include "engine/io/write_table.h"
#include "engine/physics/world.h"
#include "engine/program/compile.h"
#include "engine/program/evaluate.h"
#include "engine/program/patch.h"
#include "engine/program/raster.h"
#include "tests/conformance/check.h"
#include "tests/conformance/spectacles.h"

namespace pinfield::conformance {

TEST_CASE("a shape that a program adds of its own goes through every law") {
    CHECK(check<sdf::Spectacles>());
}

namespace {

using test::catalog_with_spectacles;

struct Loaded {
    Reading read = read_table(std::make_shared<SourceText>("spectacles.yaml", test::spectacles_table), catalog_with_spectacles());
};

}  // namespace

TEST_CASE("a shape that a program adds of its own is read, refused, written, described and patched like any other") {
    const Loaded loaded;
    REQUIRE(loaded.read.diagnostics.empty());
    const Scene& scene = loaded.read.scene;
    const Node* node = scene.find("nose");
    REQUIRE(node);
    CHECK(node->get<double>("gap") == 0.014);

    const auto wrong = std::make_shared<SourceText>("wrong.yaml", "pinfield: 1\nscene:\n  - spectacles: {radius: 0, gpa: 1}\n");
    CHECK(read_table(wrong, catalog_with_spectacles()).diagnostics.size() == 2);

    const auto again = std::make_shared<SourceText>("again.yaml", write_table(scene));
    CHECK(same_content(read_table(again, catalog_with_spectacles()).scene, scene));
    CHECK(json_schema(scene.catalog()).find("\"spectacles\"") != std::string::npos);
    CHECK(reference_json(referenced_types(scene.catalog(), "spectacles")).find("Of each disc.") != std::string::npos);

    const Edit edit = SetField{node->id, *node->type->find_field("gap"), 0.016, true};
    const auto patched = patch_for(loaded.read, std::span(&edit, 1));
    REQUIRE(patched);
    CHECK(patched->reading.source().text() ==
          "pinfield: 1\ntable: {size: [0.2, 0.2]}\nscene:\n"
          "  - spectacles: {id: nose, at: [0.1, 0.1], radius: 18mm, gap: 16mm}  # kept\n");
}

TEST_CASE("a shape that a program adds of its own is drawn, patched live and collided with") {
    Loaded loaded;
    Scene& scene = loaded.read.scene;
    const auto program = compile(scene);
    REQUIRE(program);
    // Its discs are 25 mm left and right of the middle: 14 mm of air remain between them, half on each side.
    CHECK(nearest((*program)->fixed, {0.1, 0.1}).distance == Approx(0.007));
    CHECK(nearest((*program)->fixed, {0.125, 0.1}).distance == Approx(-0.018));

    Raster raster{64, 64, {{0, 0}, {0.2, 0.2}}, {}, {}};
    rasterize((*program)->fixed, ground_layer, sdf::best_isa(), raster);
    const auto distance = [&](double x, double y) {
        return at(raster.distance, 64 * static_cast<int>(64 * (1 - y / 0.2)) + static_cast<int>(64 * x / 0.2));
    };
    CHECK(distance(0.125, 0.1) < -0.015f);
    CHECK(distance(0.101, 0.1) > 0.0f);

    World world(*program);
    const BallId ball = world.add_ball({0.125, 0.17}, {0, -2});
    bool hit = false;
    for (int tick = 0; tick < 200; ++tick) {
        world.step();
        for (const Event& event : world.events()) hit = hit || (event.kind == EventKind::hit && event.node == scene.find("nose")->id);
        CHECK(gap_at(world, world.find(ball)->position).distance > 0.0135 - 1e-6);
    }
    CHECK(hit);

    const NodeId nose = scene.find("nose")->id;
    const int gap = *scene.find(nose)->type->find_field("gap");
    apply(scene, SetField{nose, gap, 0.05, true});
    const ProgramPtr patched = patch(**program, scene, std::array{FieldChange{nose, gap}});
    REQUIRE(patched);
    CHECK(nearest(patched->fixed, {0.1, 0.1}).distance == Approx(0.025));
}

}  // namespace pinfield::conformance
