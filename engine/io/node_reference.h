// What a catalog holds, for people and for programs.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "engine/reflect/catalog.h"

namespace pinfield {

/// All scene nodes, or the one node or record of this key; empty when there is none.
std::vector<const NodeType*> referenced_types(const Catalog& catalog, std::string_view key = {});

/// [{key, kind, doc, exactness: {outside, inside, lipschitz}, fields: [{key, type, unit, default, min, min_open, doc}],
/// children: {min, max}}]; null for an infinite bound, for any number of children and for the default of a required
/// field.
std::string reference_json(const std::vector<const NodeType*>& types);
std::string reference_markdown(const std::vector<const NodeType*>& types);
/// A table of the type's own fields and, below it, its contracts; empty where it has neither.
std::string fields_markdown(const NodeType& type);
/// "none", "2 or more".
std::string children_text(const NodeType& type);
std::string reference_text(const std::vector<const NodeType*>& types);

/// What a number may be followed by, as text or Markdown.
std::string units_text();
std::string units_markdown();

}  // namespace pinfield
