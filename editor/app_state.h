// The editor's whole state and what actions do to it: everything a script or a test can reach without a window.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "editor/actions.h"
#include "editor/document.h"
#include "editor/selection.h"
#include "editor/session.h"
#include "editor/structure_tools.h"
#include "editor/view.h"

namespace pinfield::editor {

/// A question the user must answer before unsaved work would be lost (by prompt.save, prompt.discard or prompt.cancel),
/// and what goes on after.
struct Prompt {
    std::string question;
    std::string then_action;  ///< run when the answer is save or discard: "file.new", "file.open", "app.quit"
    std::string path{};       ///< the file that then_action opens; empty: it asks
};

struct AppState {
    AppState(std::shared_ptr<const Catalog> catalog, Document document);

    std::shared_ptr<const Catalog> catalog;
    Document document;
    Session session;
    View view;
    Selection selection;
    std::string clipboard;      ///< what was cut or copied: YAML
    std::function<void(const std::string&)> give_clipboard{};  ///< to other programs, where there is a window
    std::function<std::string()> ask_clipboard{};              ///< of other programs, likewise
    std::optional<Prompt> prompt;
    std::string message;        ///< status line; what the last action said
    bool message_is_problem = false;
    std::string dialog_action;  ///< "file.open" or "file.save_as" while its path is being asked for, until dialog.accept or
    std::string dialog_path;    ///< dialog.cancel; what the user typed so far
    std::optional<Prompt> after_dialog;  ///< goes on once "file.save_as" has saved
    DiskState disk = DiskState::same;    ///< as look_at_disk() found it last
    bool quit = false;
    bool show_help = false;
};

/// Whether an action can run now; run it. An unknown name is a programming error, a refused one leaves a message.
bool enabled(const AppState& state, std::string_view action);
void run(AppState& state, std::string_view action);

/// Opens a file in place of the document (a drop, a recent file), after asking about unsaved work.
void open_file(AppState& state, const std::string& path);
/// Applies one edit as one undo step; a refusal becomes the message. True when it was applied.
bool edit(AppState& state, const SetField& change, const std::string& label);
/// Puts a new node of this type beside the selection, in the middle of the view, and selects it.
void add_node(AppState& state, const NodeType& type);
/// Puts the selected nodes into a new node of this type.
void wrap_selection(AppState& state, const NodeType& type);
/// Selects what a structural edit has left, or says why there was none. True when it was done.
bool take(AppState& state, const Outcome& outcome);
/// Lets the running table take what changed, then advances it: once a frame.
void advance(AppState& state, int ticks);
/// Follows the file when it was changed outside: now and then.
void look_at_disk(AppState& state);
/// A key goes to the inputs that the table binds to it; false when it binds none.
bool press_key(AppState& state, std::string_view key, bool down);

/// Scene node whose solid is at (or within `slack` metres of) a world point, movers included; the smallest one when several
/// overlap; none in free space. Sensors answer within their region, and every part with no solid within 12 mm of its place.
/// Locked nodes do not count, nor does the domain.
NodeId pick(const AppState& state, const Vec2& world, double slack);

/// World box around a node and all below it as it runs now; at least its place, 12 mm about. May be infinite.
Box2 bounds_of(const AppState& state, NodeId node);

}  // namespace pinfield::editor
