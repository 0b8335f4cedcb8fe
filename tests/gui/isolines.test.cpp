// The window's isolines are those of `pinfield render`. Needs a display.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "editor/platform/window.h"
#include "editor/render/table_painter.h"
#include "engine/core/at.h"
#include "engine/io/load_table.h"
#include "engine/program/compile.h"
#include "engine/program/isolines.h"
#include "engine/program/pose.h"
#include "engine/program/raster.h"
#include "engine/scene/catalog.h"
#include "tests/places.h"

using namespace pinfield;
using namespace pinfield::editor;

namespace {

ProgramPtr load(const std::string& name) {
    const std::string path = std::string(test::source_dir()) + "/scenes/tables/" + name;
    return compile(load_table(path, std::make_shared<const Catalog>(built_in_catalog())).value().scene).value();
}

std::vector<MoverPlace> some_places(const Program& program) {
    std::vector<MoverPlace> places;
    for (const Mover& mover : program.movers) {
        const double q = mover.slides ? -0.01 : 0.3;
        places.push_back({q, world_from_mover(mover, q)});
    }
    return places;
}

/// What `pinfield render --mode isolines` would write of the part of the world that the canvas shows.
std::vector<unsigned char> picture_of(const Program& program, const Canvas& canvas) {
    Raster raster{static_cast<int>(canvas.size.x()), static_cast<int>(canvas.size.y()), canvas.world(), {}, {}};
    rasterize(program.fixed, ~LayerMask{0}, sdf::best_isa(), raster);
    const auto places = some_places(program);
    for (std::size_t i = 0; i < places.size(); ++i)
        rasterize_over(program.movers[i], places[i].world_from_mover, sdf::best_isa(), raster);
    return isoline_picture(raster, isolines::spacing(raster.metres_per_pixel()));
}

std::vector<unsigned char> window_of(const Window& window, const ProgramPtr& program, const Canvas& canvas) {
    TablePainter painter(window.gl());
    TableLook look;
    look.isolines = true;
    window.gl().Viewport(0, 0, static_cast<int>(canvas.size.x()), static_cast<int>(canvas.size.y()));
    painter.draw(program, some_places(*program), {}, look, canvas);
    int width = 0, height = 0;
    return window.read_pixels(width, height);
}

}  // namespace

TEST_CASE("within the table the window draws the isolines that render draws") {
    const auto opened = Window::open("isolines", 420, 840);
    REQUIRE(opened);
    const Window& window = **opened;
    for (const char* name : {"first_table.yaml", "gallery.yaml"}) {
        const ProgramPtr program = load(name);
        const double whole = 0.99 * window.framebuffer().y() / program->size.y();
        for (const double pixels_per_metre : {whole, 3 * whole, 40 * whole}) {
            const Canvas canvas{window.framebuffer(), {0, 0}, window.framebuffer(), 0.5 * program->size, pixels_per_metre};
            INFO(name << " at " << pixels_per_metre << " pixels a metre");
            const auto expected = picture_of(*program, canvas), drawn = window_of(window, program, canvas);
            REQUIRE(drawn.size() == expected.size());
            const int width = static_cast<int>(canvas.size.x());
            int worst = 0, compared = 0;
            for (int i = 0; i < static_cast<int>(drawn.size()); ++i) {
                const Vec2 from_corner(i / 3 % width + 0.5, -(i / 3 / width + 0.5));
                const Vec2 world = Vec2(canvas.world().lo.x(), canvas.world().hi.y()) + from_corner / pixels_per_metre;
                if (!Box2::of({0, 0}, program->size).contains(world)) continue;  // the window fades what lies beyond
                worst = std::max(worst, std::abs(at(drawn, i) - at(expected, i)));
                ++compared;
            }
            CHECK(worst <= 1);
            CHECK(compared > 300'000);
        }
    }
}
