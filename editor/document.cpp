#include "editor/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/core/at.h"
#include "engine/io/files.h"
#include "engine/io/load_table.h"
#include "engine/io/param_patch.h"
#include "engine/io/same_content.h"
#include "engine/io/shared_patch.h"
#include "engine/io/table_reader.h"
#include "engine/io/text_patch.h"

namespace pinfield::editor {
namespace {

bool same_field(const SetField& a, const SetField& b) { return a.node == b.node && a.field == b.field; }

bool changes(const Scene& scene, const SetField& edit) {
    const FieldSlot& slot = at(scene.find(edit.node)->fields, edit.field);
    return slot.is_explicit != edit.is_explicit || !identical(slot.value, edit.value);
}

/// Fields one by one where there is nothing else, so that the running table can be patched.
std::vector<SceneChange> changes_of(std::span<const Edit> edits) {
    std::vector<SceneChange> out;
    for (const Edit& edit : edits) {
        const auto* field = std::get_if<SetField>(&edit);
        if (!field) return {SceneChange{true, {}, 0}};
        out.push_back({false, field->node, field->field});
    }
    return out;
}

}  // namespace

Document Document::untitled(std::shared_ptr<const Catalog> catalog, std::string_view text) {
    Document document;
    document.catalog_ = std::move(catalog);
    document.disk_text_ = text;  // nobody's work is lost with it
    document.take(document.read(std::string(text)), nullptr);
    document.disk_ids_ = document.scene().all();
    return document;
}

Result<Document> Document::open(const std::string& path, std::shared_ptr<const Catalog> catalog) {
    Result<std::string> text = read_file(path);
    if (!text) return tl::unexpected(text.error());
    Document document;
    document.catalog_ = std::move(catalog);
    document.path_ = path;
    document.disk_text_ = *text;
    document.take(document.read(std::move(*text)), nullptr);
    document.disk_ids_ = document.scene().all();
    return document;
}

bool Document::dirty() const { return is_missing() || source().text() != disk_text_; }

std::shared_ptr<const SourceText> Document::named(std::string text) const {
    return std::make_shared<const SourceText>(path_.empty() ? "untitled" : path_, std::move(text));
}

/// Makes a text the document's own; nodes keep the ids they have in `ids_from`.
void Document::take(Reading reading, const Scene* ids_from) {
    if (ids_from) reading.scene.keep_ids_of(*ids_from);
    reading_ = std::make_shared<const Reading>(std::move(reading));
}

std::optional<std::string> Document::preview(const SetField& edit) {
    if (param_preview_) cancel_preview();
    if (home_preview_ || stands_elsewhere(reading_->scene, edit)) return preview_home(edit);
    if (auto why = why_invalid(scene(), edit)) return why;
    if (!previewed_) previewed_ = std::make_shared<Scene>(reading_->scene);
    apply(*previewed_, edit);
    const auto known =
        std::find_if(preview_.begin(), preview_.end(), [&](const SetField& other) { return same_field(other, edit); });
    if (known != preview_.end()) *known = edit;
    else preview_.push_back(edit);
    changes_.push_back({false, edit.node, edit.field});
    return {};
}

std::optional<std::string> Document::preview_param(const std::string& name, double value) {
    if (!param_preview_) cancel_preview();
    Result<Scene> scene = scene_with_param(*reading_, name, value);
    if (!scene) return scene.error().message;
    show_instead(std::move(*scene));
    param_preview_ = ParamPreview{name, value};
    return {};
}

/// Shows a scene in place of the one that is shown now; the running table follows.
void Document::show_instead(Scene scene) {
    const std::vector<SceneChange> made = changes_between(this->scene(), scene);
    changes_.insert(changes_.end(), made.begin(), made.end());
    previewed_ = std::make_shared<Scene>(std::move(scene));
}

std::optional<std::string> Document::commit_param(const std::string& label) {
    const ParamPreview param = *std::exchange(param_preview_, std::nullopt);
    Result<PatchedText> patched = patch_param(*reading_, param.name, param.value);
    if (!patched) {
        cancel_preview();
        return patched.error().message;
    }
    // The running table follows the preview already; what put() finds between the texts is for undo and redo.
    put(std::move(patched->reading), label, false, true);
    previewed_.reset();
    return {};
}

void Document::cancel_preview() {
    const bool whole = param_preview_ || home_preview_;
    if (previewed_ && whole) show_instead(reading_->scene);
    param_preview_.reset();
    home_preview_.reset();
    previewed_.reset();
    for (const SetField& edit : std::exchange(preview_, {})) changes_.push_back({false, edit.node, edit.field});
}

std::optional<std::string> Document::commit(const std::string& label) {
    if (!previewing()) return {};
    if (param_preview_) return commit_param(label);
    if (home_preview_) {
        put(*std::exchange(home_preview_, std::nullopt), label, false, true);
        previewed_.reset();
        preview_.clear();
        return {};
    }
    std::vector<Edit> edits;
    for (const SetField& edit : preview_)
        if (changes(reading_->scene, edit)) edits.emplace_back(edit);
    std::optional<std::string> why;
    if (!edits.empty()) why = write(edits, label);
    if (why || edits.empty()) {
        cancel_preview();
        return why;
    }
    previewed_.reset();
    preview_.clear();
    return {};
}

std::optional<std::string> Document::edit(const SetField& edit, const std::string& label) {
    cancel_preview();
    if (auto why = preview(edit)) return why;
    return commit(label);
}

std::optional<std::string> Document::edit(std::span<const Edit> edits, const std::string& label) {
    cancel_preview();
    if (edits.empty()) return {};
    const std::size_t before = position_;
    if (auto why = write(edits, label)) return why;
    if (position_ == before) return {};
    const std::vector<SceneChange>& made = history_.back().changes;
    changes_.insert(changes_.end(), made.begin(), made.end());
    return {};
}

/// Makes the text say the edits, as one step; no step where it says so already.
std::optional<std::string> Document::write(std::span<const Edit> edits, const std::string& label) {
    Result<PatchedText> patched = patch_for(*reading_, edits);
    if (!patched) {
        note_shared(edits, label);
        return patched.error().message;
    }
    if (patched->reading.source().text() == source().text()) return {};
    Step step{label, shared_source(), {}, reading_->scene.all(), {}, changes_of(edits)};
    reading_ = std::make_shared<const Reading>(std::move(patched->reading));
    step.source_after = shared_source();
    step.ids_after = reading_->scene.all();
    push(std::move(step));
    return {};
}

/// What was refused is remembered where only sharing stood against it.
void Document::note_shared(std::span<const Edit> edits, const std::string& label) {
    SharedEdit shared{{}, label, {}, 0};
    for (const Edit& edit : edits) {
        const auto* field = std::get_if<SetField>(&edit);
        if (!field) return;
        shared.fields.push_back(*field);
        const auto text = shared_text(*reading_, *field);
        if (!text || shared.places >= text->places) continue;
        shared.anchor = text->anchor;
        shared.places = text->places;
    }
    if (shared.places > 0) shared_edit_ = std::move(shared);
}

std::optional<SharedEdit> Document::take_shared_edit() { return std::exchange(shared_edit_, std::nullopt); }

std::optional<std::string> Document::edit_shared(const SharedEdit& edit, SharedAnswer answer) {
    cancel_preview();
    Reading reading = *reading_;
    for (const SetField& field : edit.fields) {
        if (auto why = why_invalid(reading.scene, field)) return why;
        if (!changes(reading.scene, field)) continue;  // an edit before it has said it everywhere
        const bool shared = shared_text(reading, field).has_value();
        const Edit plain = field;
        Result<PatchedText> patched = !shared ? patch_for(reading, std::span(&plain, 1))
                                      : answer == SharedAnswer::here ? patch_here(reading, field)
                                                                     : patch_everywhere(reading, field);
        if (!patched) return patched.error().message;
        reading = std::move(patched->reading);
    }
    put(std::move(reading), edit.label, false, true);
    return {};
}

std::size_t Document::unsaved_steps() const {
    if (source().text() == disk_text_) return 0;
    return lost_steps_ + std::max(position_, saved_position_) - std::min(position_, saved_position_);
}

/// The text is now the disk's.
void Document::agree_with_disk() {
    disk_text_ = source().text();
    disk_ids_ = reading_->scene.all();
    disk_merge_.reset();
    looks_without_file_ = 0;
    broken_.reset();
    saved_position_ = position_;
    lost_steps_ = 0;
}

void Document::push(Step step) {
    if (step.source_before->text() == disk_text_) {
        saved_position_ = position_;
        lost_steps_ = 0;
    } else if (saved_position_ > position_) {
        lost_steps_ += saved_position_ - position_;
        saved_position_ = position_;
    }
    history_.erase(history_.begin() + static_cast<std::ptrdiff_t>(position_), history_.end());
    history_.push_back(std::move(step));
    position_ = history_.size();
}

void Document::join_steps() {
    if (position_ < 2 || position_ != history_.size()) return;
    Step second = std::move(history_.back());
    history_.pop_back();
    position_ = history_.size();
    Step& first = history_.back();
    first.source_after = std::move(second.source_after);
    first.ids_after = std::move(second.ids_after);
    first.changes.insert(first.changes.end(), second.changes.begin(), second.changes.end());
    if (saved_position_ == position_) ++lost_steps_;  // what lay between both can no longer be gone to
    if (first.source_after->text() == first.source_before->text()) history_.pop_back();
    position_ = history_.size();
    saved_position_ = std::min(saved_position_, position_);
}

/// Goes to a neighbouring state of the history.
void Document::replay(const Step& step, const std::shared_ptr<const SourceText>& source, const std::vector<NodeId>& ids) {
    Reading reading = read_again(*reading_, source);
    const bool same_nodes = reading.scene.all().size() == ids.size();  // not so where a file that it includes has changed since
    if (same_nodes) reading.scene.take_ids(ids, reading_->scene);
    else reading.scene.keep_ids_of(reading_->scene);
    reading_ = std::make_shared<const Reading>(std::move(reading));
    if (!same_nodes) changes_.push_back({true, {}, 0});
    changes_.insert(changes_.end(), step.changes.begin(), step.changes.end());
}

void Document::undo() {
    if (previewing()) return cancel_preview();
    if (!can_undo()) return;
    const Step& step = history_[--position_];
    replay(step, step.source_before, step.ids_before);
}

void Document::redo() {
    if (previewing()) return cancel_preview();
    if (!can_redo()) return;
    const Step& step = history_[position_++];
    replay(step, step.source_after, step.ids_after);
}

std::optional<std::size_t> Document::saved_after() const {
    if (lost_steps_ > 0 || is_missing()) return {};
    return saved_position_;
}

void Document::go_to(std::size_t done) {
    cancel_preview();
    while (position_ > done) undo();
    while (position_ < std::min(done, history_.size())) redo();
}

const std::string* Document::undo_label() const { return can_undo() ? &history_[position_ - 1].label : nullptr; }
const std::string* Document::redo_label() const { return can_redo() ? &history_[position_].label : nullptr; }

Result<void> Document::save() {
    if (path_.empty()) return failure("the table has no file yet");
    const std::optional<std::string> expected = is_missing() ? std::nullopt : std::optional(disk_text_);
    if (const Result<bool> saved = save_file(path_, source().text(), expected); !saved) return tl::unexpected(saved.error());
    agree_with_disk();
    return {};
}

Result<void> Document::save_as(const std::string& path) {
    std::optional<std::string> there;
    if (Result<std::string> text = read_file(path)) there = std::move(*text);
    if (const Result<bool> saved = save_file(path, source().text(), there); !saved) return tl::unexpected(saved.error());
    path_ = path;
    const Scene ids_from = reading_->scene;
    take(read(source().text()), &ids_from);  // its places name the new file, and what it includes stands beside that
    agree_with_disk();
    return {};
}

void Document::restore(std::string text, std::size_t steps) {
    cancel_preview();
    if (text == source().text()) return;
    put(read(std::move(text)), "Restore unsaved work", true);
    if (steps > 1) lost_steps_ += steps - 1;
}

Reading Document::read(std::string text) const {
    return read_table(named(std::move(text)), catalog_, {}, path_.empty() ? OpenFile() : files_beside(path_));
}

bool Document::replace_text(Reading reading, const std::string& label) {
    assert(reading.ok() && "only a text that reads replaces another");
    cancel_preview();
    if (reading.source().text() == source().text()) return false;
    put(std::move(reading), label, false);
    return true;
}

/// Another text as one step; none where it is the same. `whole`: the running table is made anew, even where only fields differ. `has_ids`:
/// its nodes have those that they are to have.
void Document::put(Reading reading, const std::string& label, bool whole, bool has_ids) {
    if (reading.source().text() == source().text()) return;
    Step step{label, shared_source(), reading.scene.sources.shared_main(), reading_->scene.all(), {}, {}};
    const std::shared_ptr<const Reading> before = reading_;
    take(std::move(reading), has_ids ? nullptr : &before->scene);
    step.ids_after = reading_->scene.all();
    step.changes = whole ? std::vector{SceneChange{true, {}, 0}} : changes_between(before->scene, reading_->scene);
    changes_.insert(changes_.end(), step.changes.begin(), step.changes.end());
    push(std::move(step));
}

std::vector<SceneChange> Document::take_changes() { return std::exchange(changes_, {}); }

}  // namespace pinfield::editor
