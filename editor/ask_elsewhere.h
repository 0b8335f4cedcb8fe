// A path that the desktop's own dialog asks for, in place of the window's. No window, no ImGui.
#pragma once
#include <functional>
#include <string>

#include "editor/app_state.h"
#include "editor/path_question.h"

namespace pinfield::editor {

/// What the other program has answered so far.
struct PathAnswer {
    enum class Kind : unsigned char { waiting, chosen, cancelled, failed };
    Kind kind = Kind::waiting;
    std::string path{};
};

/// Another program that asks for paths.
struct PathAsker {
    std::function<bool(const PathQuestion& question, const std::string& at)> open;  ///< false: there is none
    std::function<PathAnswer()> poll;
    std::function<void()> close;
};

/// Once a frame: opens it when a path is to be asked for, and takes its answer. Where there is none, where it fails, and where its path was
/// not taken, the window asks itself. `asked`: the action it was opened for, kept between calls.
void ask_elsewhere(AppState& state, const PathAsker& asker, std::string& asked);

}  // namespace pinfield::editor
