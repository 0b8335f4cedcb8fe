// Panels without a window: an ImGui context with its fonts, keys and mouse, and what a frame of it shows.
#pragma once
#include <algorithm>
#include <string_view>
#include <vector>

#include "editor/panels/ui.h"
#include "editor/widgets/screen_text.h"

namespace pinfield::editor::test {

class Screen {
public:
    explicit Screen(ImVec2 size, ThemeChoice theme = ThemeChoice::dark) {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = size;
        for (int key = 0; key < ImGuiKey_COUNT; ++key) io.KeyMap[key] = key;
        ui_.theme = make_theme(1, 14, theme);
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    }
    ~Screen() { ImGui::DestroyContext(); }
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    Ui& ui() { return ui_; }
    /// What the last frame shows.
    const std::vector<ScreenText>& seen() const { return seen_; }

protected:
    /// A 60th of a second: `panels` draws.
    template <class Panels>
    void frame_of(Panels panels) {
        ImGui::GetIO().DeltaTime = 1.0f / 60;
        ImGui::NewFrame();
        ui_.hovered = {};
        panels();
        ImGui::Render();
        seen_ = screen_texts();
    }

    Ui ui_;
    std::vector<ScreenText> seen_;
};

}  // namespace pinfield::editor::test
