#include <algorithm>
#include <array>

#include "engine/io/same_content.h"
#include "engine/io/section.h"

namespace pinfield {
namespace sections {

// One file each in sections/.
extern const Section version, table, physics, params, materials, templates, include, scene, inputs, tests;

constexpr Section game{.key = "game", .unsupported = Code::game_unsupported, .why_not_included = "a table is one game"};

constexpr std::array<const Section*, 11> all{&version,   &table, &physics, &params, &materials, &templates,
                                             &include,   &scene, &inputs,  &game,   &tests};

}  // namespace sections

std::span<const Section* const> all_sections() { return sections::all; }

const Section* find_section(std::string_view key) {
    const auto* const found = std::find_if(sections::all.begin(), sections::all.end(), [&](const Section* s) { return s->key == key; });
    return found == sections::all.end() ? nullptr : *found;
}

bool same_content(const Scene& a, const Scene& b) {
    return std::all_of(sections::all.begin(), sections::all.end(), [&](const Section* s) { return !s->same || s->same(a, b); });
}

}  // namespace pinfield
