// Everything that can be done or gone to, found by a few letters: the actions of the one table, and the nodes of the scene.
#pragma once
#include <string>
#include <vector>

#include "editor/app_state.h"

namespace pinfield::editor {

struct Command {
    std::string_view action{};  ///< empty: a node
    NodeId node{};
    std::string title{};
    std::string detail{};       ///< an action's menu; a node's type and path
};

/// Actions in the order of their table, but for the answers to open questions; then nodes in the order of the file.
std::vector<Command> all_commands(const AppState& state);

struct FoundCommand {
    std::size_t index = 0;              ///< among the commands
    int score = 0;
    std::vector<std::size_t> places{};  ///< of the query's letters in the title; none where the detail was what matched
};
/// Best first; all, in their order, for an empty query.
std::vector<FoundCommand> find_commands(const std::vector<Command>& commands, std::string_view query);

bool enabled(const AppState& state, const Command& command);
/// Runs the action; selects the node, and frames it where it is not in the view.
void run(AppState& state, const Command& command);

}  // namespace pinfield::editor
