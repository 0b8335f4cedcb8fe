// A table's text -> a Scene, with everything that is wrong with it told at once.
#pragma once
#include <memory>

#include "engine/core/diagnostic.h"
#include "engine/io/limits.h"
#include "engine/scene/scene.h"

namespace pinfield {

/// The scene holds whatever could be understood; it is fit for use only when ok().
struct ReadResult {
    std::shared_ptr<const SourceText> source;
    Scene scene;
    Diagnostics diagnostics;  ///< in the order of the text

    bool ok() const { return !has_errors(diagnostics); }
};

/// Reads a table whose nodes are those of the catalog. Never throws. Spans in scene and diagnostics refer to
/// `source`.
ReadResult read_table(std::shared_ptr<const SourceText> source, std::shared_ptr<const Catalog> catalog,
                      const Limits& limits = {});

}  // namespace pinfield
