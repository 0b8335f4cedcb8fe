// Where a value is written that a template, a copy or an expression gives.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "editor/edit_tools.h"
#include "editor/handlers.h"
#include "engine/core/at.h"
#include "engine/io/said_once.h"

namespace pinfield::editor {
namespace {

constexpr std::size_t most_homes = 6;

const Node* selected_maker(const AppState& state) {
    const Scene& scene = state.document.scene();
    const Node* node = scene.find(state.selection.primary());
    return node && !node->is_record() ? maker_of(scene, node->id) : nullptr;
}

void write_out(AppState& state) {
    const NodeId maker = selected_maker(state)->id;
    const std::string label = fmt::format("Write out {}", state.document.scene().path(maker));
    if (take_patched(state, patch_written_out(state.document.reading(), maker), label)) select(state, maker);
}

/// The selected nodes in the order in which they stand.
std::vector<NodeId> selected_in_order(const AppState& state) {
    std::vector<NodeId> nodes = state.selection.nodes();
    const Scene& scene = state.document.scene();
    std::sort(nodes.begin(), nodes.end(), [&](NodeId a, NodeId b) { return scene.index_of(a) < scene.index_of(b); });
    return nodes;
}

void make_template(AppState& state) {
    const std::vector<NodeId> nodes = selected_in_order(state);
    const Node& first = *state.document.scene().find(nodes.front());
    const std::string name = free_name_for(state.document.reading(), fmt::format("{}_template", first.name.empty() ? first.type->key() : first.name));
    if (take_patched(state, patch_to_template(state.document.reading(), nodes, name), fmt::format("Make the template {}", name)))
        select(state, state.document.scene().find(nodes.front())->parent);
}

bool has_own_nodes(const AppState& state) {
    const Node* node = state.document.scene().find(state.selection.primary());
    return has_selection(state) && node && !node->is_record() && !node->origin;
}

template <std::size_t n>
bool has_home(const AppState& state) { return state.home && state.home->homes.size() > n; }

template <std::size_t n>
void answer(AppState& state) {
    const HomeQuestion question = *std::exchange(state.home, std::nullopt);
    const std::string label = change_label(state.document.scene(), question.edit.node, question.edit.field);
    const ValueHome& home = question.homes[n];
    if (const auto why = state.document.edit_home(question.edit, home, label)) return say(state, *why, true);
    say(state, fmt::format("{}: {}", label, home.told));
}

}  // namespace

bool take_patched(AppState& state, Result<PatchedText> patched, const std::string& label) {
    const auto why = state.document.take_patched(std::move(patched), label);
    say(state, why.value_or(label), why.has_value());
    return !why;
}

void make_param(AppState& state, NodeId node, int field, int part) {
    const Node& of = *state.document.scene().find(node);
    const FieldType& type = at(of.type->fields, field);
    const std::string axis = std::holds_alternative<Vec2>(at(of.fields, field).value) ? (part == 0 ? "_x" : "_y") : "";
    const std::string name = free_name_for(state.document.reading(), fmt::format("{}_{}{}", of.name.empty() ? of.type->key() : of.name, type.key, axis));
    take_patched(state, patch_to_param(state.document.reading(), node, field, part, name), fmt::format("Make the param {}", name));
}

void write_out_param(AppState& state, const std::string& name) {
    take_patched(state, patch_inlined(state.document.reading(), name), fmt::format("Write out {}", name));
}

void ask_for_home(AppState& state) {
    auto question = state.document.take_home_question();
    if (!question || asks(state)) return;
    // The nearest are kept, and the last one: writing it out.
    std::vector<ValueHome>& homes = question->homes;
    if (homes.size() > most_homes) homes.erase(homes.begin() + static_cast<std::ptrdiff_t>(most_homes) - 2, homes.end() - 2);
    state.home = std::move(question);
    say(state, {});  // the question says it
}

std::span<const Handler> home_handlers() {
    static const Handler handlers[] = {
        {"home.1", has_home<0>, answer<0>},
        {"home.2", has_home<1>, answer<1>},
        {"home.3", has_home<2>, answer<2>},
        {"home.4", has_home<3>, answer<3>},
        {"home.5", has_home<4>, answer<4>},
        {"home.6", has_home<5>, answer<5>},
        {"home.cancel", has_home<0>, [](AppState& s) { s.home.reset(); }},
        {"edit.write_out", [](const AppState& s) { return !s.document.previewing() && selected_maker(s); }, write_out},
        {"edit.make_template", has_own_nodes, make_template},
        {"edit.ask_homes", [](const AppState& s) { return s.document.remembers_homes(); },
         [](AppState& s) {
             s.document.forget_homes();
             say(s, "The next value that stands elsewhere is asked about");
         }},
    };
    return handlers;
}

}  // namespace pinfield::editor
