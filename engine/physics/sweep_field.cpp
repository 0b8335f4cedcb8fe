#include "engine/physics/sweep_field.h"

#include <algorithm>

#include "engine/physics/sweep_tree.h"
#include "engine/program/evaluate.h"

namespace pinfield {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

SweptField::SweptField(const Field& field) : field_(&field), pieces_(prepare_pieces(field)) {}

FieldSweep SweptField::sweep(const Motion& motion, double duration, double radius, const ContactBand& band, LayerMask layers,
                             double reach, SweepStats& stats) const {
    FieldSweep out;
    ++stats.sweeps;
    const double travel = motion.travel(duration);
    const int piece_count = static_cast<int>(pieces_.size());
    double nearest = radius + reach, until = duration;
    int evaluations = 0;
    field_->bvh.overlapping(motion.bounds(duration).grown(radius + reach), [&](int entry) {
        if (entry >= piece_count) {
            const int solid = field_->tree_solids[at(entry - piece_count)];
            if (!in_layers(solid, layers)) return;
            const TreeSweep tree = sweep_tree(*field_, solid, motion, until, radius, band, evaluations);
            nearest = std::min(nearest, tree.start_distance);
            out.clear_until = std::min(out.clear_until, tree.clear_until);
            if (tree.time < out.hit.time) out.hit = {tree.time, tree.normal, 0, solid, tree.leaf, -1};
        } else {
            const SweepPiece& piece = pieces_[at(entry)];
            if (!(piece.layers & layers)) return;
            const Foot foot = nearest_on(piece, motion.position);
            nearest = std::min(nearest, foot.distance);
            if (foot.distance - radius > travel + band.tolerance) return;
            const PieceHit hit = sweep_piece(piece, motion, until, radius, band, evaluations);
            if (hit.capped) out.clear_until = std::min(out.clear_until, hit.time);
            else if (hit.time < out.hit.time || (hit.time == out.hit.time && hit.time < infinity && entry < out.hit.piece))
                out.hit = {hit.time, hit.normal, piece.turn < 0 && hit.time < infinity ? piece.radius : 0, piece.solid, piece.leaf, entry};
        }
        until = std::min(until, out.hit.time);
    });
    if (out.clear_until >= out.hit.time) out.clear_until = infinity;
    else out.hit = {};
    out.free_path = std::max(0.0, nearest - radius - band.tolerance);
    stats.evaluations += evaluations;
    stats.most_evaluations = std::max(stats.most_evaluations, evaluations);
    if (out.clear_until < duration) ++stats.capped;
    return out;
}

void SweptField::touching(const Vec2& p, double radius, double skin, LayerMask layers, std::vector<Touch>& out) const {
    const std::size_t first = out.size();
    const int piece_count = static_cast<int>(pieces_.size());
    field_->bvh.overlapping(Box2{p, p}.grown(radius + skin), [&](int entry) {
        if (entry >= piece_count) {
            const int solid = field_->tree_solids[at(entry - piece_count)];
            if (!in_layers(solid, layers)) return;
            const Nearest truth = nearest_of_solid(*field_, solid, p);
            const double size = length(truth.gradient);
            if (truth.distance - radius <= skin && size > 0)
                out.push_back({truth.gradient / size, truth.distance - radius, 0, solid, truth.leaf, -1});
        } else {
            const SweepPiece& piece = pieces_[at(entry)];
            if (!(piece.layers & layers)) return;
            const Foot foot = nearest_on(piece, p);
            if (foot.outside && foot.distance - radius <= skin)
                out.push_back({foot.normal, foot.distance - radius, foot.hollow, piece.solid, piece.leaf, entry});
        }
    });
    std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(),
              [](const Touch& a, const Touch& b) { return a.solid != b.solid ? a.solid < b.solid : a.piece < b.piece; });
}

}  // namespace pinfield
