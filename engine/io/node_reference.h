// The reference of all nodes, generated from the catalogue: what `pinfield nodes` prints.
#pragma once
#include <string>
#include <vector>

#include "engine/reflect/catalogue.h"

namespace pinfield {

/// The scene nodes of a catalogue (shapes, operations, parts), in its order; with a key, just that type, a record too.
/// Empty when there is no such key.
std::vector<const NodeType*> referenced_types(const Catalogue& catalogue, const std::string& key = {});

/// For a terminal: one paragraph a node.
std::string reference_text(const std::vector<const NodeType*>& types);
/// A section with a table a node; the common fields once, at the end.
std::string reference_markdown(const std::vector<const NodeType*>& types);
/// An array of {key, kind, doc, exactness, fields, children}; what has no bound or no default is null.
std::string reference_json(const std::vector<const NodeType*>& types);

}  // namespace pinfield
