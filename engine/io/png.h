// Pictures out.
#pragma once
#include <span>
#include <string>

#include "engine/core/result.h"

namespace pinfield {

/// Writes an 8-bit RGB image, 3 * width * height bytes, row 0 at the top. The file appears whole or not at all.
Result<bool> write_png(const std::string& path, int width, int height, std::span<const unsigned char> rgb);

}  // namespace pinfield
