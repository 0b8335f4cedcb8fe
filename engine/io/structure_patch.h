// Edits of a table's structure as changes of the author's text: whole items move with the comments that belong to them.
#pragma once
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/io/table_reader.h"
#include "engine/io/text_patch.h"
#include "engine/scene/edit.h"

namespace pinfield {

/// Patches, each of what those before it left, that make the text say any edit but SetField. Nothing is proven: patch_for() does that.
/// Fails with the reason where no text is known for it.
Result<std::vector<TextPatch>> structure_patches(const Reading& now, const Edit& edit);

/// A node as the author wrote it: one item of a list, with the comments that belong to it, the dash in the first column.
Result<std::string> text_of_node(const Reading& now, NodeId node);

}  // namespace pinfield
