#include "editor/app.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <utility>

#include "editor/ask_elsewhere.h"
#include "editor/keep_preferences.h"
#include "editor/lay_under.h"
#include "editor/widgets/screen_text.h"
#include "engine/core/at.h"
#include "engine/core/keys.h"
#include "engine/core/shown.h"
#include "engine/io/png.h"

namespace pinfield::editor {

namespace {

constexpr double scripted_frame = 1.0 / 60;   ///< seconds, for what only moves on the screen
constexpr double longest_frame = 0.05;        ///< seconds that the table is given at once
constexpr double keep_period = 0.5;           ///< seconds between looks at what is kept
constexpr double rest_period = 0.5;           ///< seconds that nothing is waited for without asking whether the file has changed
constexpr double clock_period = 0.5;          ///< seconds after which a table at rest shows its clock anew
constexpr double unseen_pixels = 0.02;        ///< that something may move without a new frame

/// What a signal handler may touch; the loop looks at it.
volatile std::sig_atomic_t ending_signal = 0;

/// The second one ends the process at once.
void remember_signal(int number) {
    ending_signal = number;
    static_cast<void>(std::signal(number, SIG_DFL));
}

void listen_to_signals() {
    for (const int number : {SIGTERM, SIGINT, SIGHUP})
        if (std::signal(number, remember_signal) == SIG_IGN) static_cast<void>(std::signal(number, SIG_IGN));  // as nohup wants it
}

std::string window_title(const Document& document) {
    const std::string& path = document.path();
    const std::string name = path.empty() ? "Untitled" : path.substr(path.find_last_of('/') + 1);
    return (document.dirty() ? "\u2022 " : "") + shown(name) + " \u2013 Pinfield";
}

/// What balls meet though it is not drawn: while a table is made its author must see it.
std::vector<NodeId> hidden_solids(const Program& program) {
    std::vector<NodeId> nodes;
    const auto collect = [&](const Field& field) {
        for (const Solid& solid : field.solids)
            if (!solid.visible && (nodes.empty() || nodes.back() != solid.origin)) nodes.push_back(solid.origin);
    };
    collect(program.fixed);
    for (const Mover& mover : program.movers) collect(mover.field);
    return nodes;
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
      outline_painter_(window_->gl()),
      last_seconds_(window_->seconds()),
      watch_(options.listen) {
    window_->listen(options.listen);
    follow_theme();
    state_.give_clipboard = [](const std::string& text) { ImGui::SetClipboardText(text.c_str()); };
    state_.ask_clipboard = [] {
        const char* text = ImGui::GetClipboardText();
        return std::string(text ? text : "");
    };
}

int App::run() {
    listen_to_signals();
    while (!state_.quit && ending_signal == 0) {
        const double wait = seconds_until_frame();
        if (wait > 0) rest(wait);
        else frame();
    }
    if (!state_.quit && state_.keeper) state_.keeper->sync();
    keep_preferences(state_);
    return state_.quit ? 0 : ending_signal;
}

std::string App::run(ScriptRunner script) {
    while (!script.done() && !state_.quit) frame(script.before_frame(state_, *this));
    keep_preferences(state_);
    return script.failure();
}

bool App::press_key(std::string_view key, bool down) {
    const int code = key_code(key);
    if (code >= 0) window_->on_key(code, down);
    return code >= 0;
}

std::optional<Vec2> App::find_words(std::string_view words, std::string_view panel) const {
    const ScreenText* best = nullptr;
    const std::vector<ScreenText> texts = screen_texts();
    const std::string window = panel.empty() ? "" : "##" + std::string(panel);
    for (const ScreenText& text : texts)
        if (text.window.starts_with(window) && (text.text == words || (text.text.starts_with(words) && (!best || best->text != words))))
            best = &text;
    if (!best) return {};
    return Vec2(best->at.x + 0.5 * ImGui::CalcTextSize(best->text.c_str()).x, best->at.y + 0.5 * ImGui::GetFontSize());
}

void App::frame() {
    frame_seconds_ = window_->seconds();
    const double passed = passed_seconds();
    if (options_.ticks_per_frame > 0) draw(options_.ticks_per_frame, scripted_frame);
    else draw(due_ticks(passed), passed);
    window_->present();
    pace_.drawn();
}

void App::frame(int ticks) {
    draw(ticks, scripted_frame);
    window_->present();
}

void App::follow_theme() {
    const Preferences& wanted = state_.preferences;
    if (wanted.theme == theme_ && wanted.font_size == font_size_) return;
    theme_ = wanted.theme;
    font_size_ = wanted.font_size;
    ui_.theme = make_theme(static_cast<float>(window_->content_scale()), static_cast<float>(font_size_), theme_);
    ImGuiBridge::renew_fonts();
}

void App::draw(int ticks, double seconds) {
    follow_theme();
    look_around(seconds);
    shown_messages_ = state_.said;
    for (const WindowEvent& event : window_->take_events()) bridge_.queue(event);
    in_menu_ = menu_is_open(state_);
    for (const WindowEvent& event : bridge_.begin_frame(seconds + std::exchange(rested_seconds_, 0), in_menu_)) {
        if (event.kind == WindowEvent::Kind::cursor) ui_.mouse = event.place;
        else if (event.kind == WindowEvent::Kind::key) take_key(event);
        else if (event.kind == WindowEvent::Kind::close) editor::run(state_, "app.quit");
        else if (event.kind == WindowEvent::Kind::drop) take_dropped_file(state_, event.path);
        else if (event.kind == WindowEvent::Kind::focus && !event.down) state_.session.release_all();
    }
    ui_.hovered = {};
    draw_panels(state_, ui_);
    // After the panels: what they changed is in the table they are painted over.
    advance(state_, ticks);
    window_->set_title(window_title(state_.document));
    paint();
    shown_.take(state_.session.world());
    bridge_.draw();
}

double App::passed_seconds() {
    const double before = std::exchange(last_seconds_, window_->seconds());
    return last_seconds_ - before;
}

void App::look_around(double seconds) {
    age_message(state_, seconds);
    looked_seconds_ += seconds;
    if (options_.listen) ask_for_path();
    if (state_.document.previewing()) return;
    if (looked_seconds_ >= kept_seconds_ + keep_period) {
        kept_seconds_ = looked_seconds_;
        keep_preferences(state_);
    }
    watch_.follow(state_.document.files());
    if (watch_.due(looked_seconds_)) look_at_disk(state_);
}

void App::ask_for_path() {
    using Kind = PathAnswer::Kind;
    const PathAsker asker{[this](const PathQuestion& question, const std::string& at) {
                               return dialog_.open({question.title, question.files, question.patterns, question.saves}, at);
                           },
                          [this]() -> PathAnswer {
                              switch (dialog_.poll()) {
                                  case NativeDialog::State::waiting: return {};
                                  case NativeDialog::State::chosen: return {Kind::chosen, dialog_.path()};
                                  case NativeDialog::State::cancelled: return {Kind::cancelled};
                                  default: return {Kind::failed};
                              }
                          },
                          [this] { dialog_.close(); }};
    ask_elsewhere(state_, asker, asked_);
}

double App::seconds_until_frame() {
    const bool runs = plays(state_);
    const double period = window_->frame_period(), since = window_->seconds() - frame_seconds_;
    Stir stir;
    stir.hidden = window_->minimised();
    stir.events = window_->has_events() || bridge_.wants_frames() || state_.said != shown_messages_;
    stir.table = runs && (options_.ticks_per_frame > 0 || since >= clock_period ||
                          shown_.differs(state_.session.world(), unseen_pixels / canvas().pixels_per_metre));
    if (pace_.due(stir)) return 0.9 * period - since;
    return runs && !stir.hidden ? period : rest_period;
}

void App::rest(double seconds) {
    window_->wait_events(seconds);
    const double passed = passed_seconds();
    rested_seconds_ += passed;
    look_around(passed);
    const bool held = window_->minimised() || options_.ticks_per_frame > 0;  // nobody plays a table that nobody sees
    advance(state_, held ? 0 : due_ticks(passed));
}

int App::due_ticks(double passed) {
    // After a stall the table goes on, it does not catch up.
    const double seconds = std::min(passed, longest_frame);
    if (plays(state_)) real_time_.add(passed, seconds);
    else real_time_ = {};
    state_.real_time = real_time_.share();
    const double step = state_.session.world().step_length();
    owed_seconds_ += seconds;
    const double ticks = std::floor(owed_seconds_ / step);
    owed_seconds_ -= ticks * step;
    return static_cast<int>(ticks);
}

void App::take_key(const WindowEvent& event) {
    keyboard_.take(state_, {key_name(event.code), event.down, event.repeat}, in_menu_ || is_typing(state_, ui_), [this] { return cancel_drags(); });
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
    const Rgb backdrop = palette::backdrop.rgb();
    gl.ClearColor(backdrop.r, backdrop.g, backdrop.b, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);

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
    look.floor_low = Tint(Role::floor_low).rgb();
    look.floor_high = Tint(Role::floor_high).rgb();
    look.backdrop = backdrop;
    look.rim = Tint(Role::rim).rgb();
    look.shadow = theme_ == ThemeChoice::light ? 0.55 : 1;
    look.underlay = underlay_look();
    table_painter_.draw(program, places, balls, look, canvas);
    paint_outlines(program, places, canvas);
    gl.Viewport(0, 0, whole(canvas.framebuffer.x()), whole(canvas.framebuffer.y()));
}

UnderlayLook App::underlay_look() {
    const std::shared_ptr<const Bitmap>& bitmap = state_.underlay.bitmap;
    if (bitmap != painted_underlay_ && bitmap) table_painter_.set_underlay(bitmap->width, bitmap->height, bitmap->rgba.data());
    painted_underlay_ = bitmap;
    const Underlay& underlay = state_.aids.underlay;
    if (!bitmap || !underlay.shown) return {};
    const Box2 box = box_of(underlay, *underlay_pixels(state_));
    return {box.lo, box.size(), underlay.quarter_turns, underlay.opacity, state_.tool == Tool::underlay};
}

void App::paint_outlines(const ProgramPtr& program, std::span<const MoverPlace> places, const Canvas& canvas) {
    const double pixel = ui_.theme.scale;
    for (const Sensor& sensor : program->sensors) {
        const NodeId node = at(program->parts, sensor.part).origin;
        if (plays(state_) && ui_.hovered != node) continue;  // in play nothing is seen of it
        outline_painter_.draw(program, places, node, {palette::teal.rgb(), 0.45, 1.2 * pixel, 0.04, 0.10}, canvas);
    }
    if (!plays(state_))
        for (const NodeId node : hidden_solids(*program))
            outline_painter_.draw(program, places, node, {palette::quiet.rgb(), 0.6, pixel, 0, 0.14}, canvas);
    if (ui_.hovered && !state_.selection.contains(ui_.hovered) && !ui_.drag.active())
        paint_outline(ui_.hovered, places, {palette::text.rgb(), 0.75, 1.4 * pixel, 0.06, 0}, canvas);
    for (const NodeId node : state_.selection.nodes())
        paint_outline(node, places, {palette::accent.rgb(), 1, 2.2 * pixel, 0.12, 0}, canvas);
}

/// Of a group, which has no solid of its own, those of its members.
void App::paint_outline(NodeId node, std::span<const MoverPlace> places, const OutlineStyle& style, const Canvas& canvas) {
    const Node* found = state_.document.scene().find(node);
    if (!found || outline_painter_.draw(state_.session.world().shared_program(), places, node, style, canvas)) return;
    for (const NodeId child : found->children) paint_outline(child, places, style, canvas);
}

Result<bool> App::screenshot(const std::string& path) {
    draw(0, scripted_frame);
    int width = 0, height = 0;
    const std::vector<unsigned char> pixels = window_->read_pixels(width, height);  // before the buffers are swapped
    window_->present();
    return write_png(path, width, height, pixels);
}

}  // namespace pinfield::editor
