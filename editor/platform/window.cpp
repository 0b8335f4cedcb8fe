#include "editor/platform/window.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <utility>

#include "engine/core/at.h"

// The numbers of engine/core/keys.cpp, at the ends of each of GLFW's runs.
static_assert(GLFW_KEY_SPACE == 32 && GLFW_KEY_GRAVE_ACCENT == 96 && GLFW_KEY_WORLD_2 == 162 && GLFW_KEY_ESCAPE == 256 &&
              GLFW_KEY_END == 269);
static_assert(GLFW_KEY_CAPS_LOCK == 280 && GLFW_KEY_PAUSE == 284 && GLFW_KEY_F1 == 290 && GLFW_KEY_F25 == 314);
static_assert(GLFW_KEY_KP_0 == 320 && GLFW_KEY_KP_EQUAL == 336 && GLFW_KEY_LEFT_SHIFT == 340 && GLFW_KEY_MENU == 348);

namespace pinfield::editor {

namespace {

std::string& last_glfw_error() {
    static std::string text;  // GLFW reports before any window exists to hold it
    return text;
}

template <class Function>
bool load_function(Function& function, const char* name) {
    function = reinterpret_cast<Function>(glfwGetProcAddress(name));
    return function != nullptr;
}

Result<Gl> load_gl() {
    Gl gl;
#define PINFIELD_GL_LOAD(name, upper) \
    if (!load_function(gl.name, "gl" #name)) return failure("this OpenGL has no gl" #name);
    PINFIELD_GL_FUNCTIONS(PINFIELD_GL_LOAD)
#undef PINFIELD_GL_LOAD
    return gl;
}

}  // namespace

Result<std::unique_ptr<Window>> Window::open(const std::string& title, int width, int height) {
    glfwSetErrorCallback([](int, const char* text) { last_glfw_error() = text; });
    if (!glfwInit()) return failure("cannot open a window: " + last_glfw_error());
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);

    std::unique_ptr<Window> out(new Window);
    out->window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (!out->window_) return failure("cannot open a window with OpenGL 3.3: " + last_glfw_error());
    out->title_ = title;
    glfwMakeContextCurrent(out->window_);
    glfwSwapInterval(1);
    Result<Gl> gl = load_gl();
    if (!gl) return tl::unexpected(gl.error());
    out->gl_ = *gl;
    out->attach_callbacks();
    for (const int shape : {GLFW_ARROW_CURSOR, GLFW_IBEAM_CURSOR, GLFW_HAND_CURSOR, GLFW_HRESIZE_CURSOR,
                            GLFW_VRESIZE_CURSOR, GLFW_CROSSHAIR_CURSOR})
        out->cursors_.push_back(glfwCreateStandardCursor(shape));
    return out;
}

Window::~Window() {
    for (GLFWcursor* cursor : cursors_)
        if (cursor) glfwDestroyCursor(cursor);
    if (window_) glfwDestroyWindow(window_);
    glfwTerminate();
}

void Window::attach_callbacks() {
    glfwSetWindowUserPointer(window_, this);
    // A plain function pointer cannot hold the window, so each fetches it; a deaf window lets only its closing through.
    static constexpr auto self = [](GLFWwindow* w) { return static_cast<Window*>(glfwGetWindowUserPointer(w)); };
    static constexpr auto hears = [](GLFWwindow* w) { return self(w)->listening_; };
    glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
        if (hears(w)) self(w)->on_cursor(x, y);
    });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int) {
        if (hears(w)) self(w)->on_button(button, action == GLFW_PRESS);
    });
    glfwSetScrollCallback(window_, [](GLFWwindow* w, double dx, double dy) {
        if (hears(w)) self(w)->on_scroll(dx, dy);
    });
    glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int) {
        if (hears(w) && key >= 0) self(w)->on_key(key, action != GLFW_RELEASE, action == GLFW_REPEAT);
    });
    glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned character) {
        if (hears(w)) self(w)->on_text(character);
    });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int gained) {
        if (hears(w)) self(w)->on_focus(gained != 0);
    });
    glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
        if (hears(w) && count > 0) self(w)->on_drop(paths[0]);
    });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { self(w)->stale_ = true; });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { self(w)->stale_ = true; });
    glfwSetWindowIconifyCallback(window_, [](GLFWwindow* w, int) { self(w)->stale_ = true; });
    glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) {
        glfwSetWindowShouldClose(w, GLFW_FALSE);  // the editor asks about unsaved work first
        self(w)->on_close();
    });
}

void Window::on_cursor(double x, double y) { events_.push_back({.kind = WindowEvent::Kind::cursor, .place = {x, y}}); }
void Window::on_button(int button, bool down) {
    events_.push_back({.kind = WindowEvent::Kind::button, .code = button, .down = down});
}
void Window::on_scroll(double dx, double dy) { events_.push_back({.kind = WindowEvent::Kind::scroll, .place = {dx, dy}}); }
void Window::on_key(int key, bool down, bool repeat) {
    events_.push_back({.kind = WindowEvent::Kind::key, .code = key, .down = down, .repeat = repeat});
}
void Window::on_text(unsigned character) {
    events_.push_back({.kind = WindowEvent::Kind::text, .character = character});
}
void Window::on_focus(bool gained) { events_.push_back({.kind = WindowEvent::Kind::focus, .down = gained}); }
void Window::on_drop(const std::string& path) { events_.push_back({.kind = WindowEvent::Kind::drop, .path = path}); }
void Window::on_close() { events_.push_back({.kind = WindowEvent::Kind::close}); }

std::vector<WindowEvent> Window::take_events() {
    glfwPollEvents();
    stale_ = false;
    return std::exchange(events_, {});
}

void Window::wait_events(double seconds) { glfwWaitEventsTimeout(seconds); }

bool Window::minimised() const { return glfwGetWindowAttrib(window_, GLFW_ICONIFIED) != 0; }

double Window::frame_period() const {
    GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* const mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    return 1.0 / (mode && mode->refreshRate > 0 ? std::clamp(mode->refreshRate, 30, 240) : 60);
}

void Window::present() { glfwSwapBuffers(window_); }

Vec2 Window::size() const {
    int width = 0, height = 0;
    glfwGetWindowSize(window_, &width, &height);
    return {width, height};
}

Vec2 Window::framebuffer() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    return {width, height};
}

double Window::content_scale() const {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::clamp(static_cast<double>(std::max(x, y)), 0.5, 4.0);
}

double Window::seconds() const { return glfwGetTime(); }

void Window::set_title(const std::string& title) {
    if (title == title_) return;
    title_ = title;
    glfwSetWindowTitle(window_, title.c_str());
}

void Window::set_cursor(CursorShape shape) {
    if (shape == cursor_) return;
    cursor_ = shape;
    glfwSetCursor(window_, at(cursors_, shape));
}

std::string Window::clipboard() const {
    const char* text = glfwGetClipboardString(window_);
    return text ? text : "";
}

void Window::set_clipboard(const std::string& text) { glfwSetClipboardString(window_, text.c_str()); }

std::vector<unsigned char> Window::read_pixels(int& width, int& height) const {
    const Vec2 size = framebuffer();
    width = static_cast<int>(size.x());
    height = static_cast<int>(size.y());
    const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
    std::vector<unsigned char> rgba(4 * w * h), rgb(3 * w * h);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    for (std::size_t y = 0; y < h; ++y)  // OpenGL's row 0 is the bottom one
        for (std::size_t x = 0; x < w; ++x)
            for (std::size_t c = 0; c < 3; ++c) rgb[3 * (y * w + x) + c] = rgba[4 * ((h - 1 - y) * w + x) + c];
    return rgb;
}

}  // namespace pinfield::editor
