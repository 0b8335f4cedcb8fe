#include "engine/io/png.h"

#include <stb/stb_image_write.h>

#include <cassert>

#include "engine/io/files.h"

namespace pinfield {

Result<bool> write_png(const std::string& path, int width, int height, std::span<const unsigned char> rgb) {
    assert(rgb.size() == 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height) && "three bytes a pixel");
    std::string file;
    const auto append = [](void* to, void* bytes, int n) {
        static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), static_cast<std::size_t>(n));
    };
    if (!stbi_write_png_to_func(append, &file, width, height, 3, rgb.data(), 3 * width))
        return failure("cannot encode " + path + " as PNG");
    return write_file(path, file);
}

}  // namespace pinfield
