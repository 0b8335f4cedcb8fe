#include "editor/widgets/screen_text.h"

#include <cmath>
#include <map>
#include <utility>

namespace pinfield::editor {

std::vector<ScreenText> screen_texts() {
    struct Glyph {
        const ImFontGlyph* glyph;
        const ImFont* font;
    };
    std::map<std::pair<float, float>, Glyph> glyph_at;
    for (const ImFont* font : ImGui::GetIO().Fonts->Fonts)
        for (const ImFontGlyph& glyph : font->Glyphs)
            if (glyph.Visible) glyph_at[{glyph.U0, glyph.V0}] = {&glyph, font};

    std::vector<ScreenText> out;
    float pen_x = -1e9f, pen_y = -1e9f;
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int l = 0; l < data.CmdListsCount; ++l) {
        const ImDrawList& list = *data.CmdLists[l];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            for (unsigned i = 0; i + 5 < command.ElemCount; i += 3) {
                const ImDrawVert& corner =
                    list.VtxBuffer[static_cast<int>(command.VtxOffset + list.IdxBuffer[static_cast<int>(command.IdxOffset + i)])];
                const auto found = glyph_at.find({corner.uv.x, corner.uv.y});
                if (found == glyph_at.end()) continue;
                const auto& [glyph, font] = found->second;
                const ImVec2 pen{corner.pos.x - glyph->X0, corner.pos.y - glyph->Y0};
                const float space = font->FindGlyph(' ')->AdvanceX;
                const bool goes_on = std::fabs(pen.y - pen_y) < 0.5f && pen.x > pen_x - 2 && pen.x < pen_x + 1.5f * space;
                if (!goes_on)
                    out.push_back({"", pen, list._OwnerName ? list._OwnerName : ""});
                else if (pen.x > pen_x + 0.5f * space)
                    out.back().text += ' ';
                out.back().text += glyph->Codepoint < 128 ? static_cast<char>(glyph->Codepoint) : '?';
                pen_x = pen.x + glyph->AdvanceX;
                pen_y = pen.y;
                i += 3;  // its second triangle
            }
        }
    }
    return out;
}

}  // namespace pinfield::editor
