// Edits as the smallest change of the author's text, proven by reading it again.
#pragma once
#include <string>

#include "engine/core/result.h"
#include "engine/core/source_text.h"
#include "engine/io/limits.h"
#include "engine/scene/edit.h"

namespace pinfield {

/// Puts `text` in the place of `replaced`; every other byte stays.
struct TextPatch {
    Span replaced;
    std::string text;
};

std::string apply(const TextPatch& patch, const std::string& text);

/// The patch that takes `patch` back, byte for byte; `text` is the text before it.
TextPatch inverse(const TextPatch& patch, const std::string& text);

/// The patch that makes `source` say what `edit` makes of the scene `before`, which was read from it. A changed value
/// keeps its unit, decimals and quotes; a new field takes its neighbours' style. The patched text has been read and is
/// the same scene with exactly that change; where no such patch is known, the failure says why.
Result<TextPatch> patch_for(const SourceText& source, const Scene& before, const Edit& edit, const Limits& limits = {});

}  // namespace pinfield
