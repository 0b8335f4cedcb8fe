#include "editor/edit_tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/core/at.h"
#include "engine/core/numbers.h"
#include "engine/io/quantity.h"
#include "engine/io/value_reader.h"

namespace pinfield::editor {
namespace {

constexpr double finest_grid = 1e-5;  ///< metres, where no grid is wanted

/// The i-th of the numbers in a text such as "30mm" or "[0.26, 800mm]"; empty when there are not as many.
std::string_view part_of(std::string_view text, int i) {
    constexpr std::string_view between = "[], \t\r\n";
    while (true) {
        const std::size_t begin = text.find_first_not_of(between);
        if (begin == std::string_view::npos) return {};
        text.remove_prefix(begin);
        const std::size_t end = std::min(text.find_first_of(between), text.size());
        if (i-- == 0) return text.substr(0, end);
        text.remove_prefix(end);
    }
}

int decimals_of(double step) {
    const std::string text = to_text(step);
    const std::size_t point = text.find('.'), exponent = text.find("e-");
    if (exponent != std::string::npos) return std::stoi(text.substr(exponent + 2)) + (point == std::string::npos ? 0 : static_cast<int>(exponent - point - 1));
    return point == std::string::npos ? 0 : static_cast<int>(text.size() - point - 1);
}

/// n steps, as the double that the shortest decimal text of it stands for: 0.3, not 0.30000000000000004.
double multiple(double n, double step) {
    const int decimals = decimals_of(step);
    return decimals > 15 ? n * step : *parse_number(to_text(n * step, decimals));
}

int at_field(const Node& node) {
    const std::optional<int> field = node.type->find_field("at");
    return field ? *field : -1;
}

}  // namespace

double on_grid(double x, double step) {
    if (!(step > 0)) step = finest_grid;
    return multiple(std::round(x / step), step);
}

double nearest_allowed(const std::function<bool(double)>& allowed, double from, double target, double step) {
    if (allowed(target)) return target;
    const double sign = target < from ? -1 : 1;
    const auto on_the_way = [&](double n) { return on_grid(from + sign * n * step, step); };
    double good = 0, bad = std::ceil(std::fabs(target - from) / step);
    while (bad - good > 1) {
        const double middle = std::floor(0.5 * (good + bad));
        (allowed(on_the_way(middle)) ? good : bad) = middle;
    }
    return good == 0 ? from : on_the_way(good);
}

bool is_locked(const Scene& scene, const Node& node) {
    return node.get<bool>("locked") || (node.parent && is_locked(scene, *scene.find(node.parent)));
}

SetField moved(const Scene& scene, NodeId id, const Vec2& at_before, const Vec2& world_delta, const Vec2& grid) {
    const Node& node = *scene.find(id);
    const Similarity parent_from_world = node.parent ? world_from_local(scene, node.parent).inverse() : Similarity{};
    const Vec2 delta = parent_from_world.scale * parent_from_world.direction(world_delta);
    const bool turned = parent_from_world.sine != 0;
    Vec2 steps = turned ? square_grid(grid.minCoeff()) : grid;
    for (double& step : steps) step = step > 0 ? step : finest_grid;
    Vec2 at = at_before;
    for (int axis = 0; axis < 2; ++axis)
        if (std::fabs(delta[axis]) >= 0.5 * steps[axis]) at[axis] = on_grid(at_before[axis] + delta[axis], steps[axis]);
    return {id, at_field(node), at, true};
}

bool NodeDrag::begin(const Document& document, std::span<const Held> nodes, const Vec2& world) {
    if (active()) return false;
    for (Held held : nodes) {
        const Node* node = document.scene().find(held.node);
        if (!node || at_field(*node) < 0 || is_locked(document.scene(), *node)) continue;
        held.at_before = node->get<Vec2>("at");
        held_.push_back(held);
    }
    world_before_ = world;
    return active();
}

bool NodeDrag::begin(const Document& document, NodeId node, const Vec2& world) { return begin(document, std::array{Held{node}}, world); }

std::optional<std::string> NodeDrag::update(Document& document, const Vec2& world, const Vec2& grid, bool axis_lock) {
    Vec2 delta = world - world_before_;
    if (axis_lock) delta[std::fabs(delta.x()) < std::fabs(delta.y()) ? 0 : 1] = 0;
    for (const Held& held : held_) {
        if (!document.scene().find(held.node)) continue;
        const SetField edit = moved(document.scene(), held.node, held.at_before, held.own_from_hand * delta, grid);
        if (!document.previewing() && identical(edit.value, Value(held.at_before))) continue;  // a click is no drag
        if (auto why = document.preview(edit)) return why;
    }
    return {};
}

std::optional<std::string> NodeDrag::end(Document& document) {
    std::vector<NodeId> nodes;
    for (const Held& held : std::exchange(held_, {}))
        if (document.scene().find(held.node)) nodes.push_back(held.node);
    return nodes.empty() ? std::nullopt : document.commit(move_label(document.scene(), nodes));
}

void NodeDrag::cancel(Document& document) {
    if (active()) document.cancel_preview();
    held_.clear();
}

std::optional<std::string> move_by(Document& document, std::span<const NodeId> nodes, const Vec2& world_delta, double grid) {
    std::vector<Held> held;
    for (const NodeId node : nodes) held.push_back({node});
    NodeDrag drag;
    if (!drag.begin(document, held, {0, 0})) return "nothing that can be moved is selected";
    if (auto why = drag.update(document, world_delta, square_grid(grid))) {
        drag.cancel(document);
        return why;
    }
    return drag.end(document);
}

int component_count(const Value& value) {
    if (std::holds_alternative<double>(value) || std::holds_alternative<std::int64_t>(value)) return 1;
    if (std::holds_alternative<Vec2>(value)) return 2;
    if (const auto* points = std::get_if<std::vector<Vec2>>(&value)) return 2 * static_cast<int>(points->size());
    return 0;
}

double component(const Value& value, int index) {
    if (const double* number = std::get_if<double>(&value)) return *number;
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
    if (const Vec2* pair = std::get_if<Vec2>(&value)) return (*pair)[index];
    return at(std::get<std::vector<Vec2>>(value), index / 2)[index % 2];
}

Value with_component(Value value, int index, double x) {
    if (double* number = std::get_if<double>(&value)) *number = x;
    else if (auto* integer = std::get_if<std::int64_t>(&value)) *integer = static_cast<std::int64_t>(std::llround(x));
    else if (Vec2* pair = std::get_if<Vec2>(&value)) (*pair)[index] = x;
    else at(std::get<std::vector<Vec2>>(value), index / 2)[index % 2] = x;
    return value;
}

double scrub_step(const FieldType& field, double value) {
    if (field.kind == FieldKind::integer) return std::max(1.0, std::round(field.meta.step));
    if (field.meta.step > 0) return field.meta.step;
    double step = field.meta.unit == Unit::metre ? 0.001 : 0.01;
    while (std::fabs(value) >= 1000 * step && step < 1e6) step *= 10;
    return step;
}

Result<Value> value_of(const FieldType& field, std::string_view text) {
    const bool list = field.kind == FieldKind::vec2 || field.kind == FieldKind::points || field.kind == FieldKind::names ||
                      field.kind == FieldKind::choices;
    std::string written(text);
    if (field.kind == FieldKind::vec2 && !written.starts_with('[')) written = "[" + written + "]";
    const SourceText source("", written);
    YamlTree tree;
    if (list) tree = read_yaml(source);
    YamlNode scalar;
    scalar.kind = YamlKind::scalar;
    scalar.text = written;
    scalar.span = {0, written.size()};
    if (list && !tree.root) return failure(tree.diagnostics.empty() ? "type a value" : tree.diagnostics.front().message);
    const Catalog none;
    const Limits limits;
    Diagnostics diagnostics;
    ReadContext context{&source, none, limits, diagnostics};
    std::optional<Value> value = read_value(context, field, list ? tree.root->resolved() : scalar);
    if (value) return std::move(*value);
    return failure(diagnostics.empty() ? "no such value" : diagnostics.front().message);
}

std::string text_of(const Document& document, NodeId id, int field) {
    const Node& node = *document.scene().find(id);
    const FieldSlot& slot = at(node.fields, field);
    const FieldType& type = at(node.type->fields, field);
    const std::string_view written = slot.is_explicit ? document.scene().sources.slice(slot.where) : std::string_view();
    const auto spell = [&](int i) { return write_quantity(component(slot.value, i), type.meta.unit, part_of(written, i)); };
    const auto spell_pair = [&](int i) { return fmt::format("[{}, {}]", spell(i), spell(i + 1)); };
    switch (type.kind) {
        case FieldKind::boolean: return std::get<bool>(slot.value) ? "true" : "false";
        case FieldKind::integer: return fmt::format("{}", std::get<std::int64_t>(slot.value));
        case FieldKind::number: return spell(0);
        case FieldKind::vec2: return spell_pair(0);
        case FieldKind::points: {
            std::vector<std::string> pairs;
            for (int i = 0; i < component_count(slot.value); i += 2) pairs.push_back(spell_pair(i));
            return fmt::format("[{}]", fmt::join(pairs, ", "));
        }
        case FieldKind::choices:
        case FieldKind::names: return fmt::format("[{}]", fmt::join(std::get<std::vector<std::string>>(slot.value), ", "));
        default: return std::get<std::string>(slot.value);
    }
}

std::optional<std::string> set_from_text(Document& document, NodeId id, int field, std::string_view text) {
    const Node* node = document.scene().find(id);
    if (!node) return "the node no longer exists";
    const Result<Value> value = value_of(at(node->type->fields, field), text);
    if (!value) return value.error().message;
    return document.edit({id, field, *value, true}, change_label(document.scene(), id, field));
}

std::string move_label(const Scene& scene, std::span<const NodeId> nodes) {
    return nodes.size() == 1 ? fmt::format("Move {}", scene.path(nodes.front())) : fmt::format("Move {} nodes", nodes.size());
}

std::string change_label(const Scene& scene, NodeId node, int field) {
    const std::string_view key = at(scene.find(node)->type->fields, field).key;
    return fmt::format("Change {} of {}", key, scene.path(node));
}

}  // namespace pinfield::editor
