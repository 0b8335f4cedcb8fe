#include "engine/io/write_table.h"

#include "engine/io/section.h"

namespace pinfield {

std::string write_table(const Scene& scene) {
    std::string out;
    for (const Section* section : all_sections())
        if (section->write) out += section->write(scene);
    return out;
}

}  // namespace pinfield
