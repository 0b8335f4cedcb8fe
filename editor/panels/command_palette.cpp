// Everything that can be done or gone to, a few letters away.
#include <algorithm>
#include <optional>
#include <utility>

#include "editor/panels/ui.h"
#include "editor/widgets/widgets.h"
#include "engine/core/at.h"

namespace pinfield::editor {
namespace {

constexpr const char* popup = "##command_palette";
constexpr int rows_seen = 12;

bool pressed(ImGuiKey key, bool repeats = true) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), repeats); }

void search(CommandPalette& palette) {
    palette.found = find_commands(palette.commands, palette.query);
    palette.chosen = 0;
    palette.reveals_chosen = true;
}

std::string typed_letters() {
    std::string out;
    for (const ImWchar c : ImGui::GetIO().InputQueueCharacters)
        if (c >= 0x20 && c < 0x7f) out += static_cast<char>(c);
    return out;
}

/// In the frame that gives a field the keyboard, Dear ImGui puts the cursor before its text and drops what is typed.
int begin_behind_text(ImGuiInputTextCallbackData* data) {
    CommandPalette& palette = *static_cast<CommandPalette*>(data->UserData);
    if (!std::exchange(palette.cursor_waits, false)) return 0;
    data->InsertChars(data->BufTextLen, palette.early.c_str());
    data->CursorPos = data->SelectionStart = data->SelectionEnd = data->BufTextLen;
    return 0;
}

/// True when Enter was pressed. What is typed before the field has the keyboard, a frame or two after it was asked for, counts as well.
bool query_field(const Theme& theme, CommandPalette& palette) {
    const ImVec2 place = ImGui::GetCursorScreenPos();
    ImGui::SetNextItemWidth(-1);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(theme.px(32), theme.px(7)));
    const bool lost = palette.has_keyboard && !ImGui::IsAnyItemActive();  // to the scroll bar
    if (std::exchange(palette.begins, false) || lost) {
        ImGui::SetKeyboardFocusHere();
        palette.cursor_waits = true;
    }
    palette.early = palette.has_keyboard ? "" : typed_letters();
    char buffer[128] = {};
    palette.query.copy(buffer, sizeof buffer - 1);
    const bool entered = ImGui::InputTextWithHint("##query", "A command or a node", buffer, sizeof buffer,
                                                  ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackAlways, begin_behind_text, &palette);
    ImGui::PopStyleVar();
    draw_icon(*ImGui::GetWindowDrawList(), Icon::search, {place.x + theme.px(17), place.y + 0.5f * ImGui::GetItemRectSize().y}, theme.px(14),
              ink(palette::quiet));
    std::string query = buffer;
    palette.has_keyboard = ImGui::IsItemActive();
    if (!palette.has_keyboard && !entered) query += palette.early;
    if (palette.query != query) {
        palette.query = query;
        search(palette);
    }
    return entered;
}

void step(CommandPalette& palette) {
    const int count = static_cast<int>(palette.found.size());
    if (count == 0) return;
    const int by = (pressed(ImGuiKey_DownArrow) ? 1 : 0) - (pressed(ImGuiKey_UpArrow) ? 1 : 0);
    const int pages = (pressed(ImGuiKey_PageDown) ? 1 : 0) - (pressed(ImGuiKey_PageUp) ? 1 : 0);
    if (by == 0 && pages == 0) return;
    int at = static_cast<int>(palette.chosen);
    if (by != 0) at = (at + by + count) % count;
    at = std::clamp(at + pages * (rows_seen - 1), 0, count - 1);
    palette.chosen = static_cast<std::size_t>(at);
    palette.reveals_chosen = true;
}

/// The text with the letters that were found in the accent's color; where it ends.
float lit_text(ImDrawList& list, ImVec2 place, std::string_view text, const std::vector<std::size_t>& lit, const Tint& color, float right) {
    const std::string shown = fitted(text, right - place.x);
    for (std::size_t i = 0; i < shown.size();) {
        std::size_t n = 1;
        while (i + n < shown.size() && (static_cast<unsigned char>(shown[i + n]) & 0xc0u) == 0x80u) ++n;
        const bool found = std::find(lit.begin(), lit.end(), i) != lit.end();
        list.AddText(place, ink(found ? palette::accent : color), shown.data() + i, shown.data() + i + n);
        place.x += ImGui::CalcTextSize(shown.data() + i, shown.data() + i + n).x;
        i += n;
    }
    return place.x;
}

/// Whether it was clicked.
bool row(const AppState& state, const Theme& theme, CommandPalette& palette, std::size_t index) {
    const FoundCommand& found = palette.found[index];
    const Command& command = palette.commands[found.index];
    const ImVec2 place = ImGui::GetCursorScreenPos(), size{ImGui::GetContentRegionAvail().x, theme.px(28)};
    ImGui::PushID(static_cast<int>(index));
    const bool clicked = ImGui::InvisibleButton("row", size);
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    if (ImGui::IsItemHovered() && (moved.x != 0 || moved.y != 0)) palette.chosen = index;
    ImGui::PopID();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool can = enabled(state, command);
    if (palette.chosen == index) list.AddRectFilled(place, {place.x + size.x, place.y + size.y}, ink(palette::accent_deep), theme.px(4));
    const Node* node = state.document.scene().find(command.node);
    const NodeType* type = node ? node->type : command.type;
    if (type) draw_icon(list, icon_of(*type), {place.x + theme.px(16), place.y + 0.5f * size.y}, theme.px(14), ink(color_of(*type)));
    const float y = place.y + 0.5f * (size.y - ImGui::GetFontSize()), small_y = place.y + 0.5f * (size.y - theme.small->FontSize);
    float right = place.x + size.x - theme.px(10);
    const std::string shortcut(type ? "" : find_action(command.action)->shortcut);
    if (!shortcut.empty()) {
        right -= ImGui::CalcTextSize(shortcut.c_str()).x;
        list.AddText({right, y}, ink(can ? palette::quiet : palette::faint), shortcut.c_str());
        right -= theme.px(12);
    }
    const float left = place.x + theme.px(32);
    const float end = lit_text(list, {left, y}, command.title, can ? found.places : std::vector<std::size_t>{}, can ? palette::text : palette::faint, right);
    const float after = end + theme.px(10);
    if (right - after > theme.px(40)) {
        ImGui::PushFont(theme.small);
        list.AddText({after, small_y}, ink(can ? palette::quiet : palette::faint), fitted(command.detail, right - after).c_str());
        ImGui::PopFont();
    }
    return clicked;
}

/// The row that was clicked.
std::optional<std::size_t> rows(const AppState& state, const Theme& theme, CommandPalette& palette) {
    const float height = theme.px(28);
    const auto count = static_cast<int>(palette.found.size());
    const float most = std::min(rows_seen * height, 0.7f * ImGui::GetIO().DisplaySize.y);
    std::optional<std::size_t> clicked;
    if (count == 0) text_in(theme.body, palette::quiet, "  Nothing goes by that name.");
    ImGui::BeginChild("##rows", {0, std::min(most, static_cast<float>(std::max(count, 1)) * height)}, false, ImGuiWindowFlags_NoNav);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    if (std::exchange(palette.reveals_chosen, false)) {
        const float top = static_cast<float>(palette.chosen) * height, seen = ImGui::GetWindowSize().y;
        if (top < ImGui::GetScrollY()) ImGui::SetScrollY(top);
        if (top + height > ImGui::GetScrollY() + seen) ImGui::SetScrollY(top + height - seen);
    }
    ImGuiListClipper clipper;
    clipper.Begin(count, height);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            if (row(state, theme, palette, static_cast<std::size_t>(i))) clicked = static_cast<std::size_t>(i);
    clipper.End();
    ImGui::PopStyleVar();
    ImGui::EndChild();
    return clicked;
}

void begin(const AppState& state, CommandPalette& palette) {
    palette = {};
    palette.open = palette.begins = true;
    palette.commands = all_commands(state);
    search(palette);
    ImGui::OpenPopup(popup);
}

}  // namespace

void command_palette(AppState& state, Ui& ui) {
    CommandPalette& palette = ui.commands;
    const Theme& theme = ui.theme;
    if (state.show_command_palette && !palette.open) begin(state, palette);
    if (!palette.open) return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * window.x, std::min(theme.px(64), 0.1f * window.y)}, ImGuiCond_Always, {0.5f, 0});
    ImGui::SetNextWindowSize({std::min(theme.px(580), 0.94f * window.x), 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(10), theme.px(10)));
    const bool shown = ImGui::BeginPopup(popup, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar();
    std::optional<Command> command;
    bool closes = !shown || !state.show_command_palette || pressed(ImGuiKey_Escape, false);
    if (shown) {
        step(palette);
        const bool entered = query_field(theme, palette);
        std::optional<std::size_t> index = rows(state, theme, palette);
        if (entered && !palette.found.empty()) index = palette.chosen;
        if (index) command = at(palette.commands, at(palette.found, *index).index);
        if (command && !enabled(state, *command)) command.reset(), palette.begins = true;
        closes = closes || command;
        if (closes) ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
    }
    if (!closes) return;
    palette = {};
    state.show_command_palette = false;
    if (command) run(state, *command);
}

}  // namespace pinfield::editor
