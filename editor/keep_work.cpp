#include "editor/keep_work.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <utility>
#include <vector>

namespace pinfield::editor {
namespace {

/// Seconds since some start.
double steady_seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Whether an orphan is offered beside the document: its own file's work; beside a new table, that of tables without a file.
bool concerns(const UnsavedWork& work, const Document& document) {
    std::error_code unknown;
    if (!document.path().empty()) return work.table == table_path(document.path());
    return work.table.empty() || !std::filesystem::exists(work.table, unknown);
}

/// The next of the orphans that has something the document does not hold; those that do not are of no use any more.
void offer_next(AppState& state) {
    state.recovery.reset();
    while (!state.recovery && !state.more_to_recover.empty()) {
        Orphan orphan = std::move(state.more_to_recover.front());
        state.more_to_recover.erase(state.more_to_recover.begin());
        if (orphan.work.text == state.document.source().text() && !orphan.work.draft) remove_orphan(orphan.file);
        else state.recovery = recovery_of(std::move(orphan), state.document);
    }
}

/// Returns the orphans that do not concern this document.
std::vector<Orphan> offer(AppState& state, std::vector<Orphan> orphans) {
    const auto others = std::stable_partition(orphans.begin(), orphans.end(),
                                              [&](const Orphan& orphan) { return concerns(orphan.work, state.document); });
    std::vector<Orphan> rest(std::make_move_iterator(others), std::make_move_iterator(orphans.end()));
    orphans.erase(others, orphans.end());
    state.more_to_recover = std::move(orphans);
    offer_next(state);
    return rest;
}

}  // namespace

void keep_work(AppState& state, const std::string& folder) {
    state.keeper.emplace(folder);
    Orphans orphans = find_orphans(folder);
    const std::vector<Orphan> others = offer(state, std::move(orphans.found));
    if (!orphans.unreadable.empty())
        say(state, fmt::format("A journal of unsaved work cannot be read and is left alone: {}", orphans.unreadable.front()), true);
    else if (!others.empty() && !others.front().work.table.empty())
        say(state, fmt::format("There is unsaved work on {}: open it to have it back", others.front().work.table));
}

void keep_safe(AppState& state) {
    if (!state.keeper || state.quit) return;
    if (const auto complaint = state.keeper->follow(state.document, steady_seconds(), state.source.pending_text())) say(state, *complaint, true);
}

void offer_work(AppState& state) {
    if (state.keeper) offer(state, find_orphans(state.keeper->folder()).found);
}

/// The orphan goes only once the work is safe with this editor.
void restore_work(AppState& state) {
    const Recovery recovery = *std::exchange(state.recovery, std::nullopt);
    state.more_to_recover.clear();  // they would go over this one: offered again when the table is opened again
    const UnsavedWork& work = recovery.orphan.work;
    state.document.restore(work.text, static_cast<std::size_t>(work.edits));
    say(state, "Restored: Save keeps it, Undo takes it back");
    if (work.draft) {
        state.source.restore(state.document, *work.draft);
        state.preferences.show_source = true;
        say(state, "Restored, with what was typed in the source and does not read yet");
    }
    keep_safe(state);
    if (state.keeper->sync()) remove_orphan(recovery.orphan.file);
}

void discard_work(AppState& state) {
    remove_orphan(state.recovery->orphan.file);
    offer_next(state);
}

void put_work_off(AppState& state) { offer_next(state); }

}  // namespace pinfield::editor
