#include "editor/transform.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "editor/edit_tools.h"
#include "editor/structure_tools.h"
#include "engine/core/at.h"
#include "engine/core/trig.h"

namespace pinfield::editor {
namespace {

constexpr double degrees = 180 / pi;
constexpr double least_factor = 0.01;
constexpr double still = 1e-6;  ///< metres about the pivot where a hand has no direction

double whole(double x, double step) { return step > 0 ? step * std::round(x / step) : x; }

SetField set(const Node& node, std::string_view key, Value value) { return {node.id, *node.type->find_field(key), std::move(value), true}; }

}  // namespace

Vec2 pivot_of(const Scene& scene, std::span<const NodeId> nodes) {
    Box2 places;
    for (const NodeId id : nodes)
        if (const Node* node = scene.find(id); node && !node->is_record()) {
            const Vec2 place = world_from_local(scene, id).offset;
            places = places.merged({place, place});
        }
    return places.is_empty() ? Vec2(0, 0) : places.centre();
}

bool TransformDrag::begin(const Document& document, std::span<const NodeId> nodes, TransformKind kind, const Vec2& pivot,
                          const Vec2& world) {
    const Scene& scene = document.scene();
    if (active() || length(world - pivot) < still) return false;
    for (const NodeId id : outermost(scene, nodes)) {
        const Node* node = scene.find(id);
        if (!node || node->is_record() || is_locked(scene, *node)) continue;
        const Similarity parent_from_world = node->parent ? world_from_local(scene, node->parent).inverse() : Similarity{};
        held_.push_back({id, node->get<Vec2>("at"), node->get<double>("turn"), node->get<double>("scale"), parent_from_world});
    }
    kind_ = kind;
    pivot_ = pivot;
    hand_before_ = world - pivot;
    amount_ = reached_ = kind == TransformKind::turn ? 0 : 1;
    return active();
}

std::optional<std::string> TransformDrag::update(Document& document, const Vec2& world, double step) {
    const Vec2 hand = world - pivot_;
    if (!active() || length(hand) < still) return {};
    if (kind_ == TransformKind::turn) {
        // The nearest of the angles that look alike: a hand may go round more than once.
        const double angle = degrees * std::atan2(cross(hand_before_, hand), dot(hand_before_, hand));
        reached_ += std::remainder(angle - reached_, 360.0);
    } else {
        reached_ = std::max(least_factor, length(hand) / length(hand_before_));
    }
    const double amount = kind_ == TransformKind::turn ? whole(reached_, step) : std::max(least_factor, whole(reached_, step));
    if (amount == amount_ && !document.previewing()) return {};  // a click is no drag
    amount_ = amount;
    for (const Held& held : held_) {
        if (!document.scene().find(held.node)) continue;
        for (const SetField& edit : edits_for(document.scene(), held))
            if (auto why = document.preview(edit)) return why;
    }
    return {};
}

std::vector<SetField> TransformDrag::edits_for(const Scene& scene, const Held& held) const {
    const Node& node = *scene.find(held.node);
    const bool turns = kind_ == TransformKind::turn;
    std::vector<SetField> out;
    if (turns)
        out.push_back(set(node, "turn", on_grid(held.turn + (held.parent_from_world.mirrored ? -1 : 1) * amount_, 0.01)));
    else
        out.push_back(set(node, "scale", on_grid(held.scale * amount_, 0.0001)));
    const Vec2 place = held.parent_from_world.inverse() * held.at, arm = place - pivot_;
    const SineCosine turn = sine_cosine(amount_ / degrees);
    const Vec2 moved_arm =
        turns ? Vec2(turn.cosine * arm.x() - turn.sine * arm.y(), turn.sine * arm.x() + turn.cosine * arm.y()) : Vec2(amount_ * arm);
    Vec2 at = held.parent_from_world * Vec2(pivot_ + moved_arm);
    for (const int axis : {0, 1}) at[axis] = std::fabs(at[axis] - held.at[axis]) < 1e-9 ? held.at[axis] : on_grid(at[axis], 0);
    if (at != held.at || !identical(node.value("at"), Value(held.at))) out.push_back(set(node, "at", at));
    return out;
}

std::optional<std::string> TransformDrag::end(Document& document) {
    std::vector<NodeId> nodes;
    for (const Held& held : std::exchange(held_, {}))
        if (document.scene().find(held.node)) nodes.push_back(held.node);
    if (nodes.empty()) return {};
    const std::string_view verb = kind_ == TransformKind::turn ? "Turn" : "Scale";
    return document.commit(nodes.size() == 1 ? fmt::format("{} {}", verb, document.scene().path(nodes.front()))
                                             : fmt::format("{} {} nodes", verb, nodes.size()));
}

void TransformDrag::cancel(Document& document) {
    if (active()) document.cancel_preview();
    held_.clear();
}

}  // namespace pinfield::editor
