#include "editor/follow_disk.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "editor/handlers.h"

namespace pinfield::editor {
namespace {

std::string file_name(const AppState& state) { return state.document.path().substr(state.document.path().find_last_of('/') + 1); }

void ask(AppState& state) {
    const std::shared_ptr<const DiskMerge>& merge = state.document.disk_merge();
    state.merge = MergeQuestion{merge, std::vector<Whose>(merge->conflicts.size(), Whose::mine), 0};
}

std::string left_out(const AppState& state) {
    const int count = state.document.comments_left_out();
    if (count == 0) return {};
    return fmt::format("; {} left out, Undo shows {}", count == 1 ? "a comment was" : fmt::format("{} comments were", count),
                       count == 1 ? "it" : "them");
}

void say_merged(AppState& state) {
    state.merge.reset();
    state.merge_put_off.clear();
    state.disk = DiskState::same;
    say(state, fmt::format("Merged with {} as it is on disk{}", file_name(state), left_out(state)), state.document.comments_left_out() > 0);
}

void accept(AppState& state) {
    const MergeQuestion& question = *state.merge;
    Choices choices;
    for (std::size_t i = 0; i < question.taken.size(); ++i) choices.emplace(question.merge->conflicts[i].conflict, question.taken[i]);
    if (const auto why = state.document.merge_disk(choices))
        return say(state, fmt::format("These choices do not go together: {}", *why), true);
    say_merged(state);
}

/// Whole, where there is nothing to merge; else every value that is asked about.
void take_all(AppState& state, Whose side) {
    if (state.merge->merge->refusal.empty()) {
        std::fill(state.merge->taken.begin(), state.merge->taken.end(), side);
        return accept(state);
    }
    if (const auto why = state.document.settle_disk(side)) return say(state, *why, true);
    say_merged(state);
}

void take_here(AppState& state, Whose side) {
    MergeQuestion& question = *state.merge;
    question.taken[question.row] = side;
    if (question.row + 1 < question.taken.size()) ++question.row;
}

void put_off(AppState& state) {
    state.merge_put_off = state.merge->merge->disk;
    state.merge.reset();
    say(state,
        fmt::format("{} changed on disk too: File > Merge asks again, Reload takes that version, Save As keeps yours", file_name(state)),
        true);
}

bool asks_merge(const AppState& s) { return s.merge.has_value(); }
bool asks_values(const AppState& s) { return s.merge && !s.merge->taken.empty(); }
bool can_merge(const AppState& s) { return s.merge && s.merge->merge->refusal.empty(); }

void tell(AppState& state, DiskState before) {
    const std::string name = file_name(state);
    const bool is_new = state.disk != before;
    if (state.disk == DiskState::reloaded) {
        say(state, fmt::format("{} changed on disk and was reloaded", name));
        if (state.recovery) state.recovery = recovery_of(std::move(state.recovery->orphan), state.document);
        state.disk = DiskState::same;
    } else if (state.disk == DiskState::merged) {
        say_merged(state);
    } else if (state.disk == DiskState::broken && is_new) {
        say(state, fmt::format("{} changed on disk and cannot be read; the last good table keeps running", name), true);
    } else if (state.disk == DiskState::conflict && is_new && !state.document.disk_merge()) {
        say(state, fmt::format("{} changed on disk too, and cannot be read: Save As keeps yours", name), true);
    } else if (state.disk == DiskState::missing && is_new) {
        say(state, fmt::format("{} is gone from the disk: Save writes it again", name), true);
    }
}

}  // namespace

void look_at_disk(AppState& state) {
    const DiskState before = std::exchange(state.disk, state.document.check_disk());
    const std::shared_ptr<const DiskMerge>& merge = state.document.disk_merge();
    if (state.merge && state.merge->merge != merge) state.merge.reset();  // the file has changed once more
    tell(state, before);
    if (merge && !state.merge && merge->disk != state.merge_put_off) ask(state);
}

std::span<const Handler> merge_handlers() {
    static const Handler handlers[] = {
        {"merge.ask", [](const AppState& s) { return s.document.disk_merge() != nullptr; }, ask},
        {"merge.mine_here", asks_values, [](AppState& s) { take_here(s, Whose::mine); }},
        {"merge.theirs_here", asks_values, [](AppState& s) { take_here(s, Whose::theirs); }},
        {"merge.mine", asks_merge, [](AppState& s) { take_all(s, Whose::mine); }},
        {"merge.theirs", asks_merge, [](AppState& s) { take_all(s, Whose::theirs); }},
        {"merge.accept", can_merge, accept},
        {"merge.later", asks_merge, put_off},
    };
    return handlers;
}

}  // namespace pinfield::editor
