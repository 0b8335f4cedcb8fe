// Materials, inputs and tests put into the author's text and taken out, in sections that may be empty or not yet there. Indices are those
// of the section's entries.
#pragma once
#include "engine/core/result.h"
#include "engine/io/rewriting.h"
#include "engine/scene/edit.h"

namespace pinfield {

Result<void> insert_material(Rewriting& text, const Node& material, int index);

/// "gap: 46mm".
Result<void> insert_param(Rewriting& text, int index, const std::string& entry);
/// "gear:" and the lines below it, behind those that there are.
Result<void> insert_template(Rewriting& text, const std::string& lines);

Result<void> insert_input(Rewriting& text, const InsertInput& edit);
Result<void> remove_input(Rewriting& text, const RemoveInput& edit);
Result<void> set_keys(Rewriting& text, const Scene& scene, const SetKeys& edit);

Result<void> insert_test(Rewriting& text, const InsertTest& edit);
Result<void> remove_test(Rewriting& text, const RemoveTest& edit);
Result<void> rename_test(Rewriting& text, const RenameTest& edit);

}  // namespace pinfield
