// A param's number, set as a slider sets it.
#pragma once
#include <optional>
#include <string>

#include "engine/core/result.h"
#include "engine/io/table_reader.h"
#include "engine/io/text_patch.h"

namespace pinfield {

/// Why no hand may set the param to this value (m, deg, s, kg and what they make), or nothing: there is none of this name, it is calculated
/// from others, or the value leaves its range.
std::optional<std::string> why_not_set(const Scene& scene, const std::string& name, double value);

/// The table with this value of a param, as though the text said it; its nodes have the ids they have now. Fails with what is wrong then.
Result<Scene> scene_with_param(const Reading& now, const std::string& name, double value, const Limits& limits = {});

/// The text with this value of a param, in its unit and decimals: nothing else of it changes. Read again, it is scene_with_param().
Result<PatchedText> patch_param(const Reading& now, const std::string& name, double value, const Limits& limits = {});

}  // namespace pinfield
