// The document and its file, when that is changed by others.
#include <algorithm>
#include <filesystem>
#include <utility>

#include "editor/document.h"
#include "engine/core/error_codes.h"
#include "engine/io/files.h"
#include "engine/scene/match.h"

namespace pinfield::editor {

std::vector<std::string> Document::files() const {
    std::vector<std::string> out;
    for (const auto& text : reading_->scene.sources.all())
        if (!path_.empty()) out.push_back(text->file() == main_file ? path_ : text->name());
    return out;
}

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
        return follow_included();
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

namespace {

/// Is any of the files that a table includes another by now?
bool have_changed(const TableFiles& files, const OpenFile& open) {
    return std::any_of(files.begin(), files.end(), [&](const auto& entry) {
        const TableFile& file = *entry.second;
        const Result<FoundFile> now = open(entry.first, file.source->text().size() + 1);
        return !now || now->path != file.path || now->text != file.source->text();
    });
}

/// A file that was not there may be by now.
bool lacks_file(const Reading& reading) {
    return std::any_of(reading.diagnostics.begin(), reading.diagnostics.end(),
                       [](const Diagnostic& found) { return found.code == entry(Code::unreadable_include).code; });
}

}  // namespace

/// The text as it is, with the files that it includes as they are by now.
DiskState Document::follow_included() {
    const bool changed = have_changed(reading_->files, reading_->open);
    if (!changed && !lacks_file(*reading_)) return DiskState::same;
    Reading reading = read(source().text());
    if (!reading.ok() && reading_->ok()) {
        broken_ = std::make_shared<const Reading>(std::move(reading));
        return DiskState::broken;
    }
    if (!changed && reading.files.size() == reading_->files.size()) return DiskState::same;  // it lacks it still
    const std::shared_ptr<const Reading> before = reading_;
    take(std::move(reading), &before->scene);
    changes_.push_back({true, {}, 0});
    if (!dirty()) disk_ids_ = reading_->scene.all();
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
