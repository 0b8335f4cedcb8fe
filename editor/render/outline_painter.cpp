#include "editor/render/outline_painter.h"

#include <algorithm>

#include "editor/render/shaders.h"
#include "engine/core/at.h"
#include "engine/program/evaluate.h"

namespace pinfield::editor {

namespace {

/// The op that stands for a node: the last one compiled from it, for its tree is post-order. -1: none.
int op_of(const Field& field, NodeId node) {
    for (int i = static_cast<int>(field.ops.size()) - 1; i >= 0; --i)
        if (at(field.ops, i).origin == node) return i;
    return -1;
}

/// Calls visit(field, mover index or -1) for every field of a program, sensors included.
template <class Visit>
void for_fields(const Program& program, Visit visit) {
    visit(program.fixed, -1);
    for (std::size_t i = 0; i < program.movers.size(); ++i) visit(program.movers[i].field, static_cast<int>(i));
    for (const Sensor& sensor : program.sensors) visit(sensor.field, -1);
}

constexpr double margin_pixels = 4;

}  // namespace

OutlinePainter::OutlinePainter(const Gl& gl)
    : gl_(gl), shader_(gl, shaders::quad_vertex, shaders::outline_fragment), quads_(gl) {}

void OutlinePainter::add_picture(std::vector<Picture>& out, const Field& field, NodeId node, int mover, const Canvas& canvas) {
    const int op = op_of(field, node);
    if (op < 0) return;
    const double margin = margin_pixels / canvas.pixels_per_metre;
    Box2 window = at(field.ops, op).bounds.grown(margin);
    if (mover < 0) window = window.intersected(canvas.world().grown(margin));
    if (window.is_empty() || !window.is_finite()) return;

    // Every second pixel is enough: the field is smooth but at its edges, and the shader interpolates.
    const Vec2 texels = (0.5 * canvas.pixels_per_metre * window.size()).cwiseMin(420.0).cwiseMax(24.0);
    const int width = static_cast<int>(texels.x()), height = static_cast<int>(texels.y());
    std::vector<float> distance;
    distance.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const Vec2 step = window.size().cwiseQuotient(Vec2(width, height));
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const Vec2 p(window.lo.x() + (column + 0.5) * step.x(), window.hi.y() - (row + 0.5) * step.y());
            distance.push_back(static_cast<float>(evaluate_tree(field, op, p).value));
        }
    Picture& picture = out.emplace_back();
    picture.window = window;
    picture.mover = mover;
    picture.texture = std::make_unique<FieldTexture>(gl_);
    picture.texture->upload(width, height, distance.data(), nullptr);
}

const std::vector<OutlinePainter::Picture>& OutlinePainter::pictures_of(const ProgramPtr& program, NodeId node,
                                                                        const Canvas& canvas) {
    const bool same = program == program_ && canvas.size == canvas_.size && canvas.centre == canvas_.centre &&
                      canvas.pixels_per_metre == canvas_.pixels_per_metre;
    if (!same) {
        pictures_.clear();
        program_ = program;
        canvas_ = canvas;
    }
    const auto [place, is_new] = pictures_.try_emplace(node);
    if (is_new)
        for_fields(*program, [&](const Field& field, int mover) { add_picture(place->second, field, node, mover, canvas); });
    return place->second;
}

bool OutlinePainter::draw(const ProgramPtr& program, std::span<const MoverPlace> places, NodeId node,
                          const OutlineStyle& style, const Canvas& canvas) {
    const std::vector<Picture>& pictures = pictures_of(program, node, canvas);
    gl_.Enable(GL_BLEND);
    gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    shader_.use();
    shader_.set("canvas", canvas.size);
    shader_.set("distances", 0);
    shader_.set("pixels_per_metre", canvas.pixels_per_metre);
    shader_.set("line", style.color, style.alpha);
    shader_.set("width", style.width);
    shader_.set("fill", style.fill);
    shader_.set("hatch", style.hatch);
    for (const Picture& picture : pictures) {
        const auto mover = static_cast<std::size_t>(std::max(picture.mover, 0));
        if (picture.mover >= 0 && mover >= places.size()) continue;
        const Similarity world_from_picture = picture.mover < 0 ? Similarity{} : places[mover].world_from_mover;
        const Box2& box = picture.window;
        const Vec2 corners[4] = {canvas.pixel_from_world(world_from_picture * box.lo),
                                 canvas.pixel_from_world(world_from_picture * Vec2(box.hi.x(), box.lo.y())),
                                 canvas.pixel_from_world(world_from_picture * box.hi),
                                 canvas.pixel_from_world(world_from_picture * Vec2(box.lo.x(), box.hi.y()))};
        picture.texture->bind();
        quads_.clear();
        quads_.add(corners, {0, 1}, {1, 0});
        quads_.draw();
    }
    return !pictures.empty();
}

}  // namespace pinfield::editor
