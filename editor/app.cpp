#include "editor/app.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <utility>

#include "editor/widgets/screen_text.h"
#include "engine/core/at.h"
#include "engine/core/keys.h"
#include "engine/io/png.h"

namespace pinfield::editor {

namespace {

constexpr double scripted_frame = 1.0 / 60;   ///< seconds, for what only moves on the screen
constexpr double longest_frame = 0.05;        ///< after a stall the table goes on, it does not catch up
constexpr double disk_period = 0.5;           ///< seconds between looks at the file

/// What a signal handler may touch; the loop looks at it.
volatile std::sig_atomic_t ending_signal = 0;

/// The second one ends the process at once.
void remember_signal(int number) {
    ending_signal = number;
    std::signal(number, SIG_DFL);
}

void listen_to_signals() {
    for (const int number : {SIGTERM, SIGINT, SIGHUP})
        if (std::signal(number, remember_signal) == SIG_IGN) std::signal(number, SIG_IGN);  // as nohup wants it
}

/// Actions name punctuation keys by the character on them.
std::string character_of(std::string_view key) {
    static constexpr std::pair<std::string_view, char> keys[] = {
        {"Period", '.'}, {"Comma", ','}, {"Slash", '/'}, {"Minus", '-'}, {"Equal", '='}, {"Semicolon", ';'},
        {"LeftBracket", '['}, {"RightBracket", ']'}, {"Apostrophe", '\''}, {"Backslash", '\\'}, {"GraveAccent", '`'}};
    for (const auto& [name, character] : keys)
        if (name == key) return std::string(1, character);
    if (key.starts_with("Key") && key.size() == 4) return std::string(key.substr(3));
    return key == "Escape" ? "Esc" : std::string(key);
}

/// Keys that with Ctrl are the text's in which somebody types.
bool edits_text(std::string_view key) {
    static constexpr std::string_view keys[] = {"A",    "C",    "V",     "X",    "Y",   "Z",         "Left",
                                                "Right", "Up",  "Down", "Home", "End", "Backspace", "Delete"};
    return std::find(std::begin(keys), std::end(keys), key) != std::end(keys);
}

std::string window_title(const Document& document) {
    const std::string& path = document.path();
    const std::string name = path.empty() ? "Untitled" : path.substr(path.find_last_of('/') + 1);
    return (document.dirty() ? "\u2022 " : "") + name + " \u2013 Pinfield";
}

}  // namespace

Result<std::unique_ptr<App>> App::open(AppState state, const AppOptions& options) {
    Result<std::unique_ptr<Window>> window = Window::open("Pinfield", options.width, options.height);
    if (!window) return tl::unexpected(window.error());
    return std::unique_ptr<App>(new App(std::move(state), std::move(*window), options));
}

App::App(AppState state, std::unique_ptr<Window> window, const AppOptions& options)
    : state_(std::move(state)),
      options_(options),
      window_(std::move(window)),
      bridge_(*window_),
      table_painter_(window_->gl()),
      outline_painter_(window_->gl()) {
    window_->listen(options.listen);
    ui_.theme = make_theme(static_cast<float>(window_->content_scale()), static_cast<float>(options.font_size));
    last_seconds_ = window_->seconds();
    state_.give_clipboard = [](const std::string& text) { ImGui::SetClipboardText(text.c_str()); };
    state_.ask_clipboard = [] {
        const char* text = ImGui::GetClipboardText();
        return std::string(text ? text : "");
    };
}

int App::run() {
    listen_to_signals();
    while (!state_.quit && ending_signal == 0) frame();
    if (!state_.quit && state_.keeper) state_.keeper->sync();
    return state_.quit ? 0 : ending_signal;
}

std::string App::run(ScriptRunner script) {
    while (!script.done() && !state_.quit) frame(script.before_frame(state_, *this));
    return script.failure();
}

bool App::press_key(std::string_view key, bool down) {
    const int code = key_code(key);
    if (code >= 0) window_->on_key(code, down);
    return code >= 0;
}

std::optional<Vec2> App::find_words(std::string_view words) const {
    const ScreenText* best = nullptr;
    const std::vector<ScreenText> texts = screen_texts();
    for (const ScreenText& text : texts)
        if (text.text == words || (text.text.starts_with(words) && (!best || best->text != words))) best = &text;
    if (!best) return {};
    return Vec2(best->at.x + 0.5 * ImGui::CalcTextSize(best->text.c_str()).x, best->at.y + 0.5 * ImGui::GetFontSize());
}

void App::frame() {
    if (options_.ticks_per_frame > 0) return frame(options_.ticks_per_frame);
    const double now = window_->seconds();
    const double seconds = std::min(now - last_seconds_, longest_frame);
    last_seconds_ = now;
    draw(due_ticks(seconds), seconds);
    window_->present();
}

void App::frame(int ticks) {
    draw(ticks, scripted_frame);
    window_->present();
}

void App::draw(int ticks, double seconds) {
    disk_seconds_ += seconds;
    if (disk_seconds_ >= disk_period && !state_.document.previewing()) {
        disk_seconds_ = 0;
        look_at_disk(state_);
    }
    for (const WindowEvent& event : window_->take_events()) bridge_.queue(event);
    for (const WindowEvent& event : bridge_.begin_frame(seconds)) {
        if (event.kind == WindowEvent::Kind::cursor) ui_.mouse = event.place;
        else if (event.kind == WindowEvent::Kind::key) take_key(event.code, event.down);
        else if (event.kind == WindowEvent::Kind::close) editor::run(state_, "app.quit");
        else if (event.kind == WindowEvent::Kind::drop) open_file(state_, event.path);
        else if (event.kind == WindowEvent::Kind::focus && !event.down) state_.session.release_all();
    }
    ui_.hovered = {};
    draw_panels(state_, ui_);
    // After the panels: what they changed is in the table they are painted over.
    advance(state_, ticks);
    window_->set_title(window_title(state_.document));
    paint();
    bridge_.draw();
}

int App::due_ticks(double seconds) {
    const double step = state_.session.world().step_length();
    owed_seconds_ += seconds;
    const double ticks = std::floor(owed_seconds_ / step);
    owed_seconds_ -= ticks * step;
    return static_cast<int>(ticks);
}

void App::take_key(int code, bool down) {
    const std::string_view key = key_name(code);
    if (key == "LeftControl" || key == "RightControl") control_ = down;
    if (key == "LeftShift" || key == "RightShift") shift_ = down;
    if (key == "LeftAlt" || key == "RightAlt") alt_ = down;
    if (!down) {
        editor::press_key(state_, key, false);  // a key let go is let go, whoever has the keyboard by now
        return;
    }
    const bool asks = state_.prompt || state_.recovery || !state_.dialog_action.empty() || state_.choosing || state_.show_help || state_.show_command_palette;
    const bool typing = ImGui::GetIO().WantTextInput || ui_.typing.field >= 0 || ui_.renaming.node || ui_.source.focused || state_.type_source;
    if (asks) return;
    const bool plain = !control_ && !alt_;
    if (typing && (plain || !control_ || edits_text(key))) return;
    // The table's own keys come first: a game is to be played with whatever keys its author chose.
    if (plain && editor::press_key(state_, key, true)) return;
    std::string chord = control_ ? "Ctrl+" : "";
    if (alt_) chord += "Alt+";
    if (shift_) chord += "Shift+";
    const Action* action = action_of(chord + character_of(key));
    if (!action) action = action_of(chord + std::string(key));
    // During a drag, Esc and undo take the drag back and nothing more.
    if (action && action->name.starts_with("edit.") && cancel_drags()) return;
    if (action && enabled(state_, action->name)) editor::run(state_, action->name);
}

bool App::cancel_drags() {
    const bool scrubbed = ui_.scrub.active();
    if (scrubbed) ui_.scrub.cancel(state_.document);
    return cancel_drag(state_, ui_) || scrubbed;
}

Canvas App::canvas() const {
    const Vec2 size = window_->size(), framebuffer = window_->framebuffer();
    const double scale = size.x() > 0 ? framebuffer.x() / size.x() : 1;
    const View& view = state_.view;
    Canvas canvas;
    canvas.framebuffer = framebuffer;
    canvas.origin = (scale * view.origin).array().round();
    canvas.size = (scale * view.size).array().round().max(1.0);
    canvas.centre = view.centre;
    canvas.pixels_per_metre = scale * view.pixels_per_metre;
    return canvas;
}

void App::paint() {
    const Gl& gl = window_->gl();
    const Canvas canvas = this->canvas();
    const auto whole = [](double x) { return static_cast<int>(x); };
    gl.Disable(GL_SCISSOR_TEST);
    gl.ClearColor(palette::backdrop.r, palette::backdrop.g, palette::backdrop.b, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Viewport(whole(canvas.origin.x()), whole(canvas.framebuffer.y() - canvas.origin.y() - canvas.size.y()), whole(canvas.size.x()),
                whole(canvas.size.y()));

    const World& world = state_.session.world();
    const ProgramPtr& program = world.shared_program();
    std::vector<MoverPlace> places;
    for (std::size_t i = 0; i < program->movers.size(); ++i)
        places.push_back({world.movers()[i].q, state_.session.world_from_mover(static_cast<int>(i))});
    std::vector<BallMark> balls;
    for (const Ball& ball : world.balls())
        if (ball.state != BallState::drained) balls.push_back({ball.position, program->physics.ball_radius, 0});

    TableLook look;
    look.isolines = state_.view.style == ViewStyle::isolines;
    look.materials = material_colors(*program);
    look.floor_low = palette::hex(0x243447).rgb();
    look.floor_high = palette::hex(0x1d2739).rgb();
    look.backdrop = palette::backdrop.rgb();
    table_painter_.draw(program, places, balls, look, canvas);
    paint_outlines(program, places, canvas);
    gl.Viewport(0, 0, whole(canvas.framebuffer.x()), whole(canvas.framebuffer.y()));
}

void App::paint_outlines(const ProgramPtr& program, std::span<const MoverPlace> places, const Canvas& canvas) {
    const double pixel = ui_.theme.scale;
    for (const Sensor& sensor : program->sensors) {
        const NodeId node = at(program->parts, sensor.part).origin;
        outline_painter_.draw(program, places, node, {palette::teal.rgb(), 0.45, 1.2 * pixel, 0.04, 0.10}, canvas);
    }
    if (ui_.hovered && !state_.selection.contains(ui_.hovered) && !ui_.drag.active())
        outline_painter_.draw(program, places, ui_.hovered, {palette::text.rgb(), 0.75, 1.4 * pixel, 0.06, 0}, canvas);
    for (const NodeId node : state_.selection.nodes())
        outline_painter_.draw(program, places, node, {palette::accent.rgb(), 1, 2.2 * pixel, 0.12, 0}, canvas);
}

Result<bool> App::screenshot(const std::string& path) {
    draw(0, scripted_frame);
    int width = 0, height = 0;
    const std::vector<unsigned char> pixels = window_->read_pixels(width, height);  // before the buffers are swapped
    window_->present();
    return write_png(path, width, height, pixels);
}

}  // namespace pinfield::editor
