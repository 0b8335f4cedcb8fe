// The table's frame in the window. Needs a display.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "editor/platform/window.h"
#include "editor/render/table_painter.h"
#include "engine/core/at.h"
#include "engine/io/load_table.h"
#include "engine/program/compile.h"
#include "engine/program/pose.h"
#include "engine/scene/catalog.h"
#include "tests/places.h"

using namespace pinfield;
using namespace pinfield::editor;

namespace {

std::vector<unsigned char> window_of(const Window& window, const ProgramPtr& program, double slid, const Canvas& canvas) {
    std::vector<MoverPlace> places;
    for (const Mover& mover : program->movers) {
        const double q = mover.slides ? slid : 0;
        places.push_back({q, world_from_mover(mover, q)});
    }
    TablePainter painter(window.gl());
    TableLook look;
    look.materials = {Rgb{0.9f, 0.9f, 0.9f}};
    look.floor_low = look.floor_high = Rgb{0.1f, 0.1f, 0.4f};
    painter.draw(program, places, {}, look, canvas);
    int width = 0, height = 0;
    return window.read_pixels(width, height);
}

}  // namespace

TEST_CASE("what slides out of the table goes under its frame") {
    const auto opened = Window::open("frame", 420, 840);
    REQUIRE(opened);
    const Window& window = **opened;
    const std::string path = std::string(test::source_dir()) + "/scenes/tables/first_table.yaml";
    const ProgramPtr program = compile(load_table(path, std::make_shared<const Catalog>(built_in_catalog())).value().scene).value();
    const Canvas canvas{
        window.framebuffer(), {0, 0}, window.framebuffer(), 0.5 * program->size, 0.9 * window.framebuffer().y() / program->size.y()};
    const auto at_rest = window_of(window, program, 0, canvas), pulled = window_of(window, program, -0.05, canvas);
    REQUIRE(at_rest.size() == pulled.size());
    const Box2 table = Box2::of({0, 0}, program->size);
    int within = 0, outside = 0;
    for (int i = 0; i < static_cast<int>(at_rest.size()); ++i) {
        if (at(at_rest, i) == at(pulled, i)) continue;
        const Vec2 from_corner(i / 3 % static_cast<int>(canvas.size.x()) + 0.5, -(i / 3 / static_cast<int>(canvas.size.x()) + 0.5));
        const Vec2 world = Vec2(canvas.world().lo.x(), canvas.world().hi.y()) + from_corner / canvas.pixels_per_metre;
        (table.distance(world) > 1 / canvas.pixels_per_metre ? outside : within) += 1;
    }
    CHECK(within > 300);
    CHECK(outside == 0);
}
