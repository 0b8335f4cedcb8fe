// What stands in the text made a thing with a name that is said once, and back: a number a param, nodes a template.
#pragma once
#include <span>
#include <string>

#include "engine/core/result.h"
#include "engine/io/table_reader.h"
#include "engine/io/text_patch.h"

namespace pinfield {

/// A number of a field made a param of this name, which the number's place then calls. `part`: which of a point's numbers, else 0. Every value
/// stays. Fails where the number is an expression already, or the name is taken.
Result<PatchedText> patch_to_param(const Reading& now, NodeId node, int field, int part, const std::string& name, const Limits& limits = {});

/// The param's own text wherever its name is called, and no param any more. Every value stays.
Result<PatchedText> patch_inlined(const Reading& now, const std::string& param, const Limits& limits = {});

/// Neighbours of the scene or of a group made a template of this name, used once in their place. They keep their ids and comments.
Result<PatchedText> patch_to_template(const Reading& now, std::span<const NodeId> nodes, const std::string& name, const Limits& limits = {});

/// A name like this one that no param, input, id, material or template has.
std::string free_name_for(const Reading& now, const std::string& like);

}  // namespace pinfield
