// scenes/tables/gallery.yaml keeps its promises: everything is shown, nothing is crowded, and a visit does no harm; and formulas.yaml.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <memory>
#include <set>
#include <string>

#include "engine/core/at.h"
#include "engine/game/simulation.h"
#include "engine/io/load_table.h"
#include "engine/physics/scatter.h"
#include "engine/program/compile.h"
#include "engine/program/evaluate.h"
#include "engine/scene/catalog.h"
#include "tests/places.h"

namespace pinfield::conformance {
namespace {

struct Gallery {
    Scene scene;
    ProgramPtr program;

    /// Exhibits are what hangs in the groups.
    bool is_exhibit(const Solid& solid) const {
        const Node* node = scene.find(solid.origin);
        const Node* parent = node ? scene.find(node->parent) : nullptr;
        return parent && parent->type->key() == "group";
    }
};

Gallery open_gallery(const std::string& name = "gallery") {
    const auto catalog = std::make_shared<const Catalog>(built_in_catalog());
    const Result<Reading> table = load_table(fmt::format("{}/scenes/tables/{}.yaml", test::source_dir(), name), catalog);
    REQUIRE(table.has_value());
    for (const Diagnostic& diagnostic : table->diagnostics) FAIL_CHECK(format(diagnostic, table->scene.sources));
    const auto program = compile(table->scene);
    REQUIRE(program.has_value());
    return {table->scene, *program};
}

}  // namespace

TEST_CASE("the gallery shows every shape and every operation") {
    const Gallery gallery = open_gallery();
    std::set<std::string_view> shown;
    for (const NodeId id : gallery.scene.all()) shown.insert(gallery.scene.find(id)->type->key());
    for (const NodeType& type : gallery.scene.catalog().types()) {
        INFO(type.key());
        if (type.meta.kind == NodeKind::shape || type.meta.kind == NodeKind::operation) CHECK(shown.count(type.key()) == 1);
    }
}

TEST_CASE("ten formulas stand on their table, and the outline of each was found") {
    const Gallery gallery = open_gallery("formulas");
    int formulas = 0;
    for (const Solid& solid : gallery.program->fixed.solids) {
        if (gallery.scene.find(solid.origin)->type->key() != "formula") continue;
        ++formulas;
        CHECK(solid.lowered);
        CHECK(solid.fit_error > 0);
    }
    CHECK(formulas == 10);
}

/// From any point between two solids the distances to both add up to no less than the gap; over a fine grid the least sum is the gap.
TEST_CASE("between any two exhibits of the gallery there is room for a ball, and for one along the walls") {
    const Gallery gallery = open_gallery();
    const Field& field = gallery.program->fixed;
    std::vector<int> hung;
    for (std::size_t i = 0; i < field.solids.size(); ++i)
        if (gallery.is_exhibit(field.solids[i]) || field.solids[i].is_domain) hung.push_back(static_cast<int>(i));
    REQUIRE(hung.size() == 78);  // 74 nodes, 3 bumpers, the room
    const double ball = 2 * gallery.program->physics.ball_radius, step = 0.004;
    double least = infinity;
    std::string where;
    for (double y = 0.25; y < gallery.program->size.y(); y += step) {
        for (double x = 0; x < gallery.program->size.x(); x += step) {
            double first = infinity, second = infinity;
            for (const int solid : hung) {
                const Solid& s = at(field.solids, solid);
                if (!s.is_domain && s.bounds.distance({x, y}) > 2 * ball) continue;
                const double d = nearest_of_solid(field, solid, {x, y}).distance;
                second = std::min(second, std::max(first, d));
                first = std::min(first, d);
            }
            if (first < 0 || first + second >= least) continue;
            least = first + second;
            where = fmt::format("{} m at ({}, {})", least, x, y);
        }
    }
    INFO(where);
    CHECK(least > ball);
    CHECK(least < 2 * ball);  // else nothing was measured
}

TEST_CASE("twenty balls that walk the gallery, or among the formulas, pass through no exhibit") {
    const auto name = GENERATE("gallery", "formulas");
    const Gallery gallery = open_gallery(name);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        WorldOptions how;
        how.seed = seed;
        World world(gallery.program, how);
        REQUIRE(scatter_balls(world, 20, 2, seed) == 20);
        Game game(std::move(world));
        const SimulationSummary summary = simulate(game, {.seconds = 4, .audit = true, .inputs = {}});
        CHECK(summary.finite);
        CHECK(summary.escaped == 0);
        CHECK(summary.max_penetration < 1e-6);
        REQUIRE(summary.audit);
        CHECK(summary.audit->crossings == 0);
        CHECK(summary.audit->worst_depth < 1e-6);
        CHECK(at(summary.events, EventKind::hit) > 100);
    }
}

}  // namespace pinfield::conformance
