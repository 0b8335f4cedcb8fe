// Runs a script's steps over the editor: on its state where a name is enough, through the window's own mouse and keys where a hand
// is due. Frames and ticks are counted, never timed, so that a script does the same everywhere.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "editor/app_state.h"
#include "engine/io/script_reader.h"

namespace pinfield::editor {

/// What a script needs of a window. Events go the way of the user's own; they are seen by the next frame.
class ScriptHost {
public:
    virtual ~ScriptHost() = default;
    virtual void move_mouse(const Vec2& pixel) = 0;  ///< window pixels, y down
    virtual void press_mouse(int button, bool down) = 0;  ///< 0 left, 1 right, 2 middle
    virtual void scroll(double notches) = 0;
    virtual void type(unsigned character) = 0;
    /// The middle of words on the screen (in a panel, where one is named), in window pixels: of a text that is just so, else of one that
    /// begins so, the topmost.
    virtual std::optional<Vec2> find_words(std::string_view words, std::string_view panel) const = 0;
    virtual bool press_key(std::string_view key, bool down) = 0;  ///< false when no keyboard has it
    /// Writes the frame drawn last as a PNG.
    virtual Result<bool> screenshot(const std::string& path) = 0;
    virtual int ticks_per_frame() const = 0;
};

/// The loop around it:
///     while (!runner.done()) { const int ticks = runner.before_frame(state, host); draw a frame that advances by ticks; }
class ScriptRunner {
public:
    /// A script without errors.
    ScriptRunner(SourceText source, Script script);

    bool done() const { return !failure_.empty() || index_ >= script_.steps.size(); }
    /// "steps.yaml:4:3: step 2 (expect): why"; empty while all is well.
    const std::string& failure() const { return failure_; }
    /// Does what is due before the next frame and returns how many ticks that frame is to advance. Steps that need no frame of their
    /// own are done at once; a drag, a key and a wait take several.
    int before_frame(AppState& state, ScriptHost& host);

private:
    /// Ticks of the frame a step is waiting for, or nothing when it is done.
    using Frame = std::optional<int>;

    Frame run(const ScriptStep& step, AppState& state, ScriptHost& host);
    Frame run_action(const ScriptStep& step, AppState& state);
    Frame run_set(const ScriptStep& step, AppState& state);
    Frame run_structure(const ScriptStep& step, AppState& state);
    Frame run_hand(const ScriptStep& step, const AppState& state, ScriptHost& host);
    Frame run_click(const ScriptStep& step, const AppState& state, ScriptHost& host);
    Frame run_drag(const ScriptStep& step, const AppState& state, ScriptHost& host);
    Frame run_scroll(const ScriptStep& step, const AppState& state, ScriptHost& host);
    Frame run_type(const ScriptStep& step, ScriptHost& host);
    Frame run_key(const ScriptStep& step, ScriptHost& host);
    Frame run_wait(int ticks, const ScriptHost& host);
    Frame run_screenshot(const ScriptStep& step, ScriptHost& host);
    Frame run_expect(const ScriptStep& step, const AppState& state);
    Frame fail(const std::string& why);
    bool hold(const ScriptStep& step, ScriptHost& host, bool down);
    bool find(const ScriptPoint& point, const AppState& state, const ScriptHost& host, Vec2& pixel);
    std::optional<std::vector<NodeId>> nodes_of(const ScriptStep& step, const AppState& state);

    SourceText source_;
    Script script_;
    std::string failure_;
    std::size_t index_ = 0;
    int frame_ = 0;          ///< frames that the present step has had
    int ticks_run_ = 0;      ///< ticks that the present step has had
    bool released_ = false;  ///< the key of the present step
    Vec2 from_{0, 0}, to_{0, 0};  ///< window pixels, of the present step
    Vec2 clicked_{-1e9, -1e9};    ///< where the last click was, and
    int frames_since_click_ = 0;  ///< how long ago: two near each other are no double click
    int frames_to_settle_;   ///< before the first step: the window lays its panels out
};

/// Why a field of a node, or a quantity of the editor, is not what was expected; or nothing. Quantities: `<node>.hits`, and of the
/// node `editor`: dirty, playing, selection, hits, drained, balls, problems, undo_steps; of `preferences`: each by its key; of `underlay`:
/// there, opacity and, in millimetres, width, x and y of its middle. A value of a quantity may begin with a comparison (">= 3").
std::optional<std::string> unmet(const ScriptStep& expectation, const AppState& state);

}  // namespace pinfield::editor
