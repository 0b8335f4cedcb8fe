// Colors as the table format writes them: CSS names and quoted #rgb or #rrggbb.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pinfield {

/// sRGB, 8 bits a channel.
struct Color {
    std::uint8_t r = 0, g = 0, b = 0;
    bool operator==(const Color&) const = default;
};

/// A CSS named color (any letter case), "#rgb" or "#rrggbb"; nothing for anything else.
std::optional<Color> parse_color(std::string_view text);
/// "#rrggbb".
std::string to_text(const Color& color);
/// All CSS names, for suggestions.
std::vector<std::string_view> color_names();

}  // namespace pinfield
