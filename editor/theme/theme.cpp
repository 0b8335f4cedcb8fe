#include "editor/theme/theme.h"

#include <imgui_freetype.h>

#include <array>
#include <cmath>

#include "editor/theme/embedded_fonts.h"
#include "engine/core/color.h"

namespace pinfield::editor {

namespace {

ImFont* add_font(const EmbeddedFont& font, float size) {
    // Latin, Greek (units, angles), Cyrillic and the punctuation and arrows that labels use.
    static constexpr ImWchar ranges[] = {0x0020, 0x017f, 0x0370, 0x052f, 0x2010, 0x2027, 0x2030, 0x203a, 0x2070, 0x209f,
                                         0x20a0, 0x20bf, 0x2190, 0x21ff, 0x2200, 0x22ff, 0x2300, 0x23ff, 0x25a0, 0x25ff, 0};
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    config.OversampleH = 1;
    config.PixelSnapH = true;
    config.GlyphOffset = {0, 0};
    return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(const_cast<unsigned char*>(font.bytes), static_cast<int>(font.size),
                                                      size, &config, ranges);
}

void set_colors(ImGuiStyle& style) {
    using namespace palette;
    const auto set = [&](ImGuiCol slot, const Tint& color) { style.Colors[slot] = color; };
    const Tint none = panel.faded(0);
    set(ImGuiCol_Text, text);
    set(ImGuiCol_TextDisabled, faint);
    set(ImGuiCol_WindowBg, panel);
    set(ImGuiCol_ChildBg, none);
    set(ImGuiCol_PopupBg, raised);
    set(ImGuiCol_Border, line);
    set(ImGuiCol_BorderShadow, none);
    set(ImGuiCol_FrameBg, field);
    set(ImGuiCol_FrameBgHovered, field_hot);
    set(ImGuiCol_FrameBgActive, field_active);
    set(ImGuiCol_TitleBg, bar);
    set(ImGuiCol_TitleBgActive, bar);
    set(ImGuiCol_MenuBarBg, bar);
    set(ImGuiCol_ScrollbarBg, none);
    set(ImGuiCol_ScrollbarGrab, Role::grab);
    set(ImGuiCol_ScrollbarGrabHovered, faint.faded(0.6f));
    set(ImGuiCol_ScrollbarGrabActive, faint);
    set(ImGuiCol_CheckMark, accent);
    set(ImGuiCol_SliderGrab, accent);
    set(ImGuiCol_SliderGrabActive, accent);
    set(ImGuiCol_Button, field);
    set(ImGuiCol_ButtonHovered, field_hot);
    set(ImGuiCol_ButtonActive, field_active);
    set(ImGuiCol_Header, accent_deep);
    set(ImGuiCol_HeaderHovered, Role::row_hot);
    set(ImGuiCol_HeaderActive, accent_deep);
    set(ImGuiCol_Separator, line);
    set(ImGuiCol_NavHighlight, accent);
    set(ImGuiCol_TextSelectedBg, accent.faded(0.35f));
    set(ImGuiCol_ModalWindowDimBg, Tint(Role::dim, 0.6f));
    set(ImGuiCol_TableBorderLight, line);
    set(ImGuiCol_TableBorderStrong, line);
    set(ImGuiCol_TableRowBgAlt, text.faded(0.02f));
}

}  // namespace

float Theme::px(float design_pixels) const { return std::round(design_pixels * scale); }

Theme make_theme(float scale, float font_size, ThemeChoice choice) {
    use_colors(choice);
    Theme theme;
    // The font's size carries everything else with it.
    theme.scale = scale * font_size / 14;
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();  // the default one cannot read OpenType's outlines well
    atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
    theme.body = add_font(inter_regular, theme.px(14));
    theme.strong = add_font(inter_semi_bold, theme.px(14));
    theme.small = add_font(inter_regular, theme.px(12));
    theme.large = add_font(inter_semi_bold, theme.px(20));
    theme.mono = add_font(dejavu_sans_mono, theme.px(13));

    ImGuiStyle style;
    style.WindowPadding = {12, 10};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 6};
    style.ItemInnerSpacing = {6, 4};
    style.IndentSpacing = 16;
    style.ScrollbarSize = 10;
    style.GrabMinSize = 10;
    style.WindowBorderSize = 0;
    style.PopupBorderSize = 1;
    style.FrameBorderSize = 0;
    style.WindowRounding = 0;
    style.PopupRounding = 6;
    style.FrameRounding = 4;
    style.GrabRounding = 4;
    style.ScrollbarRounding = 5;
    style.WindowTitleAlign = {0, 0.5f};
    style.ScaleAllSizes(theme.scale);
    style.PopupBorderSize = 1;
    style.DisabledAlpha = 1;  // what is disabled has a color of its own, which can be read
    set_colors(style);
    ImGui::GetStyle() = style;
    return theme;
}

std::vector<Rgb> material_colors(const Program& program) {
    // The default material is the table's own body, calm and near the floor; unnamed colors after it stay apart in lightness too.
    static constexpr std::array<unsigned, 7> on_dark = {0x39424f, 0x8fa3b8, 0xd9a441, 0x5b8fb9, 0xc9c2b2, 0x7a6a9a, 0x4f9d90};
    static constexpr std::array<unsigned, 7> on_light = {0x76859a, 0x3f5d80, 0xc98a1b, 0x2f78ad, 0x8b7f63, 0x6f5a96, 0x2c8576};
    const auto& usual = &colors_in_use() == &colors_of(ThemeChoice::light) ? on_light : on_dark;
    std::vector<Rgb> colors;
    for (std::size_t i = 0; i < program.materials.size(); ++i) {
        if (const auto color = parse_color(program.materials[i].color))
            colors.push_back({static_cast<float>(color->r) / 255, static_cast<float>(color->g) / 255,
                              static_cast<float>(color->b) / 255});
        else
            colors.push_back(palette::hex(usual[i % usual.size()]).rgb());
    }
    return colors;
}

}  // namespace pinfield::editor
