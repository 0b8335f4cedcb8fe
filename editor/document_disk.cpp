// The document and its file, when that is changed by others.
#include <algorithm>
#include <filesystem>
#include <utility>

#include "editor/document.h"
#include "engine/io/files.h"
#include "engine/scene/match.h"

namespace pinfield::editor {

DiskState Document::check_disk() {
    // A drag in progress goes first: it ends in a text, which is then compared.
    if (path_.empty() || previewing()) return DiskState::same;
    Result<std::string> text = read_file(path_);
    if (!text) {
        std::error_code error;
        if (std::filesystem::exists(path_, error)) return DiskState::same;  // there, only not to be read
        ++looks_without_file_;                                              // programs that replace a file take it away for a moment
        return is_missing() ? DiskState::missing : DiskState::same;
    }
    looks_without_file_ = 0;
    if (*text == disk_text_) {
        broken_.reset();
        disk_merge_.reset();
        return follow_files();
    }
    if (dirty() && *text != source().text()) return follow_dirty(std::move(*text));
    if (dirty()) return agree_with_disk(), DiskState::same;
    if (broken_ && broken_->source().text() == *text) return DiskState::broken;
    Reading reading = read(std::move(*text));
    if (!reading.ok()) {
        broken_ = std::make_shared<const Reading>(std::move(reading));
        return DiskState::broken;
    }
    follow_disk(std::move(reading));
    return DiskState::reloaded;
}

/// The same text where a file that it includes is another one: no step, as undo does not change that file.
DiskState Document::follow_files() {
    const auto is_as_read = [&](const auto& file) {
        const Result<FoundFile> now = reading_->open(file.first, Limits{}.file_bytes + 1);
        return now && now->text == file.second->source->text();
    };
    if (!reading_->open || previewing() || std::all_of(reading_->files.begin(), reading_->files.end(), is_as_read)) return DiskState::same;
    Reading reading = read(source().text());
    if (!reading.ok()) {
        broken_ = std::make_shared<const Reading>(std::move(reading));
        return DiskState::broken;
    }
    broken_.reset();
    const std::shared_ptr<const Reading> before = reading_;
    take(std::move(reading), &before->scene);
    const std::vector<SceneChange> made = changes_between(before->scene, reading_->scene);
    changes_.insert(changes_.end(), made.begin(), made.end());
    return DiskState::reloaded;
}

Result<void> Document::reload() {
    if (path_.empty()) return failure("the table has no file yet");
    cancel_preview();
    Result<std::string> text = read_file(path_);
    if (!text) return tl::unexpected(text.error());
    Reading reading = read(std::move(*text));
    if (!reading.ok()) return failure(format(reading.diagnostics.front(), reading.scene.sources));
    follow_disk(std::move(reading));
    return {};
}

/// Takes a sound text from the disk as a step of its own, so that undo gives the earlier text back.
void Document::follow_disk(Reading reading) {
    put(std::move(reading), "Reload", true);
    agree_with_disk();
}

/// The disk's text as it was last seen, its nodes with the ids they have here.
Reading Document::saved_reading() const {
    Reading saved = read(disk_text_);
    if (saved.scene.all().size() == disk_ids_.size())
        saved.scene.take_ids(disk_ids_, reading_->scene);
    else
        saved.scene.take_ids(match(reading_->scene, saved.scene), reading_->scene);
    return saved;
}

DiskState Document::follow_dirty(std::string disk) {
    if (disk_merge_ && disk_merge_->disk == disk && disk_merge_->ours == shared_source()) return DiskState::conflict;
    disk_merge_.reset();
    Reading theirs = read(disk);
    const Reading base = saved_reading();
    if (!theirs.ok() || !base.ok() || !reading_->ok()) return DiskState::conflict;
    MergedText merged = merge_text(base, *reading_, std::move(theirs));
    if (merged.refusal.empty() && merged.conflicts.empty()) {
        comments_left_out_ = merged.comments_left_out;
        take_merged(std::move(merged.reading), std::move(disk));
        return DiskState::merged;
    }
    disk_merge_ = std::make_shared<const DiskMerge>(
        DiskMerge{std::move(disk), shared_source(), std::move(merged.conflicts), std::move(merged.refusal)});
    return DiskState::conflict;
}

/// The text is the file's with what was edited here: as unsaved as it was before, but of the file as it is now.
void Document::take_merged(Reading reading, std::string disk) {
    const std::size_t edits = std::max<std::size_t>(unsaved_steps(), 1);
    put(std::move(reading), "Merge with the file", false, true);
    if (source().text() == disk) return agree_with_disk();
    disk_text_ = std::move(disk);
    disk_merge_.reset();
    broken_.reset();
    saved_position_ = position_;
    lost_steps_ = edits;
    Reading saved = read(disk_text_);
    saved.scene.take_ids(match(reading_->scene, saved.scene), reading_->scene);
    disk_ids_ = saved.scene.all();
}

std::optional<std::string> Document::merge_disk(const Choices& choices) {
    if (!disk_merge_) return "there is nothing to merge";
    cancel_preview();
    MergedText merged = merge_text(saved_reading(), *reading_, read(disk_merge_->disk), choices);
    if (!merged.refusal.empty()) return std::move(merged.refusal);
    comments_left_out_ = merged.comments_left_out;
    take_merged(std::move(merged.reading), disk_merge_->disk);
    return {};
}

std::optional<std::string> Document::settle_disk(Whose whole) {
    if (!disk_merge_) return "there is nothing to merge";
    cancel_preview();
    comments_left_out_ = 0;
    take_merged(whole == Whose::mine ? *reading_ : read(disk_merge_->disk), disk_merge_->disk);
    return {};
}

}  // namespace pinfield::editor
