#include "editor/handles.h"

#include <algorithm>
#include <cmath>

#include "editor/edit_tools.h"
#include "engine/core/at.h"

namespace pinfield::editor {
namespace {

constexpr double widest = 2;  ///< metres: of what has no end, the part about the origin that is looked at
constexpr std::size_t most_handles = 24, most_joints = 96;
constexpr double off_the_hand = 1e-4;  ///< metres
constexpr double least_speed = 0.02;   ///< of the outline, against what moves most by a natural step of the unit

bool is_place(const FieldType& field) { return field.meta.meaning == Meaning::place; }
bool is_velocity(const FieldType& field) { return field.kind == FieldKind::vec2 && field.meta.unit == Unit::metre_per_second; }

/// Numbers of the node's own that may shape it; what counts copies or corners jumps, and no hand can follow it.
bool may_move_outline(const FieldType& field) {
    const bool number = field.kind == FieldKind::number || field.kind == FieldKind::vec2;
    const bool unit = field.meta.unit == Unit::metre || field.meta.unit == Unit::degree || field.meta.unit == Unit::none;
    return number && unit && !field.common && field.meta.affects == Affects::shape && field.meta.meaning == Meaning::plain;
}

/// A change of the number that is small against any shape and large against rounding.
double little_of(Unit unit, double value) {
    if (unit == Unit::metre) return 1e-6;
    if (unit == Unit::degree) return 1e-3;
    return 1e-5 * std::max(1.0, std::fabs(value));
}

/// How far a number's natural step would move the outline if it moved with it: a millimetre, a degree of a decimetre, a hundredth of it.
double natural_speed(Unit unit) { return unit == Unit::metre ? 1 : unit == Unit::degree ? 0.1 * 0.0175 : 0.1; }

/// Where the outline crosses the way from a to b, marched along by the distance itself.
void crossings(const LoneShape& shape, const Vec2& a, const Vec2& b, std::vector<Vec2>& out) {
    const double way = length(b - a), least = way / 512;
    if (!(way > 0)) return;
    const auto on = [&](double s) { return Vec2(a + s / way * (b - a)); };
    double s = 0, d = shape.distance(a);
    while (s < way) {
        const double next = std::min(way, s + std::max(least, 0.7 * std::fabs(d)));
        const double e = shape.distance(on(next));
        if ((d <= 0) != (e <= 0)) {
            double lo = s, hi = next;
            for (int i = 0; i < 48; ++i) {
                const double middle = 0.5 * (lo + hi);
                ((shape.distance(on(middle)) <= 0) == (d <= 0) ? lo : hi) = middle;
            }
            out.push_back(on(0.5 * (lo + hi)));
        }
        s = next;
        d = e;
    }
}

/// Does the outline turn within a small way to either side?
bool is_corner(const LoneShape& shape, const Vec2& p) {
    constexpr double way = 2e-4, turn = 0.2;  // metres, radians
    const Vec2 normal = shape.normal(p), along = way * perpendicular(normal);
    return std::fabs(cross(normal, shape.normal(p + along))) > turn || std::fabs(cross(normal, shape.normal(p - along))) > turn;
}

/// Points of the outline all around, those in the middle of edges and corners among them.
std::vector<Vec2> outline_points(const LoneShape& shape) {
    Box2 box = shape.bounds();
    const Box2 about{{-widest, -widest}, {widest, widest}};
    if (box.is_empty()) return {};
    box = {box.lo.cwiseMax(about.lo), box.hi.cwiseMin(about.hi)};
    const Vec2 centre = box.centre(), size = box.size();
    box = box.grown(0.02 * size.norm() + 1e-5);
    std::vector<Vec2> out;
    for (const double share : {0.5, 0.25, 0.75, 0.04, 0.96}) {
        const Vec2 at = centre + (share - 0.5) * size;
        crossings(shape, {box.lo.x(), at.y()}, {box.hi.x(), at.y()}, out);
        crossings(shape, {at.x(), box.lo.y()}, {at.x(), box.hi.y()}, out);
    }
    const double reach = box.size().norm();
    for (int i = 0; i < 24; ++i) {
        const double angle = i * 6.283185307179586 / 24;
        for (const Vec2& from : {centre, Vec2(0, 0)}) crossings(shape, from, from + reach * Vec2(std::cos(angle), std::sin(angle)), out);
    }
    const std::vector<Vec2> joints = shape.joints();
    if (joints.size() <= most_joints) out.insert(out.end(), joints.begin(), joints.end());
    return out;
}

struct OutlinePoint {
    Vec2 at, normal;
    bool is_corner = false;
};

/// Looks for the handle of one number: where the outline moves most with it, and among equals in the middle of an edge, to the right, away
/// from the handles there are.
std::optional<Handle> outline_handle(const LoneNode& alone, const std::vector<OutlinePoint>& outline, const Box2& box, int field,
                                     int component_index, const std::vector<Handle>& taken) {
    const Value& value = at(alone.node().fields, field).value;
    const Unit unit = at(alone.node().type->fields, field).meta.unit;
    const double x = component(value, component_index), little = little_of(unit, x);
    double step = little;
    std::optional<LoneShape> changed = alone.shape_with(field, with_component(value, component_index, x + step));
    if (!changed) changed = alone.shape_with(field, with_component(value, component_index, x + (step = -little)));
    if (!changed) return {};
    const std::optional<LoneShape> shape = alone.shape();
    std::vector<double> speeds;
    double top = 0;
    for (const OutlinePoint& point : outline) {
        speeds.push_back((shape->distance(point.at) - changed->distance(point.at)) / step);
        top = std::max(top, std::fabs(speeds.back()));
    }
    if (!(top > least_speed * natural_speed(unit)) || !std::isfinite(top)) return {};
    const double extent = 0.5 * box.size().norm();
    std::optional<Handle> best;
    double best_score = -infinity;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const auto& [place, normal, is_corner] = outline[i];
        if (std::fabs(speeds[i]) < (is_corner ? 0.97 : 0.8) * top) continue;
        const double side = std::max({normal.x(), 0.6 * normal.y(), -0.3 * normal.x(), -0.2 * normal.y()});
        double score =
            side - (is_corner ? 0.5 : 0) + std::fabs(speeds[i]) / top - 1.5 * std::fabs(cross(Vec2(place - box.centre()), normal)) / extent;
        for (const Handle& other : taken) score -= 2 * std::max(0.0, 1 - length(place - other.at) / (0.3 * extent));
        if (score <= best_score) continue;
        best_score = score;
        best = Handle{HandleKind::outline, field, component_index, place, normal, speeds[i]};
    }
    return best;
}

/// Does a new point in the middle of two leave the shape as it is? Of a list in which points mean different things it would not.
bool is_gap(const LoneNode& alone, int field, const std::vector<Vec2>& points, std::size_t i, const std::vector<OutlinePoint>& outline) {
    std::vector<Vec2> more = points;
    more.insert(more.begin() + static_cast<std::ptrdiff_t>(i) + 1, 0.5 * (points[i] + points[(i + 1) % points.size()]));
    const std::optional<LoneShape> shape = alone.shape_with(field, more);
    return shape &&
           std::all_of(outline.begin(), outline.end(), [&](const OutlinePoint& p) { return std::fabs(shape->distance(p.at)) < 1e-6; });
}

void add_places(const LoneNode& alone, int field, const std::vector<OutlinePoint>& outline, std::vector<Handle>& out) {
    const Value& value = at(alone.node().fields, field).value;
    if (const auto* place = std::get_if<Vec2>(&value)) out.push_back({HandleKind::place, field, 0, *place});
    const auto* points = std::get_if<std::vector<Vec2>>(&value);
    if (!points || points->size() > most_handles) return;
    for (std::size_t i = 0; i < points->size(); ++i) {
        const int component_index = 2 * static_cast<int>(i);
        out.push_back({HandleKind::place, field, component_index, (*points)[i]});
        const Vec2& next = (*points)[(i + 1) % points->size()];
        if (is_gap(alone, field, *points, i, outline))
            out.push_back({HandleKind::gap, field, component_index, 0.5 * ((*points)[i] + next)});
    }
}

/// Whether there is anything to look for, before the node is compiled.
bool has_handles(const NodeType& type) {
    if (type.meta.kind == NodeKind::record) return false;
    return std::any_of(type.fields.begin(), type.fields.begin() + type.own_fields,
                       [](const FieldType& field) { return is_place(field) || is_velocity(field) || may_move_outline(field); });
}

}  // namespace

std::vector<Handle> handles_of(const Scene& scene, NodeId id) {
    const Node* node = scene.find(id);
    if (!node || !has_handles(*node->type)) return {};
    const LoneNode alone(scene, id);
    const std::optional<LoneShape> shape = alone.shape();
    std::vector<OutlinePoint> outline;
    if (shape)
        for (const Vec2& p : outline_points(*shape)) outline.push_back({p, shape->normal(p), is_corner(*shape, p)});
    std::vector<Handle> out;
    const int own_fields = node->type->own_fields;
    for (int i = 0; i < own_fields; ++i) {
        const FieldType& field = at(node->type->fields, i);
        if (is_place(field)) add_places(alone, i, outline, out);
        if (is_velocity(field))
            out.push_back({HandleKind::velocity, i, 0, seconds_of_velocity * std::get<Vec2>(at(node->fields, i).value)});
    }
    if (outline.empty()) return out;
    for (int i = 0; i < own_fields; ++i) {
        const FieldType& field = at(node->type->fields, i);
        if (!may_move_outline(field) || !node->has_use_for(static_cast<std::size_t>(i))) continue;
        for (int part = 0; part < component_count(at(node->fields, i).value); ++part)
            if (const auto handle = outline_handle(alone, outline, shape->bounds(), i, part, out)) out.push_back(*handle);
    }
    return out;
}

namespace {

double share_of_step(const Vec2& grid) {
    if (grid == Vec2(0, 0)) return 1e-2;
    return grid.minCoeff() == exact_grid ? 1e-6 : 1;
}

}  // namespace

bool HandleDrag::begin(const Document& document, NodeId id, const Handle& handle, const Vec2& p) {
    const Node* node = document.scene().find(id);
    if (active() || !node || is_locked(document.scene(), *node)) return false;
    node_ = id;
    handle_ = handle;
    hold_ = p - handle.at;
    before_ = at(node->fields, handle.field).value;
    alone_.emplace(document.scene(), id);
    stopped_by_.reset();
    return true;
}

std::optional<std::string> HandleDrag::update(Document& document, const Vec2& p, const Vec2& grid) {
    if (!active() || !document.scene().find(node_)) return {};
    const Vec2 hand = p - hold_;
    if (!document.previewing() && length(hand - handle_.at) < 1e-9) return {};  // a click is no drag
    const Value value = handle_.kind == HandleKind::outline ? number_through(hand, share_of_step(grid)) : moved_places(hand, grid);
    return document.preview({node_, handle_.field, value, true});
}

Value HandleDrag::moved_places(const Vec2& hand, const Vec2& grid) const {
    const double scale = handle_.kind == HandleKind::velocity ? 1 / seconds_of_velocity : 1;
    Value value = before_;
    if (handle_.kind == HandleKind::gap) {
        auto& points = std::get<std::vector<Vec2>>(value);
        points.insert(points.begin() + handle_.component / 2 + 1, Vec2(on_grid(handle_.at.x(), 0), on_grid(handle_.at.y(), 0)));
    }
    const int first = handle_.component + (handle_.kind == HandleKind::gap ? 2 : 0);
    for (const int axis : {0, 1})
        if (hand[axis] != handle_.at[axis]) value = with_component(value, first + axis, on_grid(scale * hand[axis], scale * grid[axis]));
    return value;
}

/// Newton's steps on the distance at the hand as a function of the number: a straight line for nearly every field. `share`: of the step
/// that numbers of this kind take.
Value HandleDrag::number_through(const Vec2& hand, double share) {
    const FieldType& field = at(alone_->node().type->fields, handle_.field);
    const auto with = [&](double x) { return with_component(before_, handle_.component, x); };
    const double start = component(before_, handle_.component), little = little_of(field.meta.unit, start);
    double x = start + dot(Vec2(hand - handle_.at), handle_.normal) / handle_.speed, off = infinity;
    for (int i = 0; i < 6; ++i) {
        const auto shape = alone_->shape_with(handle_.field, with(x)), beside = alone_->shape_with(handle_.field, with(x + little));
        if (!shape || !beside) break;  // past what is allowed: the nearest that is will do
        const double d = shape->distance(hand), slope = (beside->distance(hand) - d) / little;
        if (slope * handle_.speed >= 0 || std::fabs(slope) < 0.05 * std::fabs(handle_.speed)) break;
        off = std::fabs(d);
        if (off < 1e-7) break;
        x -= d / slope;
    }
    const double step = share * scrub_step(field, start);
    const double target = on_grid(x, step);
    stopped_by_ = alone_->why_not(handle_.field, with(target));
    if (!stopped_by_ && off > off_the_hand) stopped_by_ = "the outline does not come to here";
    return with(nearest_allowed([&](double y) { return !alone_->why_not(handle_.field, with(y)); }, start, target, step));
}

std::optional<std::string> HandleDrag::end(Document& document) {
    if (!active()) return {};
    const NodeId id = node_;
    node_ = {};
    alone_.reset();
    return document.scene().find(id) ? document.commit(change_label(document.scene(), id, handle_.field)) : std::nullopt;
}

void HandleDrag::cancel(Document& document) {
    if (active()) document.cancel_preview();
    node_ = {};
    alone_.reset();
}

std::optional<SetField> without_point(const Scene& scene, NodeId id, int field, int component_index) {
    const Node* node = scene.find(id);
    if (!node) return {};
    Value value = at(node->fields, field).value;
    auto* points = std::get_if<std::vector<Vec2>>(&value);
    if (!points || component_index / 2 >= static_cast<int>(points->size())) return {};
    points->erase(points->begin() + component_index / 2);
    SetField edit{id, field, value, true};
    if (why_invalid(scene, edit)) return {};
    return edit;
}

}  // namespace pinfield::editor
