// A table on the screen, and a mouse over it.
#pragma once
#include <string>

#include "tests/editor/screen.h"
#include "tests/editor/support.h"

namespace pinfield::editor::test {

class Desk : public Screen {
public:
    explicit Desk(const std::string& text = pen) : Screen({800, 800}), state_(opened_state(folder_, text)) {
        state_.session.play(false);
        frames(3);
    }
    AppState& state() { return state_; }
    const Folder& folder() const { return folder_; }

    void frames(int count) {
        for (int i = 0; i < count; ++i)
            frame_of([&] {
                viewport_panel(state_, ui_, {0, 0}, {800, 800});
                advance(state_, 0);
            });
    }
    Vec2 on_table(double x, double y) const { return state_.view.pixel_from_world({x, y}); }
    /// A pixel. What the mouse is over is known one frame later.
    void move_to(const Vec2& pixel) {
        ui_.mouse = pixel;
        ImGui::GetIO().MousePos = {static_cast<float>(pixel.x()), static_cast<float>(pixel.y())};
        frames(2);
    }
    void move_to_world(const Vec2& world) { move_to(state_.view.pixel_from_world(world)); }
    void button(bool down) {
        ImGui::GetIO().MouseDown[0] = down;
        frames(1);
    }
    void drag(const Vec2& from, const Vec2& to) {
        move_to(from);
        button(true);
        for (const double share : {0.3, 0.7, 1.0}) move_to(from + share * (to - from));
        button(false);
        frames(30);  // else the next press would make a double click
    }

protected:
    Folder folder_;
    AppState state_;
};

}  // namespace pinfield::editor::test
