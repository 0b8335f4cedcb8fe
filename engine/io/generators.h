// Items that make several nodes: `use` of a template, `copies`, and `pair`. Each makes a group, so that one item is one node among its
// siblings; the nodes in the group know where they come from, and no edit touches them one by one.
#pragma once
#include "engine/io/node_reader.h"

namespace pinfield {

/// Do copies or a pair belong to the item?
bool is_repeated(const NodeItem& item);

/// Reads an item with copies or a pair: a group of them, each read with the number `i` in its expressions. A pair is the outer of the two.
void read_repeated(ReadContext& context, Scene& scene, NodeId parent, const NodeItem& item);

/// Reads the nodes of the template that an item uses into its group, whose fields have been read.
void read_template(ReadContext& context, Scene& scene, Node& group, const NodeItem& item);

/// The item in one line, without comments and aliases.
std::string line_of(const ReadContext& context, const NodeItem& item);

}  // namespace pinfield
