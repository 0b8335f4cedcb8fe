// What several nodes have in common: fields of one name, kind and unit. A change of such a field changes it in all of them, as one undo
// step. No window, no ImGui.
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "editor/document.h"

namespace pinfield::editor {

/// A field of one node.
struct FieldOf {
    NodeId node;
    int field = 0;
};

/// A field that all of some nodes have, in their order; never empty.
using SharedField = std::vector<FieldOf>;

/// The fields of `shown` that all the nodes have alike (key, kind, unit and words to choose from), `shown` first; of one node alone: all of
/// its fields. A field that is a node's own id is shared by none.
std::vector<SharedField> shared_fields(const Scene& scene, NodeId shown, std::span<const NodeId> nodes);

/// Are the values not all the same? `component`: judged by that number alone, where all have it; -1: by the whole.
bool is_mixed(const Scene& scene, std::span<const FieldOf> fields, int component = -1);
/// Does the file give a value for any of them?
bool any_explicit(const Scene& scene, std::span<const FieldOf> fields);

/// What a node's value becomes; nothing: the node stays as it is.
using ValueChange = std::function<std::optional<Value>(const Value& before)>;

// One undo step each. Why it was not done, or nothing; where there is a reason nothing has changed.
std::optional<std::string> change_all(Document& document, std::span<const FieldOf> fields, const ValueChange& change);
std::optional<std::string> set_all(Document& document, std::span<const FieldOf> fields, const Value& value, bool is_explicit = true);
/// One number of each; nodes that have no such number (a shorter list of points) stay as they are.
std::optional<std::string> set_component_of_all(Document& document, std::span<const FieldOf> fields, int component, double x);
/// From text as the file spells it: "30mm", "[0.26, 800mm]", "crimson".
std::optional<std::string> set_all_from_text(Document& document, std::span<const FieldOf> fields, std::string_view text);
/// Out of the file, so that the default holds.
std::optional<std::string> reset_all(Document& document, std::span<const FieldOf> fields);

/// "Change radius of pop", "Change radius of 3 nodes".
std::string change_label(const Scene& scene, std::span<const FieldOf> fields);

/// The nodes that name a material or an input in a field of theirs, in the order of the file.
std::vector<NodeId> users_of(const Scene& scene, Meaning meaning, const std::string& name);

}  // namespace pinfield::editor
