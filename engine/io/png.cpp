#include "engine/io/png.h"

#include <fmt/format.h>
#include <stb/stb_image_write.h>

#include "engine/io/files.h"

namespace pinfield {

Result<std::string> encode_png(const std::string& path, int width, int height, const std::vector<unsigned char>& pixels) {
    const std::size_t count =
        width > 0 && height > 0 ? static_cast<std::size_t>(width) * static_cast<std::size_t>(height) : 0;
    const int channels = count > 0 && pixels.size() == 3 * count ? 3 : count > 0 && pixels.size() == 4 * count ? 4 : 0;
    if (channels == 0)
        return failure(fmt::format("cannot write {}: {} bytes are no picture of {} x {} pixels", path, pixels.size(),
                                   width, height));
    std::string bytes;
    const auto append = [](void* out, void* data, int size) {
        static_cast<std::string*>(out)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
    };
    if (!stbi_write_png_to_func(append, &bytes, width, height, channels, pixels.data(), width * channels))
        return failure(fmt::format("cannot encode {}", path));
    return bytes;
}

Result<bool> write_png(const std::string& path, int width, int height, const std::vector<unsigned char>& pixels) {
    const Result<std::string> bytes = encode_png(path, width, height, pixels);
    return bytes ? write_file(path, *bytes) : tl::unexpected<Failure>(bytes.error());
}

}  // namespace pinfield
