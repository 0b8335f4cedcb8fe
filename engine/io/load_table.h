// From a path to a scene: the file, then the reader.
#pragma once
#include <memory>
#include <string>

#include "engine/io/files.h"
#include "engine/io/table_reader.h"

namespace pinfield {

/// How the table at this path comes to the files it includes: by the disk, and nowhere above its folder.
OpenFile files_beside(const std::string& path);

/// Fails when the file cannot be read; what is wrong with its content is in the diagnostics. A file above the limit of
/// a table is not read further than needed to say so. What it includes is read from the disk, too.
Result<Reading> load_table(const std::string& path, std::shared_ptr<const Catalog> catalog, const Limits& limits = {});

}  // namespace pinfield
