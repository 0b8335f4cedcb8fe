// The colors of the editor by what they are for, in a dark and a light theme. Panels name the purpose; which color that is, the ImGui
// context knows, as it knows fonts and style.
#pragma once
#include <imgui.h>

#include <array>
#include <cstddef>

#include "editor/preferences.h"
#include "editor/render/gl_objects.h"

namespace pinfield::editor {

enum class Role : unsigned char {
    backdrop,  ///< behind the table
    panel,
    bar,     ///< menu, transport, status
    raised,  ///< menus, dialogs, tooltips
    field,   ///< what can be edited
    field_hot,
    field_active,
    row_hot,  ///< of a menu or list, under the mouse
    line,     ///< borders
    grab,     ///< of a scrollbar
    dim,      ///< over all that waits behind a dialog
    text,
    quiet,        ///< labels, units
    faint,        ///< disabled, placeholders
    accent,       ///< selection, focus
    accent_deep,  ///< behind what is selected
    amber,        ///< warnings, operations
    coral,        ///< errors
    teal,         ///< mechanisms
    guide,        ///< that an author put there
    primary,      ///< the button that Enter presses
    primary_hot,
    primary_active,
    on_primary,  ///< its words
    // The table's text.
    yaml_comment,
    yaml_key,
    yaml_number,
    yaml_quoted,
    yaml_anchor,
    // The table's floor, low and high, and the frame around it.
    floor_low,
    floor_high,
    rim,
    count
};

/// 0xrrggbb by role.
using Colors = std::array<unsigned, static_cast<std::size_t>(Role::count)>;
const Colors& colors_of(ThemeChoice theme);
/// Those of the current ImGui context.
const Colors& colors_in_use();
void use_colors(ThemeChoice theme);

/// A color, or what one is for, and how opaque it is.
class Tint {
public:
    constexpr Tint(Role role, float alpha = 1) : role_(role), alpha_(alpha) {}  // NOLINT(google-explicit-constructor)
    static constexpr Tint literal(unsigned rgb, float alpha = 1) {
        Tint tint(Role::count, alpha);
        tint.rgb_ = rgb;
        return tint;
    }
    constexpr Tint faded(float alpha) const {
        Tint tint = *this;
        tint.alpha_ *= alpha;
        return tint;
    }
    Rgb rgb() const;
    operator ImVec4() const {  // NOLINT(google-explicit-constructor)
        const Rgb color = rgb();
        return {color.r, color.g, color.b, alpha_};
    }

private:
    Role role_;
    unsigned rgb_ = 0;
    float alpha_;
};
inline ImU32 ink(const Tint& color) { return ImGui::ColorConvertFloat4ToU32(color); }

// Blue against amber can be told apart with every kind of color vision; meaning never rests on color alone.
namespace palette {

constexpr Tint hex(unsigned rgb) { return Tint::literal(rgb); }

inline constexpr Tint backdrop = Role::backdrop;
inline constexpr Tint panel = Role::panel;
inline constexpr Tint bar = Role::bar;
inline constexpr Tint raised = Role::raised;
inline constexpr Tint field = Role::field;
inline constexpr Tint field_hot = Role::field_hot;
inline constexpr Tint field_active = Role::field_active;
inline constexpr Tint line = Role::line;
inline constexpr Tint text = Role::text;
inline constexpr Tint quiet = Role::quiet;
inline constexpr Tint faint = Role::faint;
inline constexpr Tint accent = Role::accent;
inline constexpr Tint accent_deep = Role::accent_deep;
inline constexpr Tint amber = Role::amber;
inline constexpr Tint coral = Role::coral;
inline constexpr Tint teal = Role::teal;

}  // namespace palette

}  // namespace pinfield::editor
