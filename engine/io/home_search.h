// Numbers tried at a place of the text until a field that comes from there has the value that is due.
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "engine/core/result.h"
#include "engine/io/field_patch.h"
#include "engine/io/table_reader.h"
#include "engine/io/text_patch.h"
#include "engine/scene/edit.h"

namespace pinfield {

/// Is it a number or a point?
bool is_number(const Value& value);

/// Does the text of the edit's value, or the node's line where there is none, stand for this node as well?
bool is_same_line(const Scene& scene, const SetField& edit, const Node& other);

/// The text with one splice, read again. Fails where it does not read, where nodes came or went, and where values changed that neither a
/// maker nor an expression gives. Nodes have the ids they had.
Result<PatchedText> read_home(const Reading& now, const Splice& splice, const Limits& limits);

/// The trial whose number makes the field what the edit says: `name` is at `start` now. Of a point, the part that is an expression; the other
/// is then set where it stands.
Result<PatchedText> solve_number(const Reading& now, const SetField& edit, std::optional<double> start, const std::string& name,
                                 const std::function<Result<PatchedText>(double)>& trial, const Limits& limits);

/// The value's own text changed, wherever it stands. What a copy or a reflection makes of it is found by trying: it moves, turns and mirrors.
Result<PatchedText> patch_line(const Reading& now, const SetField& edit, const Limits& limits);

}  // namespace pinfield
