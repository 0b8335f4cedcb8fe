// The editor's whole state and what actions do to it: everything a script or a test can reach without a window.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/actions.h"
#include "editor/document.h"
#include "editor/follow_disk.h"
#include "editor/preferences.h"
#include "editor/recent.h"
#include "editor/recovery.h"
#include "editor/selection.h"
#include "editor/session.h"
#include "editor/source_draft.h"
#include "editor/structure_tools.h"
#include "editor/table_aids.h"
#include "editor/view.h"
#include "engine/io/picture_file.h"

namespace pinfield::editor {

/// A question the user must answer before unsaved work would be lost (by prompt.save, prompt.discard or prompt.cancel),
/// and what goes on after.
struct Prompt {
    std::string question;
    std::string then_action;  ///< run when the answer is save or discard: "new.blank", "file.open", "app.quit"
    std::string path{};       ///< the file that then_action opens; empty: it asks
};

/// What the arrow keys did last: further ones are part of the same step while nothing else has been done since.
struct Nudge {
    std::vector<NodeId> nodes;
    Vec2 steps{0, 0};                        ///< of the grid, all of them together
    double grid = 0;                         ///< metres
    std::shared_ptr<const SourceText> left;  ///< the text they left
};

/// When a message was said: it goes once this is no longer so.
struct Occasion {
    std::shared_ptr<const SourceText> text{};
    std::vector<NodeId> selected{};
    double age = 0;  ///< seconds
};

/// What the mouse does over the table. select: all of it, with the handles of a node; move: nodes only; turn and scale: the selection;
/// measure: nothing; underlay: the picture beneath the table.
enum class Tool : unsigned char { select, move, turn, scale, measure, underlay };

/// The picture that was read for the underlay.
struct UnderlayPicture {
    std::string path{};
    std::shared_ptr<const Bitmap> bitmap{};  ///< null: it could not be read
};

/// One point of a node's: what was clicked last, and what Delete takes out.
struct PickedPoint {
    NodeId node;
    int field = 0, component = 0;
};

struct AppState {
    AppState(std::shared_ptr<const Catalog> catalog, Document document);

    std::shared_ptr<const Catalog> catalog;
    Document document;
    Session session;
    View view;
    Selection selection;
    Tool tool = Tool::select;
    std::optional<PickedPoint> point{};
    NodeId entered;             ///< the operator or part whose children are clicked and dragged now; none: the table's own nodes
    std::optional<Vec2> pointer{};  ///< where the mouse is over the table, metres
    Nudge nudge{};
    std::string clipboard;      ///< what was cut or copied: YAML
    std::function<void(const std::string&)> give_clipboard{};  ///< to other programs, where there is a window
    std::function<std::string()> ask_clipboard{};              ///< of other programs, likewise
    std::optional<Prompt> prompt;
    std::string message;        ///< status line; what the last action said
    bool message_is_problem = false;
    int said = 0;               ///< how many messages there were, and how often one went
    Occasion occasion{};        ///< of the message
    std::string dialog_action;  ///< "file.open" or another while its path is being asked for, until dialog.accept or
    std::string dialog_path;    ///< dialog.cancel; what the user typed so far
    std::string replaces{};     ///< another file that was asked about: naming it once more replaces it
    NodeId renaming{};          ///< its new id is to be typed in the tree
    bool find_node = false;     ///< the tree's filter is to take the keyboard
    bool type_value = false;    ///< the first value in the inspector is to be typed
    bool open_menus = false;    ///< the first menu is to open, for the keyboard
    std::optional<Prompt> after_dialog;  ///< goes on once "file.save_as" has saved
    DiskState disk = DiskState::same;    ///< as look_at_disk() found it last
    std::optional<MergeQuestion> merge{};  ///< until merge.accept, merge.mine, merge.theirs or merge.later
    std::string merge_put_off{};         ///< the file's text that is not asked about again
    std::optional<SharedEdit> shared{};  ///< until shared.everywhere, shared.here or shared.cancel
    std::optional<HomeQuestion> home{};  ///< until home.1 ... home.6 or home.cancel
    bool show_lists = false;             ///< the table's inputs and tests are listed, to be added, renamed and taken out
    bool asks_elsewhere = false;         ///< the path is asked for by another program's window
    std::optional<WorkKeeper> keeper;    ///< none: unsaved work is neither kept nor offered (scripts, tests)
    RecentFiles recent{};
    Preferences preferences{};           ///< what outlives this run, as
    PreferencesFile preferences_file{};  ///< keeps it
    TableAids aids{};                    ///< laid over this table to work by, as
    AidsFolder aids_folder{};            ///< keeps it
    UnderlayPicture underlay{};          ///< as the aids name it
    std::optional<Recovery> recovery;    ///< unsaved work on offer, until recover.restore, recover.discard or recover.later
    std::vector<Orphan> more_to_recover; ///< offered after it
    bool choosing = false;      ///< File > New asks which table to begin with
    SourceDraft source{};       ///< what is typed in the source panel
    bool type_source = false;   ///< the source panel is to take the keyboard
    bool quit = false;
    bool show_panels = true;    ///< false: the table alone
    bool show_help = false;
    bool show_preferences = false;  ///< the dialog
    bool show_command_palette = false;
    double real_time = 1;       ///< share of real time that the table was given of late; less than 1: the computer is too slow
};

/// Whether something waits for an answer: until it is given the table holds and keys are the answer's alone.
bool asks(const AppState& state);
/// Whether the table goes on: it plays, and nothing asks.
bool plays(const AppState& state);

/// Whether an action can run now; run it. An unknown name is a programming error, a refused one leaves a message.
bool enabled(const AppState& state, std::string_view action);
void run(AppState& state, std::string_view action);
/// Whether an action is a switch or one of several choices, and on.
bool is_on(const AppState& state, std::string_view action);

/// What the status line says from now on, until the text changes; a problem also until something else is selected or done, anything else
/// for some seconds.
void say(AppState& state, const std::string& message, bool problem = false);
/// The status line says nothing more of a problem.
void forget_problem(AppState& state);
/// So many seconds have passed.
void age_message(AppState& state, double seconds);
/// Undoes or redoes until so many steps of the history are done.
void go_to_step(AppState& state, std::size_t done);
/// Asks for the path that an action needs.
void ask_path(AppState& state, std::string action);
/// Opens a file in place of the document (a drop, a recent file), after asking about unsaved work.
void open_file(AppState& state, const std::string& path);
/// Applies one edit as one undo step; a refusal becomes the message. True when it was applied.
bool edit(AppState& state, const SetField& change, const std::string& label);
/// Selects one node alone; a child of an operator or part is entered with it, so that its siblings can be clicked and dragged.
void select(AppState& state, NodeId node);
/// Selects these; the last of them is the one that panels show.
void select(AppState& state, std::vector<NodeId> nodes);
/// Puts a new node of this type beside the selection, at a place of the world (else in the middle of the view), and selects it.
/// A number of a field made a param that it calls, under a name like the field's; a param written out wherever it is called.
void make_param(AppState& state, NodeId node, int field, int part);
void write_out_param(AppState& state, const std::string& name);
void add_node(AppState& state, const NodeType& type, const std::optional<Vec2>& world = {});
/// Puts the selected nodes into a new node of this type.
void wrap_selection(AppState& state, const NodeType& type);
/// Selects what a structural edit has left, or says why there was none. True when it was done.
bool take(AppState& state, const Outcome& outcome);
/// Keeps what changed safe, lets the running table take it, then advances that unless something asks: once a frame.
void advance(AppState& state, int ticks);
/// Follows the file when it was changed outside: now and then.
void look_at_disk(AppState& state);
/// Whether the table binds an input to a key.
bool is_table_key(const AppState& state, std::string_view key);
/// A key goes to the inputs that the table binds to it; false when it binds none.
bool press_key(AppState& state, std::string_view key, bool down);

}  // namespace pinfield::editor
