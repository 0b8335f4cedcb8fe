// Files of a folder and of nothing outside it, whatever links lead where.
#pragma once
#include <cstddef>
#include <string>

#include "engine/core/result.h"
#include "engine/io/included.h"

namespace pinfield {

/// The file that goes by a path from the folder (empty: the one the program was started in), with the path it has there when all links are
/// followed. Fails where that leads out of the folder, and for all that is no ordinary file, which is never opened: to open a pipe may
/// wait for ever.
Result<FoundFile> read_below(const std::string& folder, const std::string& path, std::size_t most);

}  // namespace pinfield
