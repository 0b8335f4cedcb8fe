#include "editor/ask_elsewhere.h"

#include <utility>

namespace pinfield::editor {

void ask_elsewhere(AppState& state, const PathAsker& asker, std::string& asked) {
    if (state.dialog_action != asked) {
        if (state.asks_elsewhere) asker.close();
        asked = state.dialog_action;
        state.asks_elsewhere = false;
        if (!asked.empty()) {
            const PathQuestion& question = path_question(asked);
            state.asks_elsewhere = asker.open(question, state.dialog_path.empty() && question.saves ? "table.yaml" : state.dialog_path);
        }
    }
    if (!state.asks_elsewhere) return;
    PathAnswer answer = asker.poll();
    if (answer.kind == PathAnswer::Kind::waiting) return;
    state.asks_elsewhere = false;
    if (answer.kind == PathAnswer::Kind::failed) return;  // the window asks
    if (answer.kind == PathAnswer::Kind::cancelled) {
        run(state, "dialog.cancel");
    } else {
        state.replaces = answer.path;  // whoever chose an existing file was asked there
        state.dialog_path = std::move(answer.path);
        run(state, "dialog.accept");
    }
    asked = state.dialog_action;
}

}  // namespace pinfield::editor
