#include "engine/io/text_patch.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "engine/core/at.h"
#include "engine/io/field_patch.h"
#include "engine/io/same_content.h"
#include "engine/io/structure_patch.h"

namespace pinfield {
namespace {

bool is_changed_by(const Scene& scene, const SetField& edit) {
    const FieldSlot& slot = at(scene.find(edit.node)->fields, edit.field);
    return slot.is_explicit != edit.is_explicit || !identical(slot.value, edit.value);
}

/// Edits that can be written at once: none touches bytes that another touches or stands beside.
class Round {
public:
    explicit Round(const Reading& now) : now_(now) {}

    /// Must the edit wait for the next round, because one before it does that it may build on?
    bool must_wait(const SetField& edit) const {
        const Node* node = now_.scene.find(edit.node);
        const bool renames = node && edit.field >= 0 && edit.field < static_cast<int>(node->fields.size()) &&
                             at(node->type->fields, edit.field).meta.meaning == Meaning::id;
        return (renames && !waiting_.empty()) || std::find(waiting_.begin(), waiting_.end(), edit.node) != waiting_.end();
    }
    void wait(const SetField& edit) { waiting_.push_back(edit.node); }

    /// False when the edit touches what another has taken. Fails with the reason when no text says the edit.
    Result<bool> take(const SetField& edit) {
        if (!is_changed_by(now_.scene, edit)) return true;
        Result<Splice> splice = splice_for(now_, *now_.scene.find(edit.node), edit);
        if (!splice) return tl::unexpected(splice.error());
        const Span here = splice->replaced;
        const bool touches = std::any_of(splices_.begin(), splices_.end(), [&](const Splice& other) {
            return here.begin <= other.replaced.end && other.replaced.begin <= here.end;
        });
        if (!touches) splices_.push_back(std::move(*splice));
        return !touches;
    }

    /// From the last in the text to the first, so that none moves another's place.
    std::vector<TextPatch> patches() const {
        std::vector<TextPatch> out;
        for (const Splice& splice : splices_) out.push_back({now_.source().place(splice.replaced), splice.text});
        std::sort(out.begin(), out.end(),
                  [](const TextPatch& a, const TextPatch& b) { return a.replaced.span.begin > b.replaced.span.begin; });
        return out;
    }

private:
    const Reading& now_;
    std::vector<Splice> splices_;
    std::vector<NodeId> waiting_;
};

std::string patched(std::string text, const std::vector<TextPatch>& patches) {
    for (const TextPatch& patch : patches) text.replace(patch.replaced.span.begin, patch.replaced.span.end - patch.replaced.span.begin, patch.text);
    return text;
}

/// Why the text does not say what it should, or nothing.
std::optional<std::string> refute(const Reading& after, const Scene& expected) {
    for (const Diagnostic& d : after.diagnostics)
        if (d.severity == Severity::error) return d.message;
    if (!same_content(after.scene, expected)) return "the text would change more than this value";
    return {};
}

}  // namespace

std::string apply(const TextPatch& patch, const std::string& text) { return patched(text, {patch}); }

namespace {

/// The text patched so far, with what it must say.
class Patching {
public:
    Patching(const Reading& now, const Limits& limits) : now_(now), limits_(limits), reading_(&now), expected_(now.scene) {}

    /// Fields of many nodes, in as few rounds as they need.
    Result<void> take_fields(std::vector<SetField> left) {
        while (!left.empty()) {
            Round round(*reading_);
            std::vector<SetField> later;
            for (SetField& edit : left) {
                bool taken = !round.must_wait(edit);
                if (taken) {
                    if (const auto why = why_invalid(expected_, edit)) return failure(*why);
                    const Result<bool> free = round.take(edit);
                    if (!free) return tl::unexpected(free.error());
                    taken = *free;
                }
                if (taken) {
                    apply(expected_, edit);
                } else {
                    round.wait(edit);
                    later.push_back(std::move(edit));
                }
            }
            left = std::move(later);
            if (const Result<void> proven = prove(round.patches()); !proven) return proven;
        }
        return {};
    }

    Result<void> take_structure(const Edit& edit) {
        if (const auto why = why_invalid(expected_, edit)) return failure(*why);
        Result<std::vector<TextPatch>> patches = structure_patches(*reading_, edit);
        if (!patches) return tl::unexpected(patches.error());
        apply(expected_, edit);
        return prove(std::move(*patches));
    }

    PatchedText result() && { return {std::move(patches_), latest_ ? std::move(*latest_) : now_, readings_}; }

private:
    /// Reads the text with these patches, which must say what is expected.
    Result<void> prove(std::vector<TextPatch> patches) {
        if (patches.empty()) return {};
        Reading after = read_again(*reading_, patched(reading_->source().text(), patches), limits_);
        ++readings_;
        if (const auto why = refute(after, expected_)) return failure(*why);
        after.scene.take_ids_of(expected_);
        latest_ = std::move(after);
        reading_ = &*latest_;
        patches_.insert(patches_.end(), std::make_move_iterator(patches.begin()), std::make_move_iterator(patches.end()));
        return {};
    }

    const Reading& now_;
    const Limits& limits_;
    const Reading* reading_;
    std::optional<Reading> latest_;
    Scene expected_;
    std::vector<TextPatch> patches_;
    int readings_ = 0;
};

}  // namespace

Result<PatchedText> patch_for(const Reading& now, std::span<const Edit> edits, const Limits& limits) {
    Patching patching(now, limits);
    std::vector<SetField> fields;
    for (const Edit& edit : edits) {
        if (const auto* field = std::get_if<SetField>(&edit)) {
            fields.push_back(*field);
            continue;
        }
        if (const Result<void> taken = patching.take_fields(std::exchange(fields, {})); !taken) return tl::unexpected(taken.error());
        if (const Result<void> taken = patching.take_structure(edit); !taken) return tl::unexpected(taken.error());
    }
    if (const Result<void> taken = patching.take_fields(std::move(fields)); !taken) return tl::unexpected(taken.error());
    return std::move(patching).result();
}

}  // namespace pinfield
