#include "editor/source_draft.h"

#include <utility>

namespace pinfield::editor {
namespace {

const std::shared_ptr<const SourceText>& text_of(const Document& document) { return document.scene().sources.shared_main(); }

}  // namespace

bool SourceDraft::stale(const Document& document) const {
    return text_ && base_ != text_of(document) && base_->text() != document.source().text();
}

/// Typing goes on where it touches what was typed before, nothing else has happened since, and that is not on disk yet.
void SourceDraft::begin(const Document& document, const Splice& splice) {
    base_ = text_of(document);
    goes_on_ = left_ == base_ && splice.removed.begin <= left_place_ && left_place_ <= splice.removed.end && document.can_undo() &&
               !document.can_redo() && document.dirty();
}

void SourceDraft::put(const Document& document, const Splice& splice) {
    std::string after = spliced(text(document)->text(), splice);
    place_ = splice.end();
    rest_ = 0;
    if (!stale(document) && after == document.source().text()) return forget();
    text_ = std::make_shared<const SourceText>(document.source().name(), std::move(after));
    for (Diagnostic& problem : problems_)
        if (problem.where.file == main_file)
            problem.where.span = {carried(problem.where.span.begin, splice), carried(problem.where.span.end, splice)};
    diagnosed_ = Sources(text_);
    waiting_ = true;
}

void SourceDraft::type(Document& document, const Splice& splice) {
    const std::shared_ptr<const SourceText> before = text(document);
    const std::string_view removed = before->slice(splice.removed);
    if (removed == splice.inserted) return;
    document.cancel_preview();
    if (!text_) begin(document, splice);
    typed_.resize(position_);
    const Splice back = inverse(before->text(), splice);
    const auto adds_only = [](const Splice& b) { return b.inserted.empty(); };
    const bool runs_on = waiting_ && !typed_.empty() && adds_only(typed_.back()) && adds_only(back) && typed_.back().removed.end == back.removed.begin;
    if (runs_on) typed_.back().removed.end = back.removed.end;
    else typed_.push_back(back);
    position_ = typed_.size();
    put(document, splice);
}

bool SourceDraft::undo(Document& document) {
    if (!text_ || position_ == 0) return false;
    Splice& step = typed_[--position_];
    put(document, std::exchange(step, inverse(text_->text(), step)));
    return true;
}

bool SourceDraft::redo(Document& document) {
    if (!text_ || position_ == typed_.size()) return false;
    Splice& step = typed_[position_++];
    put(document, std::exchange(step, inverse(text_->text(), step)));
    return true;
}

void SourceDraft::pass(Document& document, double seconds) {
    if (!waiting_) return;
    rest_ += seconds;
    if (rest_ >= pause) read(document);
}

void SourceDraft::read(Document& document) {
    if (!std::exchange(waiting_, false)) return;
    Reading reading = document.read(text_->text());
    problems_ = reading.diagnostics;
    diagnosed_ = reading.scene.sources;
    if (!reading.ok() || stale(document)) return;
    if (document.replace_text(std::move(reading), "Edit source") && goes_on_) document.join_steps();
    left_ = text_of(document);
    left_place_ = place_;
    forget();
}

void SourceDraft::try_again(Document& document) {
    if (!text_) return;
    if (stale(document)) {
        const Splice here = difference(base_->text(), text_->text()), there = difference(base_->text(), document.source().text());
        const bool before = here.removed.end < there.removed.begin, behind = there.removed.end < here.removed.begin;
        if (before || behind) {
            const Splice moved{{carried(here.removed.begin, there), carried(here.removed.end, there)}, here.inserted};
            std::string both = spliced(document.source().text(), moved);
            place_ = carried(place_, difference(text_->text(), both));
            text_ = std::make_shared<const SourceText>(text_->name(), std::move(both));
            typed_.clear();
            position_ = 0;
        }
        base_ = text_of(document);
        goes_on_ = false;
    }
    waiting_ = true;
    read(document);
}

void SourceDraft::restore(Document& document, const std::string& typed) {
    discard();
    type(document, difference(document.source().text(), typed));
    read(document);
}

void SourceDraft::discard() {
    forget();
    left_.reset();
}

void SourceDraft::forget() {
    text_.reset();
    base_.reset();
    problems_.clear();
    diagnosed_ = {};
    waiting_ = false;
    typed_.clear();
    position_ = 0;
}

}  // namespace pinfield::editor
