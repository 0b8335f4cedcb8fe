// Can all words be read? What the panels draw is painted into a small picture, and each letter is held against what lies under it.
// WCAG 2.1, success criterion 1.4.3: 4.5 : 1.
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "editor/lay_under.h"
#include "engine/core/at.h"
#include "engine/io/png.h"
#include "tests/editor/screen.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

constexpr double least_contrast = 4.5;

double luminance(const Rgb& color) {
    const auto linear = [](float c) { return c <= 0.03928f ? c / 12.92 : std::pow((static_cast<double>(c) + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
}

double contrast(const Rgb& a, const Rgb& b) {
    const double x = luminance(a), y = luminance(b);
    return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

/// What lies under the words: triangles, painted in their order, in cells of some pixels.
class Paper {
public:
    Paper(ImVec2 size, const Rgb& color)
        : width_(static_cast<int>(size.x) / cell + 1),
          height_(static_cast<int>(size.y) / cell + 1),
          cells_(static_cast<std::size_t>(width_ * height_), color) {}

    Rgb at_place(ImVec2 p) const { return at(cells_, index(p)); }
    bool holds(ImVec2 p) const {
        return p.x >= 0 && p.y >= 0 && p.x < static_cast<float>(width_ * cell) && p.y < static_cast<float>(height_ * cell);
    }

    void paint(const ImDrawVert& a, const ImDrawVert& b, const ImDrawVert& c, const ImVec4& clip) {
        const float area = (b.pos.x - a.pos.x) * (c.pos.y - a.pos.y) - (b.pos.y - a.pos.y) * (c.pos.x - a.pos.x);
        if (area == 0) return;
        const float left = std::max({0.0f, clip.x, std::min({a.pos.x, b.pos.x, c.pos.x})}),
                    right = std::min(clip.z, std::max({a.pos.x, b.pos.x, c.pos.x}));
        const float top = std::max({0.0f, clip.y, std::min({a.pos.y, b.pos.y, c.pos.y})}),
                    bottom = std::min(clip.w, std::max({a.pos.y, b.pos.y, c.pos.y}));
        for (int y = static_cast<int>(top) / cell; y <= static_cast<int>(bottom) / cell && y < height_; ++y)
            for (int x = static_cast<int>(left) / cell; x <= static_cast<int>(right) / cell && x < width_; ++x) {
                const ImVec2 p{(static_cast<float>(x) + 0.5f) * cell, (static_cast<float>(y) + 0.5f) * cell};
                if (p.x < clip.x || p.x >= clip.z || p.y < clip.y || p.y >= clip.w) continue;
                const float u = ((c.pos.x - b.pos.x) * (p.y - b.pos.y) - (c.pos.y - b.pos.y) * (p.x - b.pos.x)) / area;
                const float v = ((a.pos.x - c.pos.x) * (p.y - c.pos.y) - (a.pos.y - c.pos.y) * (p.x - c.pos.x)) / area;
                if (u < 0 || v < 0 || u + v > 1) continue;
                const ImVec4 color = ImGui::ColorConvertU32ToFloat4(a.col);
                Rgb& under = at(cells_, y * width_ + x);
                under = blended(under, color);
            }
    }
    static Rgb blended(const Rgb& under, const ImVec4& over) {
        const auto mix = [&](float a, float b) { return a + over.w * (b - a); };
        return {mix(under.r, over.x), mix(under.g, over.y), mix(under.b, over.z)};
    }

private:
    static constexpr int cell = 2;
    int index(ImVec2 p) const { return static_cast<int>(p.y) / cell * width_ + static_cast<int>(p.x) / cell; }

    int width_, height_;
    std::vector<Rgb> cells_;
};

/// The places in the fonts' texture at which letters begin.
std::set<std::pair<float, float>> letter_places() {
    std::set<std::pair<float, float>> places;
    for (const ImFont* font : ImGui::GetIO().Fonts->Fonts)
        for (const ImFontGlyph& glyph : font->Glyphs)
            if (glyph.Visible) places.insert({glyph.U0, glyph.V0});
    return places;
}

std::string hex_of(const Rgb& color) {
    const auto whole = [](float c) { return static_cast<int>(std::lround(255 * c)); };
    return fmt::format("{:02x}{:02x}{:02x}", whole(color.r), whole(color.g), whole(color.b));
}

/// The words of the frame drawn last that cannot be read, and how bad it is; over a table that is all of one color.
std::map<std::string, double> unreadable(const std::vector<ScreenText>& seen, const Rgb& table) {
    const std::set<std::pair<float, float>> letters = letter_places();
    const ImDrawData& data = *ImGui::GetDrawData();
    Paper paper(data.DisplaySize, table);
    std::map<std::string, double> found;
    const auto words_at = [&](ImVec2 p) {
        const ScreenText* best = nullptr;
        for (const ScreenText& text : seen)
            if (text.at.x <= p.x + 2 && std::fabs(text.at.y + 8 - p.y) < 9 && (!best || best->at.x < text.at.x)) best = &text;
        return best ? best->window + ": " + best->text : std::string("?");
    };
    for (int l = 0; l < data.CmdListsCount; ++l) {
        const ImDrawList& list = *data.CmdLists[l];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            const auto corner = [&](unsigned i) -> const ImDrawVert& {
                return list.VtxBuffer[static_cast<int>(command.VtxOffset + list.IdxBuffer[static_cast<int>(command.IdxOffset + i)])];
            };
            for (unsigned i = 0; i + 2 < command.ElemCount; i += 3) {
                const ImDrawVert &a = corner(i), &b = corner(i + 1), &c = corner(i + 2);
                if (!letters.contains({a.uv.x, a.uv.y})) {
                    paper.paint(a, b, c, command.ClipRect);
                    continue;
                }
                i += 3;  // the letter's second triangle
                const ImVec2 middle{0.5f * (a.pos.x + c.pos.x), 0.5f * (a.pos.y + c.pos.y)};
                const ImVec4& clip = command.ClipRect;
                if (middle.x < clip.x || middle.y < clip.y || middle.x >= clip.z || middle.y >= clip.w || !paper.holds(middle)) continue;
                const Rgb under = paper.at_place(middle);
                const double reached = contrast(Paper::blended(under, ImGui::ColorConvertU32ToFloat4(a.col)), under);
                if (reached < least_contrast) {
                    const std::string colors =
                        fmt::format(" ({} on {})", hex_of(Paper::blended(under, ImGui::ColorConvertU32ToFloat4(a.col))), hex_of(under));
                    double& worst = found.try_emplace(words_at(middle) + colors, reached).first->second;
                    worst = std::min(worst, reached);
                }
            }
        }
    }
    return found;
}

/// All of the editor but its window, in a theme.
class Look : public Screen {
public:
    explicit Look(ThemeChoice theme) : Screen({1440, 900}, theme), theme_(theme), state_(opened_state(folder_)) {
        state_.preferences.theme = theme;
        state_.preferences.show_source = state_.preferences.show_history = true;
        for (int i = 0; i < 3; ++i) frame();
    }
    AppState& state() { return state_; }
    const Folder& folder() const { return folder_; }
    void frame() {
        frame_of([&] {
            draw_panels(state_, ui_);
            advance(state_, 0);
        });
    }
    void move_to(ImVec2 place) {
        ImGui::GetIO().MousePos = place;
        ui_.mouse = {place.x, place.y};
        frame();
    }
    void click(ImVec2 place, int button = 0) {
        move_to(place);
        for (const bool down : {true, false}) ImGui::GetIO().MouseDown[button] = down, frame();
        for (int i = 0; i < 30; ++i) frame();
    }
    void click(std::string_view words) {
        const auto found = std::find_if(seen().begin(), seen().end(), [&](const ScreenText& t) { return t.text == words; });
        INFO(words);
        REQUIRE(found != seen().end());
        click({found->at.x + 6, found->at.y + 7});
    }
    /// Every word now, over whatever the table's picture may show.
    void judge(const char* when) {
        const Colors& colors = colors_of(theme_);
        for (const Role role : {Role::backdrop, Role::floor_low, Role::floor_high})
            for (const auto& [words, reached] : unreadable(seen(), Tint::literal(at(colors, role)).rgb()))
                FAIL_CHECK(fmt::format("{}, {} theme: \"{}\" has {:.2f} : 1", when, theme_ == ThemeChoice::dark ? "dark" : "light", words,
                                       reached));
    }
    /// With the mouse over the words, one after the other.
    void judge_hovering(const char* when) {
        const std::vector<ScreenText> words = seen();
        for (std::size_t i = 0; i < words.size(); i += 7) {
            move_to({words[i].at.x + 3, words[i].at.y + 5});
            judge(when);
        }
    }

private:
    Folder folder_;
    ThemeChoice theme_;
    AppState state_;
};

}  // namespace

TEST_CASE("contrast is what WCAG says") {
    const Rgb black{0, 0, 0}, white{1, 1, 1}, grey = palette::hex(0x767676).rgb();
    CHECK(contrast(black, white) == Approx(21));
    CHECK(contrast(white, white) == Approx(1));
    CHECK(contrast(grey, white) == Approx(4.54).margin(0.005));
}

TEST_CASE("the test sees words that are too faint") {
    Look look(ThemeChoice::dark);
    ImGui::GetStyle().Colors[ImGuiCol_TextDisabled] = Tint::literal(0x676f7c);  // as placeholders once were
    look.frame();
    const auto found = unreadable(look.seen(), palette::backdrop.rgb());
    CHECK(std::any_of(found.begin(), found.end(), [](const auto& one) { return one.first.find("Find a node") != std::string::npos; }));
}

TEST_CASE("all words of both themes can be read: panels, with the mouse anywhere") {
    for (const ThemeChoice theme : {ThemeChoice::dark, ThemeChoice::light}) {
        Look look(theme);
        look.judge_hovering("nothing selected");
        for (const char* name : {"pop", "bat", "corner", "post", "drain", "table"}) {
            select(look.state(), id_of(look.state().document, name));
            for (int i = 0; i < 3; ++i) look.frame();
            look.judge_hovering(name);
        }
        edit(look.state(), change(look.state().document, "pop", "radius", 0.03), "Change radius of pop");
        look.frame();
        look.judge_hovering("edited");
        run(look.state(), "view.isolines");
        look.frame();
        look.judge("isolines");
    }
}

TEST_CASE("all words of both themes can be read: problems, and text that does not read") {
    for (const ThemeChoice theme : {ThemeChoice::dark, ThemeChoice::light}) {
        Look look(theme);
        open_file(look.state(), look.folder().write(
                                    "bad.yaml", "pinfield: 1\nscene:\n  - bumper: {id: a, raduis: 3}\n  - circle: {radius: -1}\n# done\n"));
        for (int i = 0; i < 5; ++i) look.frame();
        look.judge_hovering("problems");
    }
}

TEST_CASE("all words of both themes can be read: menus and dialogs") {
    for (const ThemeChoice theme : {ThemeChoice::dark, ThemeChoice::light}) {
        for (const char* menu : {"File", "Edit", "Add", "Select", "Arrange", "Play", "View", "Help"}) {
            Look look(theme);
            look.click(menu);
            look.judge_hovering(menu);
        }
        for (const char* action :
             {"file.new", "file.open", "file.save_as", "underlay.open", "edit.preferences", "help.keys", "view.command_palette"}) {
            Look look(theme);
            run(look.state(), action);
            for (int i = 0; i < 5; ++i) look.frame();
            look.judge_hovering(action);
        }
        {
            Look look(theme);
            REQUIRE(write_png(look.folder().file("photo.png"), 2, 2, std::vector<unsigned char>(12, 128)));
            REQUIRE(lay_under(look.state(), look.folder().file("photo.png")));
            for (int i = 0; i < 3; ++i) look.frame();
            look.judge_hovering("the underlay");
        }
        Look look(theme);
        edit(look.state(), change(look.state().document, "pop", "radius", 0.03), "Change radius of pop");
        run(look.state(), "app.quit");
        for (int i = 0; i < 5; ++i) look.frame();
        look.judge_hovering("a question");
    }
}
