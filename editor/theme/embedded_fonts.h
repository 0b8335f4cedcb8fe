// Inter (FONT-LICENSE.txt), as bytes of the program; embed_font.cmake writes the .cpp from Debian's fonts-inter.
#pragma once
#include <cstddef>

namespace pinfield::editor {

struct EmbeddedFont {
    const unsigned char* bytes;
    std::size_t size;
};
extern const EmbeddedFont inter_regular, inter_semi_bold;

}  // namespace pinfield::editor
