#include "editor/theme/colors.h"

#include "engine/core/at.h"

namespace pinfield::editor {
namespace {

struct RoleColors {
    Role role;
    unsigned dark, light;
};

// Every word has a contrast of 4.5 : 1 at least to what it stands on (tests/editor/contrast.test.cpp looks at what is drawn).
constexpr RoleColors table[] = {
    {Role::backdrop, 0x14161a, 0xcfd5dc},
    {Role::panel, 0x1c1f25, 0xf6f7f9},
    {Role::bar, 0x181a1f, 0xe9ecf0},
    {Role::raised, 0x23272e, 0xffffff},
    {Role::field, 0x272b33, 0xe6e9ee},
    {Role::field_hot, 0x2e343e, 0xdce1e8},
    {Role::field_active, 0x353c48, 0xd2d9e2},
    {Role::row_hot, 0x2a303a, 0xe4eaf1},
    {Role::line, 0x2c3038, 0xcdd3db},
    {Role::grab, 0x3a404b, 0xb9c1cb},
    {Role::dim, 0x0b0c0e, 0x3d4652},
    {Role::text, 0xe3e6eb, 0x1d2530},
    {Role::quiet, 0xabb3bf, 0x475160},
    {Role::faint, 0x949ca9, 0x596371},
    {Role::accent, 0x5db1f2, 0x0f5fa6},
    {Role::accent_deep, 0x14344e, 0xcfe3f6},
    {Role::amber, 0xf0b04a, 0x7d5200},
    {Role::coral, 0xf07f5f, 0xa8330f},
    {Role::teal, 0x55c7b0, 0x00655a},
    {Role::guide, 0xc3a6f5, 0x6b3aa8},
    {Role::primary, 0x2a6fa5, 0x1767ab},
    {Role::primary_hot, 0x2f76ad, 0x1a71bb},
    {Role::primary_active, 0x25648f, 0x125a97},
    {Role::on_primary, 0xffffff, 0xffffff},
    {Role::yaml_comment, 0x8c9a86, 0x4d6147},
    {Role::yaml_key, 0xa9b8cb, 0x2a4d77},
    {Role::yaml_number, 0xcbb2f2, 0x6b3aa8},
    {Role::yaml_quoted, 0xb7cf98, 0x3b6112},
    {Role::yaml_anchor, 0xe8a87c, 0x8f4a12},
    {Role::floor_low, 0x243447, 0xe9eef4},
    {Role::floor_high, 0x1d2739, 0xdde4ed},
    {Role::rim, 0x1c1e23, 0x9aa5b2},
};

constexpr Colors colors_from(bool light) {
    Colors colors{};
    for (const RoleColors& row : table) colors[static_cast<std::size_t>(row.role)] = light ? row.light : row.dark;
    return colors;
}

constexpr Colors dark_colors = colors_from(false), light_colors = colors_from(true);
static_assert(std::size(table) == static_cast<std::size_t>(Role::count));

float channel(unsigned rgb, unsigned shift) { return static_cast<float>(rgb >> shift & 255u) / 255; }

}  // namespace

const Colors& colors_of(ThemeChoice theme) { return theme == ThemeChoice::light ? light_colors : dark_colors; }

const Colors& colors_in_use() {
    const void* const colors = ImGui::GetIO().UserData;
    return colors ? *static_cast<const Colors*>(colors) : dark_colors;
}

void use_colors(ThemeChoice theme) { ImGui::GetIO().UserData = const_cast<Colors*>(&colors_of(theme)); }

Rgb Tint::rgb() const {
    const unsigned color = role_ == Role::count ? rgb_ : at(colors_in_use(), role_);
    return {channel(color, 16), channel(color, 8), channel(color, 0)};
}

}  // namespace pinfield::editor
