// Inter and DejaVu Sans Mono (FONT-LICENSE.txt), as bytes of the program; embed_font.cmake writes the .cpp from Debian's fonts-inter and
// fonts-dejavu-core.
#pragma once
#include <cstddef>

namespace pinfield::editor {

struct EmbeddedFont {
    const unsigned char* bytes;
    std::size_t size;
};
extern const EmbeddedFont inter_regular, inter_semi_bold, dejavu_sans_mono;

}  // namespace pinfield::editor
