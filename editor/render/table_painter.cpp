#include "editor/render/table_painter.h"

#include <algorithm>
#include <string>
#include <utility>

#include "editor/render/shaders.h"
#include "engine/program/isolines.h"
#include "engine/program/raster_change.h"

namespace pinfield::editor {

namespace {

/// Towards the light: from the upper left of the screen.
const Vec2 world_light(-0.5547, 0.8321);
constexpr std::size_t palette_size = 64;

/// Canvas pixels of the corners of a box that lies in a frame of its own, from the box's bottom left, counter-clockwise.
void corners_on_canvas(const Box2& box, const Similarity& world_from_box, const Canvas& canvas, Vec2 (&out)[4]) {
    const Vec2 corners[4] = {box.lo, {box.hi.x(), box.lo.y()}, box.hi, {box.lo.x(), box.hi.y()}};
    for (int i = 0; i < 4; ++i) out[i] = canvas.pixel_from_world(world_from_box * corners[i]);
}

bool same_view(const Canvas& a, const Canvas& b) {
    return a.size == b.size && a.centre == b.centre && a.pixels_per_metre == b.pixels_per_metre;
}

/// How far a pixel's look depends on its neighbours, metres: the shadow's length, and as much again as rounds it up.
constexpr double shading_reach = 0.0085;

/// Box of all solids of a mover, with room for their shadow.
Box2 mover_window(const Mover& mover) {
    Box2 box = Box2::empty();
    for (const Solid& solid : mover.field.solids) box = box.merged(solid.bounds);
    const double most = 2 * std::max(mover.bounding_radius, 0.05);
    return box.intersected(Box2::centred(most, most)).grown(0.016);
}

/// Whether the movers of two programs look the same.
bool same_pictures(const Program& a, const Program& b) {
    const auto same = [](const Mover& m, const Mover& n) {
        const auto changed = changed_boxes(m.field, n.field);
        return m.bounding_radius == n.bounding_radius && changed && changed->empty();
    };
    return std::equal(a.movers.begin(), a.movers.end(), b.movers.begin(), b.movers.end(), same);
}

}  // namespace

TablePainter::TablePainter(const Gl& gl)
    : gl_(gl),
      field_shader_(gl, shaders::quad_vertex, std::string(isolines::isoline_color_source) + shaders::field_fragment),
      ball_shader_(gl, shaders::quad_vertex, shaders::ball_fragment),
      quads_(gl),
      table_(gl),
      underlay_(gl),
      kept_(gl) {}

void TablePainter::set_underlay(int width, int height, const unsigned char* rgba) {
    underlay_.upload(width, height, rgba);
    underlay_is_new_ = true;
}

void TablePainter::draw(const ProgramPtr& program, std::span<const MoverPlace> places, std::span<const BallMark> balls,
                        const TableLook& look, const Canvas& canvas) {
    const PixelBox changed = refresh_table(program, places, look.isolines, canvas);
    if (!look.isolines) refresh_movers(program, canvas.pixels_per_metre);
    keep_table(*program, changed, look, canvas);
    kept_.show(canvas.left(), canvas.bottom());
    gl_.Viewport(canvas.left(), canvas.bottom(), canvas.width(), canvas.height());
    if (!look.isolines) draw_movers(*program, places, look, canvas);
    draw_balls(balls, canvas);
}

PixelBox TablePainter::refresh_table(const ProgramPtr& program, std::span<const MoverPlace> places, bool isolines,
                                     const Canvas& canvas) {
    // Isolines of the whole field need the movers in it; shaded movers are pictures of their own, laid on top.
    std::vector<double> q;
    if (isolines)
        for (const MoverPlace& place : places) q.push_back(place.q);
    const bool same_canvas = table_program_ && same_view(canvas, table_canvas_);
    if (program == table_program_ && same_canvas && q == table_places_) return {};
    const bool without_movers = q.empty() && table_places_.empty();
    const ProgramPtr before = std::exchange(table_program_, program);
    table_canvas_ = canvas;
    table_places_ = std::move(q);

    const sdf::Isa isa = sdf::best_isa();
    if (same_canvas && without_movers && before->size == program->size) {
        const PixelBox changed = rasterize_changes(before->fixed, program->fixed, ~LayerMask{0}, isa, raster_);
        if (changed.bottom > changed.top)
            table_.upload_rows(changed.top, changed.bottom - changed.top, raster_.distance.data(), raster_.material.data());
        return changed;
    }
    raster_.width = canvas.width();
    raster_.height = canvas.height();
    raster_.window = canvas.world();
    rasterize(program->fixed, ~LayerMask{0}, isa, raster_);
    for (std::size_t i = 0; i < table_places_.size(); ++i)
        rasterize_over(program->movers[i], places[i].world_from_mover, isa, raster_);
    table_.upload(raster_.width, raster_.height, raster_.distance.data(), raster_.material.data());
    return {0, 0, raster_.width, raster_.height};
}

void TablePainter::refresh_movers(const ProgramPtr& program, double pixels_per_metre) {
    if (program == movers_program_ && pixels_per_metre == movers_scale_) return;
    const ProgramPtr before = std::exchange(movers_program_, program);
    const bool same_scale = std::exchange(movers_scale_, pixels_per_metre) == pixels_per_metre;
    if (before && same_scale && same_pictures(*before, *program)) return;
    movers_.clear();
    for (const Mover& mover : program->movers) {
        Raster raster;
        raster.window = mover_window(mover);
        const Vec2 texels = (pixels_per_metre * raster.window.size()).cwiseMin(2048.0).cwiseMax(4.0);
        raster.width = static_cast<int>(texels.x());
        raster.height = static_cast<int>(texels.y());
        rasterize(mover.field, ~LayerMask{0}, sdf::best_isa(), raster);
        MoverPicture& picture = movers_.emplace_back();
        picture.window = raster.window;
        picture.texture = std::make_unique<FieldTexture>(gl_);
        picture.texture->upload(raster.width, raster.height, raster.distance.data(), raster.material.data());
    }
}

void TablePainter::prepare(const TableLook& look, const Canvas& canvas, const FieldTexture& texture,
                           double metres_per_texel, const Vec2& light) const {
    field_shader_.use();
    field_shader_.set("canvas", canvas.size);
    field_shader_.set("distances", 0);
    field_shader_.set("materials", 1);
    std::vector<Rgb> palette = look.materials;
    palette.resize(palette_size, palette.empty() ? Rgb{} : palette.front());
    field_shader_.set("palette", palette);
    field_shader_.set("texels", Vec2(texture.width(), texture.height()));
    field_shader_.set("light", light);
    field_shader_.set("metres_per_texel", metres_per_texel);
    field_shader_.set("pixels_per_metre", canvas.pixels_per_metre);
    field_shader_.set("shadow", look.shadow);
    field_shader_.set("isolines", look.isolines ? 1 : 0);
    field_shader_.set("spacing", isolines::spacing(1 / canvas.pixels_per_metre));
    texture.bind();
}

void TablePainter::keep_table(const Program& program, PixelBox changed, const TableLook& look, const Canvas& canvas) {
    if (std::exchange(underlay_is_new_, false) || !(look == kept_look_)) changed = {0, 0, canvas.width(), canvas.height()};
    if (changed.left >= changed.right) return;
    kept_look_ = look;
    kept_.begin(canvas.width(), canvas.height());
    const int margin = 3 + static_cast<int>(shading_reach * canvas.pixels_per_metre);
    const int left = changed.left - margin, bottom = canvas.height() - changed.bottom - margin;
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.Scissor(left, bottom, changed.right - changed.left + 2 * margin, changed.bottom - changed.top + 2 * margin);
    draw_table(program, look, canvas);
    gl_.Disable(GL_SCISSOR_TEST);
    kept_.end();
}

void TablePainter::draw_table(const Program& program, const TableLook& look, const Canvas& canvas) {
    prepare(look, canvas, table_, 1 / canvas.pixels_per_metre, world_light);
    const Box2 world = canvas.world();
    field_shader_.set("world_corner", Vec2(world.lo.x(), world.hi.y()));
    field_shader_.set("table", program.size);
    field_shader_.set("floor_low", look.floor_low, 1);
    field_shader_.set("floor_high", look.floor_high, 1);
    field_shader_.set("backdrop", look.backdrop, 1);
    field_shader_.set("rim", look.rim, 1);
    field_shader_.set("mover", 0);
    set_underlay_look(look.underlay);
    gl_.Disable(GL_BLEND);
    quads_.clear();
    const double w = canvas.size.x(), h = canvas.size.y();
    quads_.add({{0, h}, {w, h}, {w, 0}, {0, 0}}, {0, 1}, {1, 0});  // texture row 0 is the top
    quads_.draw();
}

void TablePainter::set_underlay_look(const UnderlayLook& underlay) const {
    constexpr int unit = 2;
    field_shader_.set("underlay", unit);
    underlay_.bind(unit);
    field_shader_.set("underlay_corner", underlay.corner);
    field_shader_.set("underlay_size", underlay.size);
    field_shader_.set("underlay_turns", underlay.quarter_turns);
    field_shader_.set("underlay_opacity", underlay.opacity);
    field_shader_.set("underlay_over", underlay.over ? 1 : 0);
}

void TablePainter::draw_movers(const Program& program, std::span<const MoverPlace> places, const TableLook& look, const Canvas& canvas) {
    gl_.Enable(GL_BLEND);
    gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (std::size_t i = 0; i < movers_.size() && i < places.size(); ++i) {
        const MoverPicture& picture = movers_[i];
        const Similarity& world_from_mover = places[i].world_from_mover;
        const double metres_per_texel = picture.window.size().x() / picture.texture->width();
        prepare(look, canvas, *picture.texture, metres_per_texel, world_from_mover.inverse().direction(world_light));
        field_shader_.set("mover", 1);
        field_shader_.set("world_corner", Vec2(canvas.world().lo.x(), canvas.world().hi.y()));
        field_shader_.set("table", program.size);
        Vec2 corners[4];
        corners_on_canvas(picture.window, world_from_mover, canvas, corners);
        quads_.clear();
        quads_.add(corners, {0, 1}, {1, 0});
        quads_.draw();
    }
}

void TablePainter::draw_balls(std::span<const BallMark> balls, const Canvas& canvas) {
    gl_.Enable(GL_BLEND);
    gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    ball_shader_.use();
    ball_shader_.set("canvas", canvas.size);
    const auto add = [&](const Vec2& centre, double reach, double extra) {
        const Vec2 c = canvas.pixel_from_world(centre);
        quads_.add({{c.x() - reach, c.y() + reach},
                    {c.x() + reach, c.y() + reach},
                    {c.x() + reach, c.y() - reach},
                    {c.x() - reach, c.y() - reach}},
                   {-1, -1}, {1, 1}, extra);
    };
    for (const bool shadows : {true, false}) {
        for (const BallMark& ball : balls) {
            quads_.clear();
            ball_shader_.set("ghost", ball.ghost);
            const double r = ball.radius * canvas.pixels_per_metre;
            // One pixel wider than the ball, so that its rim can fade; `at` then runs a little beyond 1.
            if (shadows) add(ball.centre - 0.45 * ball.radius * world_light, 1.25 * r, 0);
            else add(ball.centre, r, r);
            quads_.draw();
        }
    }
}

}  // namespace pinfield::editor
