// Between our window and Dear ImGui: events in, cursor shape and clipboard out. Dear ImGui's own GLFW backend asks GLFW for
// the mouse, where a script's events would never show.
#pragma once
#include <imgui.h>

#include <deque>
#include <set>
#include <utility>

#include "editor/platform/window.h"

namespace pinfield::editor {

class ImGuiBridge {
public:
    /// Creates the ImGui context and its OpenGL half.
    explicit ImGuiBridge(Window& window);
    ~ImGuiBridge();
    ImGuiBridge(const ImGuiBridge&) = delete;
    ImGuiBridge& operator=(const ImGuiBridge&) = delete;

    void queue(const WindowEvent& event) { pending_.push_back(event); }
    /// Hands over queued events up to the second change of one button or key, so that a quick click is seen as two frames,
    /// and begins a frame of `seconds`, in which an open menu has its keys. Returns what was handed over.
    std::vector<WindowEvent> begin_frame(double seconds, bool menu_is_open);
    /// Whether something is queued still, or a key or button held: Dear ImGui counts how long.
    bool wants_frames() const { return !pending_.empty() || !held_.empty(); }
    void draw();  ///< on the back buffer
    /// The fonts are others than in the frame before.
    static void renew_fonts();

private:
    static void hand_over(const WindowEvent& event);

    Window& window_;
    std::deque<WindowEvent> pending_;
    std::set<std::pair<WindowEvent::Kind, int>> held_;
};

}  // namespace pinfield::editor
