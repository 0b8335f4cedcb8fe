// Edits as the smallest change of the author's text, proven by reading it again.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/io/table_reader.h"
#include "engine/scene/edit.h"

namespace pinfield {

/// Puts `text` in the place of `replaced`; every other byte stays.
struct TextPatch {
    Place replaced;
    std::string text;
};

std::string apply(const TextPatch& patch, const std::string& text);

/// What edits make of the author's text.
struct PatchedText {
    std::vector<TextPatch> patches;  ///< one after the other, each of what those before it left
    Reading reading;                 ///< of the text after them; its nodes have the ids they had
    int readings = 0;                ///< how often a table was read for it: once for all fields that do not touch, and once per other edit
};

/// The patches that make the text say what `edits`, one after the other, make of the scene, both as they were read. A changed value
/// keeps its unit, decimals and quotes; a new field or node takes its neighbours' style; whole items move with their comments. The patched text has been read and is the same scene with
/// exactly these changes; where no such patch is known, the failure says why.
Result<PatchedText> patch_for(const Reading& now, std::span<const Edit> edits, const Limits& limits = {});

}  // namespace pinfield
