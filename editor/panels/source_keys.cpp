#include <utility>

#include "editor/panels/source_lines.h"

namespace pinfield::editor {
namespace {

bool pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); }

std::string utf8(unsigned c) {
    const auto tail = [&](int shift) { return static_cast<char>(0x80u | (c >> shift & 0x3fu)); };
    if (c < 0x80) return {static_cast<char>(c)};
    if (c < 0x800) return {static_cast<char>(0xc0u | c >> 6), tail(0)};
    if (c < 0x10000) return {static_cast<char>(0xe0u | c >> 12), tail(6), tail(0)};
    return {static_cast<char>(0xf0u | c >> 18), tail(12), tail(6), tail(0)};
}

/// Characters typed since the last frame, but for those that are no text.
std::string typed_characters() {
    const ImGuiIO& io = ImGui::GetIO();
    std::string out;
    if (io.KeyCtrl && !io.KeyAlt) return out;  // both together are how some keyboards write brackets
    for (const ImWchar c : io.InputQueueCharacters)
        if (c >= 0x20 && c != 0x7f) out += utf8(c);
    return out;
}

class Keys {
public:
    Keys(AppState& state, SourcePanel& panel, int page) : state_(state), panel_(panel), page_(page) {}

    void run() {
        if (const std::string characters = typed_characters(); !characters.empty()) put(typed(text(), panel_.cursor, characters));
        move();
        erase();
        if (pressed(ImGuiKey_Enter)) put(new_line(text(), panel_.cursor));
        if (pressed(ImGuiKey_Tab)) indent();
        if (ImGui::GetIO().KeyCtrl) chord();
        if (pressed(ImGuiKey_Escape)) panel_.focused = false;
    }

private:
    const std::string& text() const { return panel_.shown->text(); }

    void put(const Splice& splice) {
        state_.source.type(state_.document, splice);
        arrive(cursor_at(splice.end()));
    }
    /// The text has changed under the cursor's own hand.
    void arrive(const TextCursor& cursor) {
        follow_text(state_, panel_);
        panel_.cursor = cursor;
        panel_.reveals_caret = panel_.hand_on_keys = true;
    }

    void move() {
        const bool control = ImGui::GetIO().KeyCtrl;
        const std::pair<ImGuiKey, Motion> motions[] = {
            {ImGuiKey_LeftArrow, control ? Motion::word_left : Motion::left},
            {ImGuiKey_RightArrow, control ? Motion::word_right : Motion::right},
            {ImGuiKey_UpArrow, Motion::up},
            {ImGuiKey_DownArrow, Motion::down},
            {ImGuiKey_PageUp, Motion::page_up},
            {ImGuiKey_PageDown, Motion::page_down},
            {ImGuiKey_Home, control ? Motion::text_start : Motion::line_start},
            {ImGuiKey_End, control ? Motion::text_end : Motion::line_end}};
        for (const auto& [key, motion] : motions) {
            if (!pressed(key)) continue;
            panel_.cursor = moved(text(), panel_.cursor, motion, ImGui::GetIO().KeyShift, page_);
            panel_.reveals_caret = true;
        }
    }

    void erase() {
        const bool control = ImGui::GetIO().KeyCtrl;
        if (pressed(ImGuiKey_Backspace)) put(erased(text(), panel_.cursor, control ? Motion::word_left : Motion::left));
        if (pressed(ImGuiKey_Delete)) put(erased(text(), panel_.cursor, control ? Motion::word_right : Motion::right));
    }

    void indent() {
        const bool outwards = ImGui::GetIO().KeyShift, lines = outwards || panel_.cursor.selects();
        const Splice splice = indented(text(), panel_.cursor, outwards);
        const TextCursor before = panel_.cursor;
        put(splice);
        if (!lines) return;
        if (before.selects()) panel_.cursor = {splice.end(), splice.removed.begin};
        else panel_.cursor = cursor_at(snapped(text(), std::max(splice.removed.begin, before.caret + splice.end() - splice.removed.end)));
    }

    void chord() {
        const Span selected = panel_.cursor.selected();
        if (pressed(ImGuiKey_A)) panel_.cursor = {text().size(), moved(text(), {}, Motion::text_start, false).caret};
        if ((pressed(ImGuiKey_C) || pressed(ImGuiKey_X)) && panel_.cursor.selects())
            ImGui::SetClipboardText(std::string(panel_.shown->slice(selected)).c_str());
        if (pressed(ImGuiKey_X) && panel_.cursor.selects()) put({selected, {}});
        const char* clipboard = pressed(ImGuiKey_V) ? ImGui::GetClipboardText() : nullptr;
        if (clipboard) put(typed(text(), panel_.cursor, clipboard));
        const bool back = pressed(ImGuiKey_Z) && !ImGui::GetIO().KeyShift;
        if (back || pressed(ImGuiKey_Z) || pressed(ImGuiKey_Y)) step(back);
    }

    /// First through what does not read yet, then through the table's history.
    void step(bool back) {
        SourceDraft& draft = state_.source;
        if (draft.pending()) {
            if (back ? draft.undo(state_.document) : draft.redo(state_.document)) arrive(cursor_at(draft.place()));
            return;
        }
        const std::string_view action = back ? "edit.undo" : "edit.redo";
        if (!enabled(state_, action)) return;
        editor::run(state_, action);
        follow_text(state_, panel_);
        panel_.reveals_caret = true;
    }

    AppState& state_;
    SourcePanel& panel_;
    int page_;
};

}  // namespace

void source_keys(AppState& state, Ui& ui, int page) { Keys(state, ui.source, page).run(); }

void follow_text(const AppState& state, SourcePanel& panel) {
    const std::shared_ptr<const SourceText>& text = state.source.text(state.document);
    const std::string& saved = state.document.saved_text();
    const bool compare = state.preferences.show_changes && (panel.shown != text || !panel.changes || panel.compared_with != saved);
    if (panel.shown != text) {
        const Splice change = panel.shown ? difference(panel.shown->text(), text->text()) : Splice{};
        const auto place = [&](std::size_t offset) { return snapped(text->text(), carried(offset, change)); };
        panel.cursor = {place(panel.cursor.caret), place(panel.cursor.anchor)};
        panel.shown = text;
        panel.tokens = highlight_yaml(text->text());
        panel.widest = 0;
        for (int line = 1; line <= text->line_count(); ++line)
            panel.widest = std::max(panel.widest, static_cast<int>(text->line(line).size()));
    }
    if (compare) {
        panel.changes = line_marks(saved, text->text());
        panel.compared_with = saved;
    } else if (!state.preferences.show_changes) {
        panel.changes.reset();
    }
    panel.typed = state.source.pending() ? difference(state.document.source().text(), text->text()) : Splice{};
}

}  // namespace pinfield::editor
