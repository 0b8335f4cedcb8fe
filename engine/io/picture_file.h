// Pictures from files: photographs and scans, to be looked at.
#pragma once
#include <string>
#include <vector>

#include "engine/core/result.h"

namespace pinfield {

struct Bitmap {
    int width = 0, height = 0;
    std::vector<unsigned char> rgba{};  ///< rows from the top
};

/// A PNG or JPEG. Halved until neither side has more than `most_side` pixels. Fails when there is no such file, when it is no picture, and
/// when it is too large to be taken into memory.
Result<Bitmap> read_picture(const std::string& path, int most_side = 4096);

}  // namespace pinfield
