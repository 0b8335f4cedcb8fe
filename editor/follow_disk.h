// What is done when the table's file changes under the editor, and the question where both have changed the same.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "editor/document.h"

namespace pinfield::editor {

/// The question: for each conflict whose version is taken.
struct MergeQuestion {
    std::shared_ptr<const DiskMerge> merge;
    std::vector<Whose> taken;  ///< of each of its conflicts; mine at first
    std::size_t row = 0;       ///< that the keys are for
};

}  // namespace pinfield::editor
