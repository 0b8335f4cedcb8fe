#include "editor/command_search.h"

#include <algorithm>
#include <optional>

#include "editor/fuzzy_match.h"
#include "editor/pick.h"

namespace pinfield::editor {
namespace {

constexpr int in_detail = -12, across_both = -6;  ///< titles are what people read

/// It goes with a question that is open.
bool is_answer(std::string_view action) {
    if (action == "merge.ask") return false;
    for (const std::string_view question : {"merge.", "shared.", "home."})
        if (action.starts_with(question)) return true;
    return action.starts_with("prompt.") || action.starts_with("dialog.") || action.starts_with("recover.") || action.ends_with(".cancel") ||
           action.ends_with(".close");
}

std::optional<FoundCommand> found_in(const Command& command, std::size_t index, std::string_view query) {
    const auto both = fuzzy_match(command.title + " " + command.detail, query);
    if (!both) return {};
    auto title = fuzzy_match(command.title, query);
    const auto detail = fuzzy_match(command.detail, query);
    const int otherwise = std::max(both->score + across_both, detail ? detail->score + in_detail : both->score + across_both);
    if (title && title->score >= otherwise) return FoundCommand{index, title->score, std::move(title->places)};
    return FoundCommand{index, otherwise, {}};
}

void add_types(std::vector<Command>& commands, std::string_view verb, const std::vector<const NodeType*>& types, TypeUse use) {
    for (const NodeType* type : types)
        commands.push_back({{}, {}, std::string(verb) + std::string(type->key()), std::string(name(type->meta.kind)), type, use});
}

}  // namespace

std::vector<Command> all_commands(const AppState& state) {
    std::vector<Command> commands;
    for (const Action& action : all_actions())
        if (!is_answer(action.name)) commands.push_back({action.name, {}, std::string(action.label), std::string(action.menu)});
    const Scene& scene = state.document.scene();
    const std::map<NodeId, std::string> paths = scene.paths();
    for (const NodeId id : scene.all()) {
        const Node& node = *scene.find(id);
        const std::string type(node.type->key()), title = node.name.empty() ? paths.at(id) : node.name;
        const std::string within = node.parent && !node.name.empty() ? " in " + paths.at(node.parent) : "";
        commands.push_back({{}, id, title, (title == type ? "" : type) + within});
    }
    for (const NodeKind kind : {NodeKind::part, NodeKind::shape, NodeKind::operation})
        add_types(commands, "Add ", types_of(*state.catalog, kind), TypeUse::add);
    if (state.selection.empty()) return commands;
    add_types(commands, "Put in ", types_of(*state.catalog, NodeKind::operation), TypeUse::wrap);
    add_types(commands, "Change to ", types_for(scene, *state.catalog, state.selection.primary()), TypeUse::become);
    return commands;
}

std::vector<FoundCommand> find_commands(const std::vector<Command>& commands, std::string_view query) {
    std::vector<FoundCommand> found;
    for (std::size_t i = 0; i < commands.size(); ++i)
        if (auto one = found_in(commands[i], i, query)) found.push_back(std::move(*one));
    if (query.find_first_not_of(' ') == std::string_view::npos) return found;
    std::stable_sort(found.begin(), found.end(), [&](const FoundCommand& a, const FoundCommand& b) {
        if (a.score != b.score) return a.score > b.score;
        return commands[a.index].title.size() < commands[b.index].title.size();
    });
    return found;
}

bool enabled(const AppState& state, const Command& command) {
    if (command.type) return command.use == TypeUse::add || !state.selection.empty();
    return command.action.empty() ? state.document.scene().find(command.node) != nullptr : enabled(state, command.action);
}

void run(AppState& state, const Command& command) {
    if (!command.action.empty()) return run(state, command.action);
    if (command.type && command.use == TypeUse::add) return add_node(state, *command.type);
    if (command.type && command.use == TypeUse::wrap) return wrap_selection(state, *command.type);
    if (command.type) return void(take(state, change_type(state.document, state.selection.primary(), *command.type)));
    if (!state.document.scene().find(command.node)) return;
    select(state, command.node);
    const Box2 box = bounds_of(state, command.node), seen = state.view.window();
    if (!box.is_empty() && box.is_finite() && !(seen.contains(box.lo) && seen.contains(box.hi))) run(state, "view.frame");
}

}  // namespace pinfield::editor
