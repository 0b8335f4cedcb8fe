// What makes a scene sound, judged in one place and in one wording for whoever asks: the reader while it reads, the compiler of any
// scene, the editor of an edit.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/diagnostic.h"
#include "engine/scene/scene.h"

namespace pinfield {

/// [a-z_][a-z0-9_]*: what ids, materials and inputs are called.
bool is_name(std::string_view text);

/// Too few or too many children for the type, said at `where`; or nothing.
std::optional<Diagnostic> wrong_child_count(const NodeType& type, int count, const Place& where);

/// A part where only shapes and operations may stand, said at `where`; or nothing. `parent`: null at the top level.
std::optional<Diagnostic> misplaced_part(const NodeType& type, const NodeType* parent, const Place& where);

/// The first contract that a node's values break, said at its key; or nothing. Ranges are each field's own matter: why_invalid().
std::optional<Diagnostic> broken_contract(const Node& node);

/// The names that fields may refer to.
struct KnownNames {
    explicit KnownNames(const Scene& scene);
    std::vector<std::string_view> materials, inputs;  ///< sorted
};

/// Appends what is wrong with the names that a field refers to: materials and inputs that there are none of. At most `most` findings.
void check_references(const KnownNames& known, const FieldType& field, const FieldSlot& slot, std::size_t most, Diagnostics& findings);

/// "the id pop is taken": nodes and inputs share their names.
std::string taken_id(std::string_view id);
/// Is there anything but `node` that goes by this name?
bool is_id_taken(const Scene& scene, std::string_view id, NodeId node);

/// What only the whole scene shows: ids said twice, names of what there is not, fields of no use, domains on one layer. Ends soon after
/// `most` findings: of a hostile file nobody reads more.
Diagnostics check_relations(const Scene& scene, std::size_t most = 100);

/// Everything above of every node: a scene without errors compiles, but for what only its geometry shows.
Diagnostics validate(const Scene& scene, std::size_t most = 100);

}  // namespace pinfield
