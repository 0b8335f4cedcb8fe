#include "editor/picture.h"

#include <algorithm>
#include <cmath>

#include "editor/structure_tools.h"
#include "engine/core/at.h"
#include "engine/core/trig.h"
#include "engine/physics/mechanisms/mechanism.h"
#include "engine/program/compile.h"
#include "engine/program/tree.h"
#include "engine/scene/parts/spawn.h"
#include "engine/sdf/piece.h"

namespace pinfield::editor {
namespace {

constexpr int cells = 40;             ///< of a side, where a line is looked for
constexpr double tiny = 1e-9;         ///< metres: pieces that meet
constexpr double flat_enough = 0.02;  ///< of the radius: how far an arc strays from its chord

class Drawing {
public:
    /// `frame`: beyond it nothing is drawn.
    explicit Drawing(const Box2& frame) : frame_(frame) {}

    void add(const Field& field, const Similarity& world_from_field, NodeId left_out) {
        for (const Solid& solid : field.solids) {
            if (solid.origin == left_out) continue;
            for (int i = 0; i < solid.piece_count; ++i)
                add(sdf::transformed(world_from_field, at(field.pieces, solid.first_piece + i).piece));
            if (solid.piece_count == 0) add_zero_line(field, solid.root, world_from_field);
        }
    }
    void add(const sdf::Piece& piece, int halvings = 6) {
        const Vec2 middle = sdf::middle_of(piece);
        const bool flat = length(middle - 0.5 * (piece.a + piece.b)) < flat_enough * piece.radius;
        if (!piece.is_arc() || flat || halvings == 0) return chord(piece.a, piece.b);
        add(sdf::Piece::arc(piece.centre, piece.radius, piece.a, middle, piece.turn, false), halvings - 1);
        add(sdf::Piece::arc(piece.centre, piece.radius, middle, piece.b, piece.turn, false), halvings - 1);
    }
    /// Of a solid without pieces: cell by cell, straight from side to side of each.
    void add_zero_line(const Field& field, int op, const Similarity& world_from_field) {
        const Similarity field_from_world = world_from_field.inverse();
        const Vec2 cell = frame_.size() / cells;
        const auto corner = [&](int i, int j) { return Vec2(frame_.lo + cell.cwiseProduct(Vec2(i, j))); };
        std::vector<double> values;
        for (int j = 0; j <= cells; ++j)
            for (int i = 0; i <= cells; ++i) values.push_back(tree_value(field, op, field_from_world * corner(i, j)));
        const auto value = [&](int i, int j) { return at(values, j * (cells + 1) + i); };
        for (int j = 0; j < cells; ++j)
            for (int i = 0; i < cells; ++i) {
                const int ring[5][2] = {{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}, {i, j}};
                std::vector<Vec2> ends;
                for (int k = 0; k < 4; ++k) {
                    const double a = value(ring[k][0], ring[k][1]), b = value(ring[k + 1][0], ring[k + 1][1]);
                    if ((a <= 0) == (b <= 0)) continue;
                    const Vec2 p = corner(ring[k][0], ring[k][1]), q = corner(ring[k + 1][0], ring[k + 1][1]);
                    ends.push_back(p + a / (a - b) * (q - p));
                }
                for (std::size_t k = 0; k + 1 < ends.size(); k += 2) chord(ends[k], ends[k + 1]);
            }
    }
    Picture finished() {
        for (const auto& line : picture_.lines)
            for (const Vec2& p : line) picture_.box = picture_.box.merged({p, p});
        return std::move(picture_);
    }

private:
    /// What of it lies in the frame.
    void chord(const Vec2& from, const Vec2& to) {
        const Vec2 way = to - from;
        double first = 0, last = 1;
        for (const int axis : {0, 1}) {
            if (way[axis] == 0) {
                if (from[axis] < frame_.lo[axis] || from[axis] > frame_.hi[axis]) return;
                continue;
            }
            const double s = (frame_.lo[axis] - from[axis]) / way[axis], t = (frame_.hi[axis] - from[axis]) / way[axis];
            first = std::max(first, std::min(s, t));
            last = std::min(last, std::max(s, t));
        }
        if (first >= last) return;
        const Vec2 a = from + first * way, b = last == 1 ? to : Vec2(from + last * way);
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
