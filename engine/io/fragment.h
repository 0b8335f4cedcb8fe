// Nodes without a table: what is cut, copied and pasted.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/io/table_reader.h"
#include "engine/scene/scene.h"

namespace pinfield {

/// A node that is in no scene yet, and the author's text of it: one item of a list, its dash in the first column.
struct Fragment {
    Subtree nodes;
    std::string text;
};

/// The nodes of a text that was copied from a table or written by hand: a list of nodes, or one node alone. Fails with line, column and
/// hint of the first error. Params and templates are those of the table that the nodes are for; names of materials and inputs are looked up
/// only where the nodes are put.
Result<std::vector<Fragment>> read_fragments(const std::string& text, const Reading& table);

/// The same node with other ids, in its text too: `new_id` is asked for each that it has, in the order of the text.
Result<Fragment> with_ids(const Fragment& fragment, const std::function<std::string(const std::string&)>& new_id, const Reading& table);

}  // namespace pinfield
