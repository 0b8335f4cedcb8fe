#include "editor/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <utility>

#include "editor/starter_table.h"
#include "engine/core/at.h"
#include "engine/io/files.h"
#include "engine/io/table_reader.h"
#include "engine/io/text_patch.h"

namespace pinfield::editor {
namespace {

bool same_field(const Edit& a, const Edit& b) { return a.node == b.node && a.field == b.field; }

bool changes(const Scene& scene, const Edit& edit) {
    const FieldSlot& slot = at(scene.find(edit.node)->fields, edit.field);
    return slot.is_explicit != edit.is_explicit || !identical(slot.value, edit.value);
}

}  // namespace

Document Document::untitled(std::shared_ptr<const Catalog> catalog) {
    Document document;
    document.catalog_ = std::move(catalog);
    document.disk_text_ = starter_table;  // nobody's work is lost with it
    document.take_text(document.named(std::string(starter_table)), nullptr);
    return document;
}

Result<Document> Document::open(const std::string& path, std::shared_ptr<const Catalog> catalog) {
    Result<std::string> text = read_file(path);
    if (!text) return tl::unexpected(text.error());
    Document document;
    document.catalog_ = std::move(catalog);
    document.path_ = path;
    document.disk_text_ = *text;
    document.take_text(document.named(std::move(*text)), nullptr);
    return document;
}

bool Document::dirty() const { return is_missing() || source_->text() != disk_text_; }

std::shared_ptr<const SourceText> Document::named(std::string text) const {
    return std::make_shared<const SourceText>(path_.empty() ? "untitled" : path_, std::move(text));
}

/// Makes a text the document's own; nodes keep the ids they have in `ids_from`.
void Document::take_text(std::shared_ptr<const SourceText> source, const Scene* ids_from) {
    ReadResult reading = read_table(source, catalog_);
    if (ids_from) reading.scene.keep_ids_of(*ids_from);
    source_ = std::move(source);
    scene_ = std::make_shared<Scene>(std::move(reading.scene));
    diagnostics_ = std::move(reading.diagnostics);
}

std::optional<std::string> Document::preview(const Edit& edit) {
    if (auto why = why_invalid(*scene_, edit)) return why;
    if (!previewing()) before_preview_ = std::make_shared<Scene>(*scene_);
    apply(*scene_, edit);
    const auto known =
        std::find_if(preview_.begin(), preview_.end(), [&](const Edit& other) { return same_field(other, edit); });
    if (known != preview_.end()) *known = edit;
    else preview_.push_back(edit);
    changes_.push_back({false, edit.node, edit.field});
    return {};
}

void Document::cancel_preview() {
    if (!previewing()) return;
    scene_ = std::exchange(before_preview_, nullptr);
    for (const Edit& edit : std::exchange(preview_, {})) changes_.push_back({false, edit.node, edit.field});
}

std::optional<std::string> Document::commit(const std::string& label) {
    if (!previewing()) return {};
    Step step{label, {}, {}, source_, source_, {}, {}};
    Scene scene = *before_preview_;
    for (const Edit& edit : preview_) {
        if (!changes(scene, edit)) continue;
        if (auto why = write(edit, scene, step)) {
            cancel_preview();
            return why;
        }
    }
    if (step.forward.empty()) {
        cancel_preview();
        return {};
    }
    assert(scene.same_content(*scene_) && "patch_for() hands out patches that read back as the edit");
    source_ = step.source_after;
    scene_ = std::make_shared<Scene>(std::move(scene));
    preview_.clear();
    before_preview_.reset();
    push(std::move(step));
    return {};
}

/// Adds one edit to a step: its patch to the text and, read back from that, its outcome to the scene.
std::optional<std::string> Document::write(const Edit& edit, Scene& scene, Step& step) const {
    if (auto why = why_invalid(scene, edit)) return why;
    const Result<TextPatch> patch = patch_for(*step.source_after, scene, edit);
    if (!patch) return patch.error().message;
    step.source_after = named(apply(*patch, step.source_after->text()));
    step.forward.push_back(edit);
    step.backward.insert(step.backward.begin(), apply(scene, edit));
    ReadResult reading = read_table(step.source_after, catalog_);  // the next patch needs the new places
    reading.scene.keep_ids_of(scene);
    scene = std::move(reading.scene);
    return {};
}

std::optional<std::string> Document::edit(const Edit& edit, const std::string& label) {
    cancel_preview();
    if (auto why = preview(edit)) return why;
    return commit(label);
}

void Document::push(Step step) {
    history_.erase(history_.begin() + static_cast<std::ptrdiff_t>(position_), history_.end());
    history_.push_back(std::move(step));
    position_ = history_.size();
}

/// Goes to a neighbouring state of the history. `replaced_by`: the scene there, for a step that replaced the whole text.
void Document::replay(const std::vector<Edit>& edits, std::shared_ptr<const SourceText> source, const Scene* replaced_by) {
    if (replaced_by) {
        take_text(std::move(source), replaced_by);
        changes_.push_back({true, {}, 0});
        return;
    }
    for (const Edit& edit : edits) {
        apply(*scene_, edit);
        changes_.push_back({false, edit.node, edit.field});
    }
    const std::shared_ptr<Scene> ids_from = scene_;  // outlives its replacement
    take_text(std::move(source), ids_from.get());
}

void Document::undo() {
    if (previewing()) return cancel_preview();
    if (!can_undo()) return;
    const Step& step = history_[--position_];
    replay(step.backward, step.source_before, step.scene_before.get());
}

void Document::redo() {
    if (previewing()) return cancel_preview();
    if (!can_redo()) return;
    const Step& step = history_[position_++];
    replay(step.forward, step.source_after, step.scene_after.get());
}

const std::string* Document::undo_label() const { return can_undo() ? &history_[position_ - 1].label : nullptr; }
const std::string* Document::redo_label() const { return can_redo() ? &history_[position_].label : nullptr; }

Result<void> Document::save() {
    if (path_.empty()) return failure("the table has no file yet");
    const std::optional<std::string> expected = is_missing() ? std::nullopt : std::optional(disk_text_);
    if (const Result<bool> saved = save_file(path_, source_->text(), expected); !saved) return tl::unexpected(saved.error());
    disk_text_ = source_->text();
    looks_in_vain_ = 0;
    broken_.reset();
    return {};
}

Result<void> Document::save_as(const std::string& path) {
    std::optional<std::string> there;
    if (Result<std::string> text = read_file(path)) there = std::move(*text);
    if (const Result<bool> saved = save_file(path, source_->text(), there); !saved) return tl::unexpected(saved.error());
    path_ = path;
    disk_text_ = source_->text();
    looks_in_vain_ = 0;
    source_ = named(disk_text_);
    broken_.reset();
    return {};
}

DiskState Document::check_disk() {
    // A drag in progress goes first: it ends in a text, which is then compared.
    if (path_.empty() || previewing()) return DiskState::same;
    Result<std::string> text = read_file(path_);
    if (!text) {
        std::error_code error;
        if (std::filesystem::exists(path_, error)) return DiskState::same;  // there, only not to be read
        ++looks_in_vain_;                                                   // programs that replace a file take it away for a moment
        return is_missing() ? DiskState::missing : DiskState::same;
    }
    looks_in_vain_ = 0;
    if (*text == disk_text_) {
        broken_.reset();
        return DiskState::same;
    }
    if (dirty()) return *text == source_->text() ? (disk_text_ = *text, DiskState::same) : DiskState::conflict;
    if (broken_ && broken_->text() == *text) return DiskState::broken;
    const auto source = named(std::move(*text));
    ReadResult reading = read_table(source, catalog_);
    if (has_errors(reading.diagnostics)) {
        broken_ = source;
        broken_diagnostics_ = std::move(reading.diagnostics);
        return DiskState::broken;
    }
    follow_disk(source);
    return DiskState::reloaded;
}

Result<void> Document::reload() {
    if (path_.empty()) return failure("the table has no file yet");
    cancel_preview();
    Result<std::string> text = read_file(path_);
    if (!text) return tl::unexpected(text.error());
    const auto source = named(std::move(*text));
    const ReadResult reading = read_table(source, catalog_);
    if (has_errors(reading.diagnostics)) return failure(format(reading.diagnostics.front(), *source));
    follow_disk(source);
    return {};
}

/// Takes a sound text from the disk as a step of its own, so that undo gives the earlier text back.
void Document::follow_disk(std::shared_ptr<const SourceText> source) {
    disk_text_ = source->text();
    looks_in_vain_ = 0;
    broken_.reset();
    if (disk_text_ == source_->text()) return;
    Step step{"Reload", {}, {}, source_, source, std::make_shared<const Scene>(*scene_), {}};
    take_text(std::move(source), step.scene_before.get());
    step.scene_after = std::make_shared<const Scene>(*scene_);
    push(std::move(step));
    changes_.push_back({true, {}, 0});
}

std::vector<SceneChange> Document::take_changes() { return std::exchange(changes_, {}); }

}  // namespace pinfield::editor
