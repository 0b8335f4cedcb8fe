#include "editor/showing.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/pick.h"
#include "engine/core/at.h"
#include "engine/program/evaluate.h"

namespace pinfield::editor {
namespace {

constexpr double exact_enough = 1e-8;  ///< metres
constexpr int most_steps = 60;

bool is_identity(const Similarity& map) {
    return map.cosine == 1 && map.sine == 0 && map.scale == 1 && !map.mirrored && map.offset == Vec2(0, 0);
}

/// The image that is wanted, else the one that lies where the child lies, else the first.
int chosen_image(const Field& field, const Op& op, const std::vector<int>& images, std::size_t used) {
    if (used < images.size() && images[used] >= 0 && images[used] < op.image_count) return images[used];
    for (int i = 0; i < op.image_count; ++i)
        if (is_identity(at(field.images, op.first_image + i))) return i;
    return 0;
}

/// Goes down all ways to a node's solid, and keeps the one that ends nearest to a place.
class Search {
public:
    Search(const Field& field, NodeId node, double slack) : field_(field), node_(node), least_(slack) {}

    void visit(int index, const Vec2& p) {
        const Op& op = at(field_.ops, index);
        if (op.origin == node_) return offer(index, p);
        if (op.kernels->form == sdf::Form::warp) {
            const sdf::Warped warped = op.kernels->warped(field_.params.data() + op.params, op.local_from_field * p);
            return visit_children(op, op.local_from_field.inverse() * warped.point);
        }
        if (op.kernels->form != sdf::Form::images) return visit_children(op, p);
        for (int i = 0; i < op.image_count; ++i) {
            images_.push_back(i);
            visit_children(op, at(field_.images, op.first_image + i).inverse() * p);
            images_.pop_back();
        }
    }
    const std::optional<std::vector<int>>& found() const { return found_; }
    double least() const { return least_; }

private:
    void visit_children(const Op& op, const Vec2& p) {
        for (int i = 0; i < op.child_count; ++i) visit(at(field_.links, op.first_link + i), p);
    }
    void offer(int index, const Vec2& p) {
        if (at(field_.ops, index).bounds.distance(p) > least_) return;
        const double distance = evaluate_tree(field_, index, p).value;
        if (distance > least_ || (found_ && distance == least_)) return;
        least_ = distance;
        found_ = images_;
    }

    const Field& field_;
    NodeId node_;
    double least_;
    std::vector<int> images_{};
    std::optional<std::vector<int>> found_{};
};

/// Calls for every solid that a node may be a part of, with its field and that one's place; until one is found.
template <class Visit>
void for_solids_of(const AppState& state, NodeId node, Visit visit) {
    const Scene& scene = state.document.scene();
    const Program& program = state.session.program();
    const auto solids_of = [&](const Field& field, const Similarity& world_from_field) {
        for (const Solid& solid : field.solids)
            if (scene.find(node) && (solid.origin == node || scene.is_within(node, solid.origin) || scene.is_within(solid.origin, node)))
                visit(field, solid, world_from_field);
    };
    solids_of(program.fixed, {});
    for (std::size_t i = 0; i < program.movers.size(); ++i)
        solids_of(program.movers[i].field, state.session.world_from_mover(static_cast<int>(i)));
    for (const Sensor& sensor : program.sensors) solids_of(sensor.field, {});
}

}  // namespace

Showing::Showing(const AppState& state, NodeId node, const Copy& copy) : program_(state.session.world().shared_program()) {
    const Similarity world_from_node = shown_from_local(state, node);
    local_from_inner_ = world_from_node.inverse();
    const Scene& scene = state.document.scene();
    for_solids_of(state, node, [&](const Field& field, const Solid& solid, const Similarity& world_from_field) {
        if (field_ || !scene.is_within(node, solid.origin)) return;
        field_ = &field;
        if (!find_way(scene, solid.root, node, copy.images, 0)) {
            field_ = nullptr;
            return;
        }
        field_from_world_ = world_from_field.inverse();
        local_from_inner_ = world_from_node.inverse() * world_from_field;
    });
    Vec2 near = field_from_world_ * copy.near.value_or(world_from_node.offset);
    for (Step& step : steps_) {
        step.near = near;
        Vec2 along_x, along_y;
        near = step.warp ? warped(*step.warp, near, along_x, along_y) : step.inner_from_outer * near;
    }
}

bool Showing::find_way(const Scene& scene, int index, NodeId node, const std::vector<int>& images, std::size_t used) {
    const Op& op = at(field_->ops, index);
    if (op.origin == node) return true;
    const std::size_t steps = steps_.size();
    if (op.kernels->form == sdf::Form::warp) steps_.push_back({{}, &op});
    if (op.kernels->form == sdf::Form::images) {
        const int image = chosen_image(*field_, op, images, used++);
        steps_.push_back({at(field_->images, op.first_image + image).inverse(), nullptr});
    }
    for (int i = 0; i < op.child_count; ++i)
        if (find_way(scene, at(field_->links, op.first_link + i), node, images, used)) return true;
    steps_.resize(steps);
    return false;
}

Vec2 Showing::warped(const Op& op, const Vec2& p, Vec2& along_x, Vec2& along_y) const {
    const sdf::Warped warped = op.kernels->warped(field_->params.data() + op.params, op.local_from_field * p);
    const Similarity field_from_local = op.local_from_field.inverse();
    // d inner / d outer = R' J R, where R turns into the local frame: scales cancel.
    const Vec2 x = op.local_from_field.direction({1, 0}), y = op.local_from_field.direction({0, 1});
    along_x = field_from_local.direction(x.x() * warped.from_x + x.y() * warped.from_y);
    along_y = field_from_local.direction(y.x() * warped.from_x + y.y() * warped.from_y);
    return field_from_local * warped.point;
}

Vec2 Showing::local_from_world(const Vec2& world) const {
    Vec2 p = field_from_world_ * world, along_x, along_y;
    for (const Step& step : steps_) p = step.warp ? warped(*step.warp, p, along_x, along_y) : step.inner_from_outer * p;
    return local_from_inner_ * p;
}

/// Warps know the way inwards only: Levenberg's and Marquardt's steps back (Marquardt 1963), from where the copy was found.
std::optional<Vec2> Showing::unwarped(const Step& step, const Vec2& inner) const {
    Vec2 p = step.near, along_x, along_y;
    Vec2 off = inner - warped(*step.warp, p, along_x, along_y);
    double damping = 1e-6;
    for (int i = 0; i < most_steps && length(off) > 1e-3 * exact_enough; ++i) {
        Eigen::Matrix2d slope;
        slope << along_x, along_y;
        const Eigen::Matrix2d normal = slope.transpose() * slope + damping * Eigen::Matrix2d::Identity();
        const Vec2 next = p + Vec2(normal.inverse() * (slope.transpose() * off));
        Vec2 next_x, next_y;
        const Vec2 next_off = inner - warped(*step.warp, next, next_x, next_y);
        if (length(next_off) < length(off)) {
            p = next, off = next_off, along_x = next_x, along_y = next_y;
            damping = std::max(1e-12, 0.1 * damping);
        } else {
            damping *= 10;
        }
    }
    if (!(length(off) < exact_enough)) return {};
    return p;
}

std::optional<Vec2> Showing::world_from_local(const Vec2& local) const {
    Vec2 p = local_from_inner_.inverse() * local;
    for (std::size_t i = steps_.size(); i-- > 0;) {
        if (!steps_[i].warp) {
            p = steps_[i].inner_from_outer.inverse() * p;
            continue;
        }
        const std::optional<Vec2> outer = unwarped(steps_[i], p);
        if (!outer) return {};
        p = *outer;
    }
    return field_from_world_.inverse() * p;
}

bool Showing::is_similar() const {
    return std::none_of(steps_.begin(), steps_.end(), [](const Step& step) { return step.warp; });
}

std::optional<Copy> copy_at(const AppState& state, NodeId node, const Vec2& world, double slack) {
    std::optional<Copy> copy;
    double least = slack;
    for_solids_of(state, node, [&](const Field& field, const Solid& solid, const Similarity& world_from_field) {
        Search search(field, node, least);
        search.visit(solid.root, world_from_field.inverse() * world);
        if (!search.found()) return;
        least = search.least();
        copy = Copy{*search.found(), world};
    });
    return copy;
}

}  // namespace pinfield::editor
