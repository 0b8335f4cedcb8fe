// Fields whose values stand elsewhere in the text: in a template, at a copied item, in a param.
#include <algorithm>

#include "editor/document.h"
#include "engine/core/at.h"
#include "engine/io/text_patch.h"

namespace pinfield::editor {
namespace {

bool same_field(const SetField& a, const SetField& b) { return a.node == b.node && a.field == b.field; }

/// Is it the place that an answer chose? Where it stands for other values as well, and nothing is flattened by going there again.
bool is_kept(const ValueHome& home) {
    const bool replaces_expression = home.told.find("in place of") != std::string::npos;
    return home.kind != ValueHome::Kind::own && !replaces_expression;
}

}  // namespace

std::optional<std::string> Document::why_not(const SetField& edit) const {
    if (!stands_elsewhere(reading_->scene, edit)) return why_invalid(scene(), edit);
    const FieldType& field = at(reading_->scene.find(edit.node)->type->fields, edit.field);
    if (auto why = why_invalid(field, edit.value)) return std::string(field.key) + " " + *why;
    return {};
}

/// The last one that was chosen of those that there are.
std::optional<ValueHome> Document::known_home(const std::vector<ValueHome>& homes) const {
    for (auto chosen = homes_.rbegin(); chosen != homes_.rend(); ++chosen)
        for (const ValueHome& home : homes)
            if (home.kind == chosen->kind && home.told == chosen->told) return home;
    return {};
}

/// What the text is with all that is previewed, each where it belongs.
Result<Reading> Document::with_previews(const std::vector<SetField>& edits) const {
    Reading reading = *reading_;
    for (const SetField& edit : edits) {
        const FieldSlot& slot = at(reading.scene.find(edit.node)->fields, edit.field);
        if (slot.is_explicit == edit.is_explicit && identical(slot.value, edit.value)) continue;
        const Edit plain = edit;
        const std::optional<ValueHome> home = known_home(homes_of(reading, edit));
        Result<PatchedText> patched = home ? patch_home(reading, edit, *home) : patch_for(reading, std::span(&plain, 1));
        if (!patched) return tl::unexpected(patched.error());
        reading = std::move(patched->reading);
    }
    return reading;
}

std::optional<std::string> Document::preview_home(const SetField& edit) {
    if (auto why = why_not(edit)) return why;
    if (stands_elsewhere(reading_->scene, edit)) {
        std::vector<ValueHome> homes = homes_of(*reading_, edit);
        if (!homes.empty() && !known_home(homes)) {
            home_question_ = HomeQuestion{edit, std::move(homes)};
            return why_invalid(reading_->scene, edit);
        }
    }
    std::vector<SetField> edits = preview_;
    const auto known = std::find_if(edits.begin(), edits.end(), [&](const SetField& other) { return same_field(other, edit); });
    if (known != edits.end()) *known = edit;
    else edits.push_back(edit);
    Result<Reading> reading = with_previews(edits);
    if (!reading) return reading.error().message;
    show_instead(reading->scene);
    home_preview_ = std::move(*reading);
    preview_ = std::move(edits);
    return {};
}

std::optional<HomeQuestion> Document::take_home_question() { return std::exchange(home_question_, std::nullopt); }

std::optional<std::string> Document::edit_home(const SetField& edit, const ValueHome& home, const std::string& label) {
    cancel_preview();
    Result<PatchedText> patched = patch_home(*reading_, edit, home);
    if (!patched) return patched.error().message;
    if (is_kept(home)) homes_.push_back(home);
    put(std::move(patched->reading), label, false, true);
    return {};
}

std::optional<std::string> Document::take_patched(Result<PatchedText> patched, const std::string& label) {
    cancel_preview();
    if (!patched) return patched.error().message;
    put(std::move(patched->reading), label, false, true);
    return {};
}

}  // namespace pinfield::editor
