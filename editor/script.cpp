#include "editor/script.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "editor/edit_tools.h"
#include "editor/structure_tools.h"
#include "engine/core/at.h"
#include "engine/core/numbers.h"
#include "engine/io/quantity.h"

namespace pinfield::editor {
namespace {

constexpr int settling_frames = 3;
constexpr int drawn_frames = 2;  ///< until a picture shows what was done before it

struct Target {
    const Node* node = nullptr;
    int field = -1;
    std::string why;
};

Target find_target(const ScriptStep& step, const AppState& state) {
    const Node* node = state.document.scene().find(step.node);
    if (!node) return {nullptr, -1, fmt::format("there is no node {}", step.node)};
    const std::optional<int> field = node->type->find_field(step.field);
    if (!field) return {node, -1, fmt::format("{} has no field {}", step.node, step.field)};
    return {node, *field, {}};
}

/// Something countable that is no field of the scene; words come as 0 and 1, but for the selection's name.
std::optional<std::string> quantity(const ScriptStep& step, const AppState& state) {
    const auto count = [](auto n) { return fmt::format("{}", n); };
    const auto truth = [](bool yes) { return std::string(yes ? "true" : "false"); };
    if (step.node == "editor") {
        if (step.field == "dirty") return truth(state.document.dirty());
        if (step.field == "playing") return truth(state.session.playing());
        if (step.field == "hits") return count(state.session.hits());
        if (step.field == "drained") return count(state.session.drained());
        if (step.field == "balls") return count(state.session.world().balls().size());
        if (step.field == "problems") return count(state.document.diagnostics().size() + state.session.problems().size());
        if (step.field == "undo_steps") return count(state.document.undo_steps());
        if (step.field == "selection")
            return state.selection.empty() ? std::string("none") : state.document.scene().path(state.selection.primary());
        return {};
    }
    if (step.node == "underlay") {
        const Underlay& underlay = state.aids.underlay;
        if (step.field == "there") return truth(state.underlay.bitmap != nullptr);
        if (step.field == "width") return to_text(1000 * underlay.width, 3);
        if (step.field == "x") return to_text(1000 * underlay.centre.x(), 3);
        if (step.field == "y") return to_text(1000 * underlay.centre.y(), 3);
        if (step.field == "opacity") return to_text(underlay.opacity, 2);
    }
    if (step.node == "preferences")
        for (const PreferenceField& field : preference_fields())
            if (field.key == step.field) return field.text(state.preferences);
    const Node* node = state.document.scene().find(step.node);
    if (node && step.field == "hits") return count(state.session.hits_of(node->id));
    return {};
}

/// "3" against "3", ">= 1", "< 5"; words only as they are.
bool satisfies(const std::string& found, std::string_view wanted) {
    constexpr std::array<std::string_view, 6> comparisons = {"==", "!=", "<=", ">=", "<", ">"};
    std::string_view comparison = "==";
    for (const std::string_view c : comparisons)
        if (wanted.starts_with(c)) {
            comparison = c;
            wanted.remove_prefix(c.size());
            break;
        }
    wanted.remove_prefix(std::min(wanted.find_first_not_of(' '), wanted.size()));
    const std::optional<double> x = parse_number(found), y = parse_number(wanted);
    if (!x || !y) return comparison == "!=" ? found != wanted : comparison == "==" && found == wanted;
    if (comparison == "==") return *x == *y;
    if (comparison == "!=") return *x != *y;
    if (comparison == "<=") return *x <= *y;
    if (comparison == ">=") return *x >= *y;
    return comparison == "<" ? *x < *y : *x > *y;
}

bool near(const Value& a, const Value& b, double tolerance) {
    if (component_count(a) != component_count(b) || component_count(a) == 0) return identical(a, b);
    for (int i = 0; i < component_count(a); ++i)
        if (!(std::fabs(component(a, i) - component(b, i)) <= tolerance)) return false;
    return true;
}

}  // namespace

std::optional<std::string> unmet(const ScriptStep& step, const AppState& state) {
    if (const auto found = quantity(step, state)) {
        if (satisfies(*found, step.value)) return {};
        return fmt::format("{}.{} is {}, not {}", step.node, step.field, *found, step.value);
    }
    const Target target = find_target(step, state);
    if (!target.why.empty()) return target.why;
    const FieldType& field = at(target.node->type->fields, target.field);
    const Result<Value> wanted = value_of(field, step.value);
    if (!wanted) return fmt::format("{}: {}", step.value, wanted.error().message);
    double tolerance = 0;
    if (!step.tolerance.empty()) {
        const QuantityResult read = read_quantity(step.tolerance, field.meta.unit);
        if (!read) return fmt::format("tolerance: {}", read.error().message);
        tolerance = read->value;
    }
    if (near(at(target.node->fields, target.field).value, *wanted, tolerance)) return {};
    return fmt::format("{}.{} is {}, not {}", step.node, step.field, text_of(state.document, target.node->id, target.field), step.value);
}

ScriptRunner::ScriptRunner(SourceText source, Script script)
    : source_(std::move(source)), script_(std::move(script)), frames_to_settle_(settling_frames) {}

int ScriptRunner::before_frame(AppState& state, ScriptHost& host) {
    ++frames_since_click_;
    if (frames_to_settle_ > 0) {
        --frames_to_settle_;
        return 0;
    }
    while (!done()) {
        const Frame frame = state.quit ? fail("the editor was closed before this step") : run(script_.steps[index_], state, host);
        if (done()) return 0;
        if (frame) {
            ++frame_;
            ticks_run_ += *frame;
            return *frame;
        }
        ++index_;
        frame_ = ticks_run_ = 0;
    }
    return 0;
}

ScriptRunner::Frame ScriptRunner::run(const ScriptStep& step, AppState& state, ScriptHost& host) {
    using Kind = ScriptStep::Kind;
    switch (step.kind) {
        case Kind::action: return run_action(step, state);
        case Kind::set: return run_set(step, state);
        case Kind::wait: return run_wait(step.ticks, host);
        case Kind::screenshot: return run_screenshot(step, host);
        case Kind::expect: return run_expect(step, state);
        case Kind::insert:
        case Kind::paste:
        case Kind::remove:
        case Kind::move:
        case Kind::wrap:
        case Kind::unwrap:
        case Kind::rename:
        case Kind::select: return run_structure(step, state);
        case Kind::click:
        case Kind::drag:
        case Kind::scroll:
        case Kind::type:
        case Kind::key: return run_hand(step, state, host);
    }
    return {};
}

ScriptRunner::Frame ScriptRunner::run_action(const ScriptStep& step, AppState& state) {
    if (!find_action(step.name)) return fail(fmt::format("there is no action {}", step.name));
    if (!enabled(state, step.name)) return fail(fmt::format("{} cannot be done now", step.name));
    state.message.clear();
    state.message_is_problem = false;
    editor::run(state, step.name);
    if (state.message_is_problem) return fail(state.message);
    return {};
}

ScriptRunner::Frame ScriptRunner::run_set(const ScriptStep& step, AppState& state) {
    const Target target = find_target(step, state);
    if (!target.why.empty()) return fail(target.why);
    if (const auto why = set_from_text(state.document, target.node->id, target.field, step.value)) return fail(*why);
    return {};
}

std::optional<std::vector<NodeId>> ScriptRunner::nodes_of(const ScriptStep& step, const AppState& state) {
    std::vector<NodeId> out;
    for (const std::string& name : step.nodes.empty() ? std::vector{step.node} : step.nodes) {
        const Node* node = state.document.scene().find(name);
        if (!node) return fail(fmt::format("there is no node {}", name)), std::nullopt;
        out.push_back(node->id);
    }
    return out;
}

ScriptRunner::Frame ScriptRunner::run_structure(const ScriptStep& step, AppState& state) {
    using Kind = ScriptStep::Kind;
    const Scene& scene = state.document.scene();
    const Node* parent = step.parent.empty() ? nullptr : scene.find(step.parent);
    if (!parent && !step.parent.empty()) return fail(fmt::format("there is no node {}", step.parent));
    const NodeId into = parent ? parent->id : NodeId{};
    const Spot spot{into, step.index < 0 ? static_cast<int>(scene.children_of(into).size()) : step.index};
    if (step.kind == Kind::insert || step.kind == Kind::paste) {
        take(state,
             paste_text(state.document, step.value, step.kind == Kind::insert ? spot : spot_after(scene, state.selection.nodes()), {}));
        return state.message_is_problem ? fail(state.message) : Frame{};
    }
    const auto nodes = nodes_of(step, state);
    if (!nodes) return {};
    const NodeType* type = step.kind == Kind::wrap ? state.catalog->find(step.name) : nullptr;
    if (step.kind == Kind::wrap && !type) return fail(fmt::format("no node is called {}", step.name));
    if (step.kind == Kind::select) return select(state, *nodes), Frame{};
    if (step.kind == Kind::remove) take(state, remove_nodes(state.document, *nodes));
    else if (step.kind == Kind::unwrap) take(state, unwrap_nodes(state.document, *nodes));
    else if (step.kind == Kind::wrap) take(state, wrap_nodes(state.document, *nodes, *type));
    else if (step.kind == Kind::move) take(state, move_nodes(state.document, *nodes, spot, true));
    else take(state, rename_node(state.document, nodes->front(), step.name));
    return state.message_is_problem ? fail(state.message) : Frame{};
}

ScriptRunner::Frame ScriptRunner::run_wait(int ticks, const ScriptHost& host) {
    if (ticks_run_ >= ticks) return {};
    return std::min(host.ticks_per_frame(), ticks - ticks_run_);
}

ScriptRunner::Frame ScriptRunner::run_screenshot(const ScriptStep& step, ScriptHost& host) {
    if (frame_ < drawn_frames) return 0;
    const Result<bool> written = host.screenshot(step.name);
    if (!written) return fail(written.error().message);
    return {};
}

ScriptRunner::Frame ScriptRunner::run_expect(const ScriptStep& step, const AppState& state) {
    if (const auto why = unmet(step, state)) return fail(*why);
    return {};
}

ScriptRunner::Frame ScriptRunner::fail(const std::string& why) {
    const ScriptStep& step = script_.steps[index_];
    const LineColumn place = source_.line_column(step.where.span.begin);
    failure_ = fmt::format("{}:{}:{}: step {} ({}): {}", source_.name(), place.line, place.column, index_ + 1,
                           word_of(step.kind), why);
    return {};
}

}  // namespace pinfield::editor
