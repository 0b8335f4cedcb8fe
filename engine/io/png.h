// Pictures to files.
#pragma once
#include <string>
#include <vector>

#include "engine/core/result.h"

namespace pinfield {

/// The bytes of a PNG of 8-bit pixels, as write_png() takes them. `path` is for messages.
Result<std::string> encode_png(const std::string& path, int width, int height, const std::vector<unsigned char>& pixels);

/// Writes 8-bit pixels, rows from the top, 3 (RGB) or 4 (RGBA) bytes each, which follows from their number.
Result<bool> write_png(const std::string& path, int width, int height, const std::vector<unsigned char>& pixels);

}  // namespace pinfield
