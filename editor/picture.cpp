#include "editor/picture.h"

#include <algorithm>
#include <cmath>

#include "editor/structure_tools.h"
#include "engine/core/at.h"
#include "engine/core/trig.h"
#include "engine/physics/mechanisms/mechanism.h"
#include "engine/program/compile.h"
#include "engine/scene/parts/spawn.h"
#include "engine/sdf/piece.h"

namespace pinfield::editor {
namespace {

constexpr double tiny = 1e-9;       ///< metres: pieces that meet
constexpr double per_chord = 0.25;  ///< radians

class Drawing {
public:
    /// `frame`: beyond it nothing is drawn.
    explicit Drawing(const Box2& frame) : frame_(frame) {}

    void add(const Field& field, const Similarity& world_from_field, NodeId left_out) {
        for (const Solid& solid : field.solids) {
            if (solid.origin == left_out) continue;
            for (int i = 0; i < solid.piece_count; ++i)
                add(sdf::transformed(world_from_field, at(field.pieces, solid.first_piece + i).piece));
        }
    }
    void add(const sdf::Piece& piece) {
        const double turn = piece.is_arc() ? sdf::bounds_of(piece).size().norm() / piece.radius : 0;
        const int chords = piece.is_arc() ? std::clamp(static_cast<int>(std::ceil(2 * turn / per_chord)), 2, 32) : 1;
        for (int i = 0; i < chords; ++i) {
            const double from = static_cast<double>(i) / chords, to = static_cast<double>(i + 1) / chords;
            chord(sdf::point_at_share(piece, from), sdf::point_at_share(piece, to));
        }
    }
    Picture finished() {
        for (const auto& line : picture_.lines)
            for (const Vec2& p : line) picture_.box = picture_.box.merged({p, p});
        return std::move(picture_);
    }

private:
    void chord(const Vec2& a, const Vec2& b) {
        if (!frame_.contains(a) || !frame_.contains(b)) return;
        if (picture_.lines.empty() || length(picture_.lines.back().back() - a) > tiny) picture_.lines.push_back({a});
        picture_.lines.back().push_back(b);
    }

    Box2 frame_;
    Picture picture_;
};

Picture drawn(const Scene& scene, const Box2& frame, NodeId left_out) {
    const auto program = compile(scene);
    Drawing drawing(frame);
    if (!program) return drawing.finished();
    const Program& p = **program;
    drawing.add(p.fixed, {}, left_out);
    for (std::size_t i = 0; i < p.movers.size(); ++i) drawing.add(p.movers[i].field, world_from_resting_mover(p, static_cast<int>(i)), {});
    for (const Sensor& sensor : p.sensors) drawing.add(sensor.field, {}, {});
    for (const Part& part : p.parts)
        if (part.is<parts::Spawn>()) drawing.add(sdf::Piece::circle(part.world_from_part.offset, p.physics.ball_radius));
    return drawing.finished();
}

}  // namespace

Picture picture_of(const Scene& scene) {
    const Vec2 size = scene.table().get<Vec2>("size");
    return drawn(scene, Box2{{0, 0}, size}.grown(0.02 * size.norm()), {});
}

Picture picture_of(const std::shared_ptr<const Catalog>& catalog, const NodeType& type) {
    Scene scene(catalog);
    scene.put(scene.with_new_ids(new_nodes(catalog, type)), {}, 0);
    constexpr double reach = 0.25;
    return drawn(scene, {{-reach, -reach}, {reach, reach}}, scene.table().id);
}

}  // namespace pinfield::editor
