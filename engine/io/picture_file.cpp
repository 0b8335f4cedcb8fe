#include "engine/io/picture_file.h"

#include <fmt/format.h>
#include <stb/stb_image.h>

#include <algorithm>
#include <cstddef>
#include <memory>

#include "engine/io/files.h"

namespace pinfield {
namespace {

constexpr std::size_t most_bytes = 100 << 20;
constexpr std::size_t most_pixels = 100'000'000;  ///< 400 MB while it is read

/// Each pixel the mean of four; of an odd side the last row or column is left out.
Bitmap halved(const Bitmap& whole) {
    Bitmap half{std::max(1, whole.width / 2), std::max(1, whole.height / 2), {}};
    half.rgba.resize(static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height) * 4);
    const auto place = [](const Bitmap& of, int x, int y) {
        const int column = std::min(x, of.width - 1), row = std::min(y, of.height - 1);
        return 4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(of.width) + static_cast<std::size_t>(column));
    };
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x)
            for (std::size_t c = 0; c < 4; ++c) {
                unsigned sum = 2;
                for (const int dy : {0, 1})
                    for (const int dx : {0, 1}) sum += whole.rgba[place(whole, 2 * x + dx, 2 * y + dy) + c];
                half.rgba[place(half, x, y) + c] = static_cast<unsigned char>(sum / 4);
            }
    return half;
}

}  // namespace

Result<Bitmap> read_picture(const std::string& path, int most_side) {
    const Result<std::string> file = read_file(path, most_bytes);
    if (!file) return tl::unexpected(file.error());
    const auto* const bytes = reinterpret_cast<const unsigned char*>(file->data());
    const auto size = static_cast<int>(file->size());
    Bitmap picture;
    int channels = 0;
    if (!stbi_info_from_memory(bytes, size, &picture.width, &picture.height, &channels))
        return failure(fmt::format("{} is no PNG or JPEG", path));
    const std::size_t pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    if (pixels > most_pixels) return failure(fmt::format("{} has {} x {} pixels, which is too many", path, picture.width, picture.height));
    const std::unique_ptr<unsigned char, decltype(&stbi_image_free)> read(
        stbi_load_from_memory(bytes, size, &picture.width, &picture.height, &channels, 4), stbi_image_free);
    if (!read) return failure(fmt::format("{} is damaged: {}", path, stbi_failure_reason()));
    picture.rgba.assign(read.get(), read.get() + 4 * pixels);
    while (std::max(picture.width, picture.height) > most_side) picture = halved(picture);
    return picture;
}

}  // namespace pinfield
