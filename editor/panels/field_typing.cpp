#include "editor/edit_tools.h"
#include "editor/panels/field_row.h"
#include "editor/panels/fields.h"
#include "editor/typed_number.h"

namespace pinfield::editor {
namespace {

void finish_typing(const Row& row) {
    Typing& typing = row.ui.typing;
    if (row.field().meta.meaning == Meaning::id) {
        take(row.state, rename_node(row.state.document, row.node.id, typing.text));
    } else if (typing.component < 0) {
        row.change(set_all_from_text, typing.text);
    } else {
        // What is typed means the unit that is shown. Only lengths are shown in another than a bare number has.
        const Unit unit = row.field().meta.unit;
        const bool in_mm = shown(component(row.value(), typing.component), unit).unit == "mm";
        const Result<double> value = typed_number(typing.text, unit, in_mm ? "mm" : "");
        if (value) row.change(set_component_of_all, typing.component, *value);
        else tell(row.state, value.error().message);
    }
    typing = {};
}

}  // namespace

void begin_typing(const Row& row, int component) {
    Typing& typing = row.ui.typing;
    typing = {row.node.id, row.index(), component, {}, {}, true};
    if (row.mixed(component)) return;
    if (component < 0) typing.text = text_of(row.state.document, row.node.id, row.index());
    else typing.text = shown(editor::component(row.value(), component), row.field().meta.unit).number;
    typing.before = typing.text;
}

void tab_stop(const Row& row, int component) {
    const TabStop here{row.node.id, row.index(), component};
    row.ui.tab_stops.push_back(here);
    if (row.ui.types_at == here) begin_typing(row, component);
}

void typing_field(const Row& row, float width) {
    Typing& typing = row.ui.typing;
    char buffer[512] = {};
    typing.text.copy(buffer, sizeof buffer - 1);
    ImGui::SetNextItemWidth(width);
    if (typing.begins) ImGui::SetKeyboardFocusHere();
    const bool entered =
        ImGui::InputText("##type", buffer, sizeof buffer, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    typing.text = buffer;
    if (typing.begins && !ImGui::IsItemVisible()) ImGui::SetScrollHereY(0.5f);
    const bool tab = !typing.begins && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Tab), false);
    if (tab) {
        row.ui.tabbed_from = TabStop{typing.node, typing.field, typing.component};
        row.ui.tabs_back = ImGui::GetIO().KeyShift;
    }
    if (entered || (tab && typing.text != typing.before)) finish_typing(row);
    else if (tab) typing = {};
    else if (!typing.begins && ImGui::IsItemDeactivated()) {
        // Clicking elsewhere takes what was typed, Escape drops it.
        const bool escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
        if (!escaped && ImGui::IsItemDeactivatedAfterEdit()) finish_typing(row);
        else typing = {};
    }
    typing.begins = false;
}

}  // namespace pinfield::editor
