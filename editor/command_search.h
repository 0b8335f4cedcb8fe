// Everything that can be done or gone to, found by a few letters: the actions of the one table, the nodes of the scene, and what can be added
// or made of what is selected.
#pragma once
#include <string>
#include <vector>

#include "editor/app_state.h"

namespace pinfield::editor {

/// What a command does with a node type.
enum class TypeUse : unsigned char { add, wrap, become };

/// One of three: an action, a node to go to, or a type to use.
struct Command {
    std::string_view action{};
    NodeId node{};
    std::string title{};
    std::string detail{};       ///< an action's menu; a node's type and path; a type's kind
    const NodeType* type = nullptr;
    TypeUse use = TypeUse::add;
};

/// Actions in the order of their table, but for the answers to open questions; nodes in the order of the file; types by name, and last what
/// the selected node could become.
std::vector<Command> all_commands(const AppState& state);

struct FoundCommand {
    std::size_t index = 0;              ///< among the commands
    int score = 0;
    std::vector<std::size_t> places{};  ///< of the query's letters in the title; none where the detail was what matched
};
/// Best first; all, in their order, for an empty query.
std::vector<FoundCommand> find_commands(const std::vector<Command>& commands, std::string_view query);

bool enabled(const AppState& state, const Command& command);
/// Runs the action; selects the node, and frames it where it is not in the view; adds, wraps or changes.
void run(AppState& state, const Command& command);

}  // namespace pinfield::editor
