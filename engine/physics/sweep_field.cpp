#include "engine/physics/sweep_field.h"

#include <algorithm>

#include "engine/core/at.h"
#include "engine/physics/sweep_tree.h"
#include "engine/program/evaluate.h"

namespace pinfield {

namespace {

/// Ball radii. A longer list lasts longer and takes longer to go through.
constexpr double neighbour_reach = 4;

}  // namespace

SweptField::SweptField(const Field& field) : field_(&field), pieces_(prepare_pieces(field)) {}

FieldSweep SweptField::sweep(const Motion& motion, double duration, double radius, const ContactBand& band, LayerMask layers,
                             double reach, SweepStats& stats, Neighbours* near) const {
    FieldSweep out;
    ++stats.sweeps;
    const double touchable = radius + motion.travel(duration) + band.tolerance;  // what is farther cannot be met
    const int piece_count = static_cast<int>(pieces_.size());
    double nearest = radius + reach;
    int evaluations = 0, first_entry = -1;
    const auto is_first = [&](double time, int entry) {
        if (!(time < out.hit.time || (time == out.hit.time && time < infinity && entry < first_entry))) return false;
        first_entry = entry;
        return true;
    };
    // Each entry is swept for the whole duration, so that what is found does not depend on the order of the visits by a bit.
    const auto visit = [&](int entry) {
        if (entry >= piece_count) {
            const int solid = at(field_->tree_solids, entry - piece_count);
            if (!in_layers(solid, layers)) return;
            const TreeSweep tree = sweep_tree(*field_, solid, motion, duration, radius, band, evaluations);
            nearest = std::min(nearest, tree.start_distance);
            out.clear_until = std::min(out.clear_until, tree.clear_until);
            if (is_first(tree.time, entry)) out.hit = {tree.time, tree.normal, 0, solid, tree.leaf, -1};
        } else {
            const SweepPiece& piece = at(pieces_, entry);
            if (!(piece.layers & layers)) return;
            const double distance = distance_to(piece, motion.position);
            nearest = std::min(nearest, distance);
            if (distance > touchable) return;
            const PieceHit hit = sweep_piece(piece, motion, duration, radius, band, evaluations);
            if (hit.capped) out.clear_until = std::min(out.clear_until, hit.time);
            else if (is_first(hit.time, entry))
                out.hit = {hit.time, hit.normal, piece.turn < 0 ? piece.radius : 0, piece.solid, piece.leaf, entry};
        }
    };
    const double needed = std::max(nearest, touchable);
    if (near && gather(motion.position, needed, radius, *near)) {
        const double moved = length(motion.position - near->around);
        for (const Neighbour& neighbour : near->list) {
            if (neighbour.distance - moved > std::max(nearest, touchable)) break;
            visit(neighbour.entry);
        }
    } else {
        field_->bvh.nearest_squared(motion.position, needed * needed, [&](int entry) {
            visit(entry);
            const double reached = std::max(nearest, touchable);
            return reached * reached;
        });
    }
    if (out.clear_until >= out.hit.time) out.clear_until = infinity;
    else out.hit = {};
    out.free_path = std::max(0.0, nearest - radius - band.tolerance);
    stats.evaluations += evaluations;
    stats.most_evaluations = std::max(stats.most_evaluations, evaluations);
    if (out.clear_until < duration) ++stats.capped;
    return out;
}

bool SweptField::gather(const Vec2& p, double needed, double radius, Neighbours& near) const {
    if (length(p - near.around) + needed <= near.reach) return true;
    const double reach = neighbour_reach * radius;
    if (needed > reach) return false;
    near.around = p;
    near.reach = reach;
    near.list.clear();
    field_->bvh.nearest(p, reach, [&](int entry) {
        near.list.push_back({least_distance(entry, p), entry});
        return reach;
    });
    std::sort(near.list.begin(), near.list.end(), [](const Neighbour& a, const Neighbour& b) {
        return a.distance != b.distance ? a.distance < b.distance : a.entry < b.entry;
    });
    return true;
}

double SweptField::least_distance(int entry, const Vec2& p) const {
    const int tree = entry - static_cast<int>(pieces_.size());
    if (tree < 0) return distance_to(at(pieces_, entry), p);
    return at(field_->solids, at(field_->tree_solids, tree)).bounds.distance(p);
}

void SweptField::touching(const Vec2& p, double radius, double skin, LayerMask layers, std::vector<Touch>& out) const {
    const std::size_t first = out.size();
    const int piece_count = static_cast<int>(pieces_.size());
    field_->bvh.overlapping(Box2{p, p}.grown(radius + skin), [&](int entry) {
        if (entry >= piece_count) {
            const int solid = at(field_->tree_solids, entry - piece_count);
            if (!in_layers(solid, layers)) return;
            const Nearest truth = nearest_of_solid(*field_, solid, p);
            const double size = length(truth.gradient);
            if (truth.distance - radius <= skin && size > 0)
                out.push_back({truth.gradient / size, truth.distance - radius, 0, solid, truth.leaf, -1});
        } else {
            const SweepPiece& piece = at(pieces_, entry);
            if (!(piece.layers & layers)) return;
            const Foot foot = nearest_on(piece, p);
            if (foot.outside && foot.distance - radius <= skin)
                out.push_back({foot.normal, foot.distance - radius, foot.concave_radius, piece.solid, piece.leaf, entry});
        }
    });
    std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(),
              [](const Touch& a, const Touch& b) { return a.solid != b.solid ? a.solid < b.solid : a.piece < b.piece; });
}

}  // namespace pinfield
