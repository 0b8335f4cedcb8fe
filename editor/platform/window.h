// One window with an OpenGL context, and what the user's devices did to it. The only place that knows GLFW and the clock.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "editor/platform/gl.h"
#include "engine/core/geometry.h"
#include "engine/core/result.h"

struct GLFWwindow;
struct GLFWcursor;

namespace pinfield::editor {

/// Something a device did, in the order it happened.
struct WindowEvent {
    enum class Kind : unsigned char { cursor, button, scroll, key, text, focus, drop, close };
    Kind kind = Kind::cursor;
    Vec2 place{0, 0};        ///< cursor: window pixels, y down; scroll: notches
    int code = 0;            ///< button (0 left, 1 right, 2 middle) or GLFW key code
    bool down = false;       ///< button, key: pressed; focus: gained
    bool repeat = false;     ///< key: held for so long that it counts once more
    unsigned character = 0;  ///< text: a code point
    std::string path{};      ///< drop: the first file
};

enum class CursorShape : unsigned char { arrow, text, hand, resize_x, resize_y, move };

class Window {
public:
    /// Fails where there is no display or no OpenGL 3.3.
    static Result<std::unique_ptr<Window>> open(const std::string& title, int width, int height);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// What GLFW's callbacks call, and scripts too: events queue up until take_events().
    void on_cursor(double x, double y);
    void on_button(int button, bool down);
    void on_scroll(double dx, double dy);
    void on_key(int key, bool down, bool repeat = false);
    void on_text(unsigned character);
    void on_focus(bool gained);
    void on_drop(const std::string& path);
    void on_close();

    /// false: the user's own mouse and keyboard are not heard, so that a script runs the same everywhere.
    void listen(bool on) { listening_ = on; }
    /// Fetches what GLFW has, then all that is queued.
    std::vector<WindowEvent> take_events();
    /// Sleeps until a device does something, at most so many seconds.
    void wait_events(double seconds);
    /// Whether something is queued, or the picture must be drawn anew: the window was uncovered, sized, hidden or shown.
    bool has_events() const { return stale_ || !events_.empty(); }
    bool minimised() const;
    /// Seconds between two pictures of the screen.
    double frame_period() const;
    void present();

    Vec2 size() const;         ///< window pixels, what events are in
    Vec2 framebuffer() const;  ///< device pixels
    double content_scale() const;
    double seconds() const;  ///< since some start; monotonic
    const Gl& gl() const { return gl_; }

    void set_title(const std::string& title);
    void set_cursor(CursorShape shape);
    std::string clipboard() const;
    void set_clipboard(const std::string& text);

    /// The picture on the back buffer: 3 bytes a pixel, row 0 at the top.
    std::vector<unsigned char> read_pixels(int& width, int& height) const;

private:
    Window() = default;
    void attach_callbacks();

    GLFWwindow* window_ = nullptr;
    Gl gl_;
    bool listening_ = true;
    bool stale_ = true;
    std::vector<WindowEvent> events_;
    std::string title_;
    std::vector<GLFWcursor*> cursors_;
    CursorShape cursor_ = CursorShape::arrow;
};

}  // namespace pinfield::editor
