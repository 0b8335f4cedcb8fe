#include "editor/recovery.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <utility>

namespace pinfield::editor {
namespace {

namespace fs = std::filesystem;

constexpr double sync_period = 2;   // seconds
constexpr double retry_period = 5;  // seconds
constexpr int most_diff_lines = 20;

std::string counted(std::int64_t count, std::string_view what) { return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s"); }

std::string age(std::int64_t seconds) {
    if (seconds < 60) return "less than a minute ago";
    if (seconds < 3600) return counted(seconds / 60, "minute") + " ago";
    if (seconds < 86400) return counted(seconds / 3600, "hour") + " ago";
    return counted(seconds / 86400, "day") + " ago";
}

/// The reading's, not the preview's: what is previewed is not yet done.
const std::shared_ptr<const SourceText>& text_of(const Document& document) { return document.reading().scene.sources.shared_main(); }

}  // namespace

std::int64_t seconds_since_1970() {
    return std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch()).count();
}

std::string table_path(const std::string& path) {
    if (path.empty()) return {};
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(fs::absolute(path, error), error);
    return error ? path : whole.string();
}

UnsavedWork unsaved_work(const Document& document, const std::shared_ptr<const SourceText>& draft) {
    const std::string* const label = document.undo_label();
    return {table_path(document.path()),
            document.saved_text(),
            text_of(document)->text(),
            static_cast<std::int64_t>(document.unsaved_steps()),
            label ? *label : std::string(),
            seconds_since_1970(),
            draft ? std::optional(draft->text()) : std::nullopt};
}

bool WorkKeeper::follows(const Document& document, const std::shared_ptr<const SourceText>& draft) const {
    return text_ == text_of(document) && draft_ == draft && table_ == document.path() && base_ == document.saved_text();
}

std::optional<std::string> WorkKeeper::follow(const Document& document, double now, const std::shared_ptr<const SourceText>& draft) {
    if (!document.dirty() && !draft) {
        if (text_) drop();
        return {};
    }
    if (!follows(document, draft)) {
        text_ = text_of(document);
        draft_ = draft;
        table_ = document.path();
        base_ = document.saved_text();
        due_ = true;
    }
    if ((!due_ && !unsynced_) || (failing_ && now < retry_at_)) return {};
    Result<void> kept;
    if (due_) kept = journal_.write(unsaved_work(document, draft_));
    if (kept && due_) {
        due_ = false;
        unsynced_ = true;
    }
    if (kept && unsynced_ && now >= sync_at_) {
        sync_at_ = now + sync_period;
        kept = journal_.sync();
        unsynced_ = !kept;
    }
    const bool failed_before = std::exchange(failing_, !kept);
    if (kept) return {};
    retry_at_ = now + retry_period;
    if (failed_before) return {};
    return fmt::format("Unsaved work is not protected: {}", kept.error().message);
}

bool WorkKeeper::sync() {
    if (unsynced_ && journal_.sync()) unsynced_ = false;
    return !due_ && !unsynced_;
}

void WorkKeeper::drop() {
    journal_.drop();
    text_.reset();
    draft_.reset();
    due_ = unsynced_ = failing_ = false;
}

Recovery recovery_of(Orphan orphan, const Document& document) {
    const std::string& now = document.source().text();
    Recovery recovery{std::move(orphan)};
    const UnsavedWork& work = recovery.orphan.work;
    recovery.file_gone = !work.table.empty() && document.path().empty();
    recovery.file_changed = !recovery.file_gone && work.base != now;
    recovery.diff = line_diff(recovery.file_gone ? work.base : now, work.draft.value_or(work.text), most_diff_lines);
    return recovery;
}

std::string summary(const Recovery& recovery, std::int64_t now) {
    const UnsavedWork& work = recovery.orphan.work;
    const std::string name = work.table.empty() ? "A new table" : fs::path(work.table).filename().string();
    const std::string when = age(std::max<std::int64_t>(now - work.time, 0));
    if (work.draft && work.edits == 0) return fmt::format("{}: text typed in the source that does not read yet, {}.", name, when);
    if (work.edits == 0) return fmt::format("{}: its file was gone, {}.", name, when);
    const std::string last = work.last_label.empty() ? "" : fmt::format("; the last one: {}", work.last_label);
    const std::string typed = work.draft ? "; and text typed in the source that does not read yet" : "";
    return fmt::format("{}: {} since the last save, {}{}{}.", name, counted(work.edits, "edit"), when, last, typed);
}

}  // namespace pinfield::editor
