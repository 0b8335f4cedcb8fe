// The editor as a program: window, panels, painters and the clock, a frame at a time.
#pragma once
#include <memory>
#include <string>
#include <string_view>

#include "editor/app_state.h"
#include "editor/keyboard.h"
#include "editor/pace.h"
#include "editor/panels/ui.h"
#include "editor/platform/file_watch.h"
#include "editor/platform/native_dialog.h"
#include "editor/platform/window.h"
#include "editor/render/outline_painter.h"
#include "editor/render/table_painter.h"
#include "editor/script.h"
#include "editor/widgets/imgui_bridge.h"

namespace pinfield::editor {

struct AppOptions {
    int width = 1440, height = 900;
    int ticks_per_frame = 0;   ///< 0: as many as the clock says
    bool listen = true;        ///< to the user's own mouse and keyboard; scripts do not
};

class App : public ScriptHost {
public:
    /// Fails where no window can be opened.
    static Result<std::unique_ptr<App>> open(AppState state, const AppOptions& options);

    /// One frame: events, as many ticks as are due, panels, picture.
    void frame();
    /// One frame with so many ticks, whatever the clock says.
    void frame(int ticks);
    /// Until the user quits: 0; or until the system wants the process to end (SIGTERM, SIGINT, SIGHUP): that signal. Unsaved work is on
    /// disk then. Frames are drawn where they would show something new, no faster than the screen, and none while nobody sees them.
    int run();
    /// Frames until the script is done: why it failed, or nothing.
    std::string run(ScriptRunner script);

    AppState& state() { return state_; }

    // What scripts do goes through the window's own entry points.
    void move_mouse(const Vec2& pixel) override { window_->on_cursor(pixel.x(), pixel.y()); }
    void press_mouse(int button, bool down) override { window_->on_button(button, down); }
    void scroll(double notches) override { window_->on_scroll(0, notches); }
    void type(unsigned character) override { window_->on_text(character); }
    std::optional<Vec2> find_words(std::string_view words, std::string_view panel) const override;
    bool press_key(std::string_view key, bool down) override;
    /// Draws a frame without a tick and writes it as a PNG.
    Result<bool> screenshot(const std::string& path) override;
    int ticks_per_frame() const override { return options_.ticks_per_frame; }

private:
    App(AppState state, std::unique_ptr<Window> window, const AppOptions& options);

    double seconds_until_frame();
    void follow_theme();
    /// Waits for events, at most so long, and does without a frame what must be done now and then.
    void rest(double seconds);
    void look_around(double seconds);
    void ask_for_path();
    double passed_seconds();  ///< since it was last asked
    void take_key(const WindowEvent& event);
    bool cancel_drags();  ///< whether there was one
    int due_ticks(double passed);
    void draw(int ticks, double seconds);  ///< all of a frame but showing it
    Canvas canvas() const;
    void paint();
    UnderlayLook underlay_look();  ///< hands a new picture to the painter
    void paint_outlines(const ProgramPtr& program, std::span<const MoverPlace> places, const Canvas& canvas);
    void paint_outline(NodeId node, std::span<const MoverPlace> places, const OutlineStyle& style, const Canvas& canvas);

    AppState state_;
    bool in_menu_ = false;  ///< when the frame began
    AppOptions options_;
    std::unique_ptr<Window> window_;
    ImGuiBridge bridge_;
    TablePainter table_painter_;
    OutlinePainter outline_painter_;
    Ui ui_;
    ThemeChoice theme_ = ThemeChoice::dark;  ///< that ui_ has, with text of
    double font_size_ = 0;
    Keyboard keyboard_;
    FramePace pace_;
    ShownTable shown_;
    std::shared_ptr<const Bitmap> painted_underlay_;
    RealTime real_time_;
    int shown_messages_ = 0;
    double last_seconds_ = 0, owed_seconds_ = 0, looked_seconds_ = 0, kept_seconds_ = 0;
    FileWatch watch_;
    NativeDialog dialog_;
    std::string asked_;  ///< the action that it was opened for
    double frame_seconds_ = 0;   ///< when the last frame began
    double rested_seconds_ = 0;  ///< since then
};

}  // namespace pinfield::editor
