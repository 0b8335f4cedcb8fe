// The editor's whole state and what actions do to it: everything a script or a test can reach without a window.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "editor/document.h"
#include "editor/session.h"
#include "editor/view.h"

namespace pinfield::editor {

/// A question the user must answer before unsaved work would be lost, and what goes on after.
struct Prompt {
    std::string question;
    std::string then_action;  ///< run when the answer is save or discard: "file.new", "file.open", "app.quit"
};

struct AppState {
    AppState(std::shared_ptr<const Catalogue> catalogue, Document document);

    std::shared_ptr<const Catalogue> catalogue;
    Document document;
    Session session;
    View view;
    NodeId selection;
    std::optional<Prompt> prompt;
    std::string message;        ///< status line; what the last action said
    std::string dialog_action;  ///< "file.open" or "file.save_as" while its path is being asked for
    std::string dialog_path;
    bool quit = false;
    bool show_help = false;
};

/// Whether an action can run now; run it. An unknown name is a programming error, a refused one leaves a message.
bool enabled(const AppState& state, std::string_view action);
void run(AppState& state, std::string_view action);

/// Scene node whose solid is at (or within `slack` metres of) a world point, movers included; the smallest one when several
/// overlap; none in free space. Locked nodes do not count, nor does the domain.
NodeId pick(const AppState& state, const Vec2& world, double slack);

}  // namespace pinfield::editor
