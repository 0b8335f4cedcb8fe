// Fields whose text an anchor lends to other places of the file: changed for all of them, or written out and changed at one.
#pragma once
#include <optional>
#include <string>

#include "engine/core/result.h"
#include "engine/io/table_reader.h"
#include "engine/io/text_patch.h"
#include "engine/scene/edit.h"

namespace pinfield {

/// What a field's text is shared through.
struct SharedText {
    std::string anchor;  ///< its name
    int places = 0;      ///< that have it, this one included
};
std::optional<SharedText> shared_text(const Reading& now, const SetField& edit);

/// At the anchor: every place that has it says the new value, and nothing else changes. Fails where one of them cannot.
Result<PatchedText> patch_everywhere(const Reading& now, const SetField& edit);

/// At this place alone: it gets a copy of its own of what was shared. An anchor that stands here goes to the next place that names it.
Result<PatchedText> patch_here(const Reading& now, const SetField& edit);

}  // namespace pinfield
