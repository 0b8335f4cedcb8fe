// One field's edit as the bytes of the author's text that it changes.
#pragma once
#include <string>

#include "engine/core/result.h"
#include "engine/io/table_reader.h"
#include "engine/io/yaml_edit.h"
#include "engine/scene/edit.h"

namespace pinfield {

/// Where a node's fields stand in the tree.
struct EntryOfNode {
    const YamlNode* owner = nullptr;  ///< the map whose entry the node is; null: the text does not mention it
    std::size_t index = 0;
};

EntryOfNode find_entry(const YamlTree& tree, const Node& node);

/// Anything on the way up from a node, or in it, that an alias repeats; or null.
const YamlNode* shared_above(const YamlNode* node);
const YamlNode* shared_below(const YamlNode& node);
/// Why what an alias repeats is not changed.
Failure shared_failure(const YamlNode& shared);

/// A number in the unit that the author uses beside a new field: what the node's fields of this unit have most often, else those of the
/// whole file; empty for a bare number.
std::string customary_number(const Scene& scene, const Node* node, Unit unit);

/// Where a new field goes: the id first and the place behind it, as people write nodes; others before the children, which are the longest
/// part of a node and stay last.
std::size_t index_for_new_field(const YamlNode& map, const FieldType& field);

/// The smallest replacement that gives a scalar or a list another value, in the style it has.
Splice value_splice(const std::string& text, const FieldType& field, const YamlNode& node, const Value& before, const Value& after);

/// The bytes that make the text say an edit of a field that is not as it should be.
Result<Splice> splice_for(const Reading& now, const Node& node, const SetField& edit);

}  // namespace pinfield
