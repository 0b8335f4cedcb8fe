// The table's inputs and tests: named, bound, added and taken out.
#include <fmt/format.h>

#include <algorithm>

#include "editor/panels/ui.h"
#include "editor/section_tools.h"
#include "editor/widgets/modal.h"
#include "editor/widgets/widgets.h"
#include "engine/core/at.h"

namespace pinfield::editor {
namespace {

std::string keys_text(const InputBinding& input) { return fmt::format("{}", fmt::join(input.keys, ", ")); }

std::string expected_of(const TableTest& test) {
    std::string out;
    for (const TableTest::Expectation& expectation : test.expectations) out += (out.empty() ? "" : ", ") + expectation.text;
    return fmt::format("{} s: {}", test.run, out);
}

void begin_typing(ListsDialog& dialog, bool tests, bool keys, int row, std::string text) {
    dialog.of_tests = tests;
    dialog.of_keys = keys;
    dialog.row = row;
    dialog.text = std::move(text);
    dialog.why.clear();
    dialog.begins = true;
}

/// What was typed becomes the row's.
void take_typed(AppState& state, ListsDialog& dialog) {
    Document& document = state.document;
    const bool is_new = dialog.row == static_cast<int>(dialog.of_tests ? document.scene().tests.size() : document.scene().inputs.size());
    std::optional<std::string> why;
    if (dialog.of_tests)
        why = is_new ? add_test(document, dialog.text) : rename_test(document, dialog.row, dialog.text);
    else if (dialog.of_keys)
        why = bind_input(document, dialog.row, keys_in(dialog.text));
    else if (!is_new)
        why = rename_input(document, dialog.row, dialog.text);
    else {  // "left Z, LeftShift": the name, then its keys
        std::vector<std::string> words = keys_in(dialog.text);
        const std::string name = words.empty() ? std::string() : words.front();
        if (!words.empty()) words.erase(words.begin());
        why = add_input(document, name, words);
    }
    dialog.why = why.value_or("");
    if (!why) dialog.row = -1;
}

/// A cell that a click makes a field to type in.
void cell(AppState& state, Ui& ui, bool tests, bool keys, int row, const std::string& shown, float width) {
    ListsDialog& dialog = ui.lists;
    const Theme& theme = ui.theme;
    ImGui::PushID(tests * 2 + keys);
    if (dialog.row == row && dialog.of_tests == tests && dialog.of_keys == keys) {
        char buffer[256] = {};
        dialog.text.copy(buffer, sizeof buffer - 1);
        if (std::exchange(dialog.begins, false)) ImGui::SetKeyboardFocusHere();
        ImGui::SetNextItemWidth(width);
        const bool entered =
            ImGui::InputText("##typed", buffer, sizeof buffer, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
        dialog.text = buffer;
        if (entered) take_typed(state, dialog);
    } else {
        const ImVec2 place = ImGui::GetCursorScreenPos(), size{width, ImGui::GetFrameHeight()};
        if (ImGui::InvisibleButton("##cell", size)) begin_typing(dialog, tests, keys, row, shown);
        if (!shown.empty()) tooltip(theme, shown);
        ImDrawList& list = *ImGui::GetWindowDrawList();
        if (ImGui::IsItemHovered()) list.AddRectFilled(place, {place.x + size.x, place.y + size.y}, ink(palette::field_hot), theme.px(4));
        list.AddText({place.x + theme.px(8), place.y + 0.5f * (size.y - ImGui::GetFontSize())}, ink(keys ? palette::quiet : palette::text),
                     fitted(shown.empty() ? "no name" : shown, width - theme.px(16)).c_str());
    }
    ImGui::PopID();
}

bool remove_button(const Theme& theme) {
    ImGui::SameLine(ImGui::GetContentRegionMax().x - theme.px(76));
    return ImGui::Button("Delete", {theme.px(76), 0});
}

void tell_why(ListsDialog& dialog, const std::optional<std::string>& why) {
    dialog.why = why.value_or("");
    dialog.row = -1;
}

void input_rows(AppState& state, Ui& ui) {
    const Theme& theme = ui.theme;
    for (int i = 0; i < static_cast<int>(state.document.scene().inputs.size()); ++i) {
        const InputBinding input = at(state.document.scene().inputs, i);
        ImGui::PushID(i);
        cell(state, ui, false, false, i, input.name, theme.px(150));
        ImGui::SameLine();
        cell(state, ui, false, true, i, keys_text(input), theme.px(230));
        if (remove_button(theme)) tell_why(ui.lists, remove_input(state.document, i));
        ImGui::PopID();
    }
}

void test_rows(AppState& state, Ui& ui) {
    const Theme& theme = ui.theme;
    for (int i = 0; i < static_cast<int>(state.document.scene().tests.size()); ++i) {
        const TableTest test = at(state.document.scene().tests, i);
        ImGui::PushID(1000 + i);
        cell(state, ui, true, false, i, test.name, theme.px(150));
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        text_in(theme.body, palette::quiet, fitted(expected_of(test), theme.px(230)));
        if (remove_button(theme)) tell_why(ui.lists, remove_test(state.document, i));
        ImGui::PopID();
    }
}

/// "New input", or the field in which it is typed.
void new_row(AppState& state, Ui& ui, bool tests, int count, const char* label, const char* hint) {
    ListsDialog& dialog = ui.lists;
    ImGui::PushID(tests ? "new test" : "new input");
    if (dialog.row == count && dialog.of_tests == tests && !dialog.of_keys) {
        cell(state, ui, tests, false, count, {}, ui.theme.px(386));
        text_in(ui.theme.small, palette::quiet, hint);
    } else if (ImGui::Button(label)) {
        begin_typing(dialog, tests, false, count, {});
    }
    ImGui::PopID();
}

}  // namespace

void lists_dialog(AppState& state, Ui& ui) {
    if (!state.show_lists) ui.lists = {};
    if (!state.show_lists && !ImGui::IsPopupOpen("##lists")) return;
    const Theme& theme = ui.theme;
    if (!begin_modal(theme, "##lists", 540)) return;
    text_in(theme.large, palette::text, "Inputs and tests");
    ImGui::BeginChild("##rows", {0, std::min(theme.px(380), 0.7f * ImGui::GetIO().DisplaySize.y)});
    text_in(theme.strong, palette::quiet, "Inputs, and the keys that press them");
    input_rows(state, ui);
    new_row(state, ui, false, static_cast<int>(state.document.scene().inputs.size()), "New input",
            "A name and its keys, such as: left Z, LeftShift");
    ImGui::Dummy({0, theme.px(8)});
    text_in(theme.strong, palette::quiet, "Tests");
    test_rows(state, ui);
    new_row(state, ui, true, static_cast<int>(state.document.scene().tests.size()), "New test",
            "Its name. What it expects is written in the source (F4).");
    ImGui::EndChild();
    if (!ui.lists.why.empty()) text_in(theme.body, palette::amber, fitted(ui.lists.why, ImGui::GetContentRegionAvail().x));
    align_right(theme.px(92));
    const bool typing = ui.lists.row >= 0;
    const bool escape = escape_pressed();
    if (escape && typing) ui.lists.row = -1;
    if (dialog_button(theme, "Close", true) || (escape && !typing)) run(state, "lists.close");
    if (!state.show_lists) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace pinfield::editor
