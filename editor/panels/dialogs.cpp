#include <algorithm>
#include <filesystem>
#include <span>

#include "editor/panels/ui.h"
#include "editor/path_question.h"
#include "editor/widgets/modal.h"
#include "editor/widgets/widgets.h"
#include "engine/core/at.h"

namespace pinfield::editor {

namespace {

namespace fs = std::filesystem;

void list_folder(PathDialog& dialog) {
    dialog.folders.clear();
    dialog.files.clear();
    std::error_code ignored;  // a folder that cannot be read shows as empty
    for (fs::directory_iterator it(dialog.folder, fs::directory_options::skip_permission_denied, ignored), end; !ignored && it != end;
         it.increment(ignored)) {
        const std::string name = it->path().filename().string();
        if (name.empty() || name[0] == '.') continue;
        std::error_code unknown;
        if (it->is_directory(unknown)) dialog.folders.push_back(name);
        else if (is_wanted(path_question(dialog.action), name)) dialog.files.push_back(name);
    }
    std::sort(dialog.folders.begin(), dialog.folders.end());
    std::sort(dialog.files.begin(), dialog.files.end());
}

void go_to(PathDialog& dialog, const fs::path& folder) {
    std::error_code unreadable;
    const fs::path whole = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, unreadable);
    dialog.folder = unreadable ? folder.string() : whole.string();
    list_folder(dialog);
}

/// One line of the listing; whether it was clicked, and whether twice.
struct Click {
    bool once = false, twice = false;
};
Click listing_row(const Theme& theme, const std::string& name, Icon icon, const Tint& color, bool chosen) {
    const ImVec2 place = ImGui::GetCursorScreenPos(), size{ImGui::GetContentRegionAvail().x, theme.px(26)};
    Click click{ImGui::InvisibleButton(name.c_str(), size), false};
    const bool hot = ImGui::IsItemHovered();
    click.twice = hot && ImGui::IsMouseDoubleClicked(0);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (chosen || hot)
        list.AddRectFilled(place, {place.x + size.x, place.y + size.y}, ink(chosen ? palette::accent_deep : palette::field_hot),
                           theme.px(4));
    draw_icon(list, icon, {place.x + theme.px(16), place.y + 0.5f * size.y}, theme.px(14), ink(color));
    list.AddText({place.x + theme.px(32), place.y + 0.5f * (size.y - ImGui::GetFontSize())}, ink(palette::text), name.c_str());
    return click;
}

/// The folder's content; true when a file was chosen for good.
bool listing(const Theme& theme, PathDialog& dialog) {
    bool done = false;
    std::string enter;
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::panel);
    ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, theme.px(5));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(6), theme.px(6)));
    ImGui::BeginChild("##listing", {0, theme.px(260)}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    if (fs::path(dialog.folder).has_relative_path() && listing_row(theme, "..", Icon::folder, palette::quiet, false).once) enter = "..";
    for (const std::string& folder : dialog.folders)
        if (listing_row(theme, folder, Icon::folder, palette::amber, false).once) enter = folder;
    for (const std::string& file : dialog.files) {
        const Click click = listing_row(theme, file, Icon::file, palette::accent, file == dialog.name);
        if (click.once || click.twice) dialog.name = file;
        done = done || click.twice;
    }
    if (dialog.folders.empty() && dialog.files.empty())
        text_in(theme.body, palette::quiet, std::string("  ") + path_question(dialog.action).none);
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
    if (!enter.empty()) go_to(dialog, fs::path(dialog.folder) / enter);
    return done;
}

void begin_path_dialog(const AppState& state, PathDialog& dialog) {
    dialog.action = state.dialog_action;
    const fs::path path(state.dialog_path);
    dialog.name = !path_question(dialog.action).saves ? "" : path.empty() ? "table.yaml" : path.filename().string();
    go_to(dialog, path.has_parent_path() ? path.parent_path() : fs::current_path());
}

/// While the desktop's own dialog asks, this window holds.
void elsewhere_dialog(AppState& state, const Theme& theme) {
    if (!begin_modal(theme, "##elsewhere", 380)) return;
    if (!state.dialog_action.empty()) text_in(theme.large, palette::text, path_question(state.dialog_action).title);
    text_in(theme.body, palette::quiet, "The file is chosen in the desktop's own window.");
    ImGui::Dummy({0, theme.px(8)});
    align_right(theme.px(92));
    if (dialog_button(theme, "Cancel", false) || escape_pressed()) run(state, "dialog.cancel");
    if (!state.asks_elsewhere || state.dialog_action.empty()) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace

void path_dialog(AppState& state, Ui& ui) {
    PathDialog& dialog = ui.dialog;
    const bool elsewhere = state.asks_elsewhere && !state.dialog_action.empty();
    if (elsewhere || ImGui::IsPopupOpen("##elsewhere")) elsewhere_dialog(state, ui.theme);  // the answer comes between frames
    if (elsewhere) return;
    const Theme& theme = ui.theme;
    constexpr const char* title = "##path";
    const bool begins = !state.dialog_action.empty() && dialog.action != state.dialog_action;
    if (begins) begin_path_dialog(state, dialog);
    if (dialog.action.empty()) return;
    if (begin_modal(theme, title, 560)) {
        const PathQuestion& question = path_question(dialog.action);
        text_in(theme.large, palette::text, question.title);
        text_in(theme.small, palette::quiet, fitted(dialog.folder, ImGui::GetContentRegionAvail().x));
        bool accept = listing(theme, dialog);
        ImGui::Dummy({0, theme.px(2)});
        char buffer[1024] = {};
        dialog.name.copy(buffer, sizeof buffer - 1);
        if (begins) ImGui::SetKeyboardFocusHere();
        ImGui::SetNextItemWidth(-1);
        ImGui::PushStyleColor(ImGuiCol_FrameBg, palette::panel);
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(theme.px(10), theme.px(6)));
        accept =
            ImGui::InputTextWithHint("##name", "File name or path", buffer, sizeof buffer, ImGuiInputTextFlags_EnterReturnsTrue) || accept;
        ImGui::PopStyleVar();
        ImGui::PopStyleColor();
        dialog.name = buffer;
        if (state.message_is_problem) text_in(theme.body, palette::amber, state.message);
        ImGui::Dummy({0, theme.px(4)});
        align_right(2 * theme.px(92) + ImGui::GetStyle().ItemSpacing.x);
        const std::string path = (fs::path(dialog.folder) / dialog.name).string();
        const bool replaces = state.replaces == path;
        const bool cancel = dialog_button(theme, "Cancel", false) || escape_pressed();
        ImGui::SameLine();
        accept = dialog_button(theme, replaces ? "Replace" : question.answer, true) || accept;
        if (cancel) run(state, "dialog.cancel");
        else if (accept && !dialog.name.empty()) {
            state.dialog_path = path;
            run(state, "dialog.accept");
        }
        if (state.dialog_action.empty()) ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
    }
    if (state.dialog_action.empty()) dialog = {};
}

namespace {

/// A dialog that asks one thing, and what its answers do.
struct Question {
    const char* id;
    float width;  ///< design pixels
    std::string title;
    std::span<const Answer> answers;
    int preferred = 0;
    std::string_view on_escape{};
};

/// `is_open`: whether it still asks, once an answer has run; `body`: what stands under the title.
template <class Body>
void ask(AppState& state, Ui& ui, const Question& question, bool (*is_open)(const AppState&), Body body) {
    const Theme& theme = ui.theme;
    if (!begin_modal(theme, question.id, question.width)) return;
    text_in(theme.large, palette::text, question.title);
    ImGui::PushTextWrapPos(0);
    body(theme);
    ImGui::PopTextWrapPos();
    ImGui::Dummy({0, theme.px(8)});
    const std::string_view answer = answered(theme, question.answers, question.preferred, ui.answer, question.on_escape);
    if (!answer.empty()) run(state, answer);
    if (!is_open(state)) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace

void prompt_dialog(AppState& state, Ui& ui) {
    if (!state.prompt) return;
    constexpr Answer answers[] = {{"Discard", "prompt.discard"}, {"Cancel", "prompt.cancel"}, {"Save", "prompt.save"}};
    ask(
        state, ui, {"##prompt", 440, "Unsaved changes", answers, 2, "prompt.cancel"},
        [](const AppState& s) { return s.prompt.has_value(); },
        [&](const Theme& theme) { text_in(theme.body, palette::quiet, state.prompt->question + " Save them first?"); });
}

namespace {

/// A sign in front says what the color says.
void diff_line(const Theme& theme, const DiffLine& line) {
    using Kind = DiffLine::Kind;
    const Tint color = line.kind == Kind::added ? palette::teal : line.kind == Kind::removed ? palette::coral : palette::quiet;
    const char* const sign = line.kind == Kind::added ? "+" : line.kind == Kind::removed ? "\u2212" : "";
    const float left = ImGui::GetCursorPosX();
    text_in(theme.small, palette::faint, std::to_string(line.number));
    ImGui::SameLine(left + theme.px(34));
    text_in(theme.small, color, sign);
    ImGui::SameLine(left + theme.px(48));
    ImGui::PushFont(theme.small);
    const std::string text = fitted(line.text, ImGui::GetContentRegionAvail().x);
    ImGui::PopFont();
    text_in(theme.small, color, text);
}

void diff_list(const Theme& theme, const LineDiff& diff) {
    const float row = theme.small->FontSize + theme.px(2);
    const auto hunks = std::count_if(diff.lines.begin(), diff.lines.end(), [](const DiffLine& line) { return line.begins_hunk; });
    const auto gaps = std::max<std::ptrdiff_t>(hunks - 1, 0);
    const float rows = static_cast<float>(diff.lines.size()) + (diff.left_out > 0 || diff.lines.empty() ? 1 : 0);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::panel);
    ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, theme.px(5));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(10), theme.px(8)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, theme.px(2)));
    const float height = rows * row + static_cast<float>(gaps) * theme.px(8) + theme.px(18);
    ImGui::BeginChild("##diff", {0, std::min(height, 0.5f * ImGui::GetIO().DisplaySize.y)}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    for (std::size_t i = 0; i < diff.lines.size(); ++i) {
        if (diff.lines[i].begins_hunk && i > 0) ImGui::Dummy({0, theme.px(6)});
        diff_line(theme, diff.lines[i]);
    }
    if (diff.lines.empty()) text_in(theme.small, palette::quiet, "The lines are the same; how they end is not.");
    if (diff.left_out > 0) text_in(theme.small, palette::quiet, "and " + std::to_string(diff.left_out) + " more changed lines");
    ImGui::EndChild();
    ImGui::PopStyleVar(3);
    ImGui::PopStyleColor();
}

}  // namespace

void recovery_dialog(AppState& state, Ui& ui) {
    if (!state.recovery || state.prompt || !state.dialog_action.empty()) return;
    const Recovery& recovery = *state.recovery;
    constexpr Answer answers[] = {{"Discard", "recover.discard"}, {"Later", "recover.later"}, {"Restore", "recover.restore"}};
    const Question question{"##recovery", 620, "Unsaved work was found", answers, recovery.file_changed ? 1 : 2, "recover.later"};
    ask(state, ui, question, [](const AppState& s) { return s.recovery.has_value(); }, [&](const Theme& theme) {
        text_in(theme.body, palette::quiet, summary(recovery, seconds_since_1970()));
        if (recovery.file_changed)
            text_in(theme.body, palette::amber,
                    "The file has changed since: what it holds now would be replaced as below. Undo brings it back.");
        if (recovery.file_gone) text_in(theme.body, palette::amber, "Its file is gone: " + recovery.orphan.work.table);
        diff_list(theme, recovery.diff);
    });
}

void shared_dialog(AppState& state, Ui& ui) {
    if (!state.shared || state.prompt || !state.dialog_action.empty()) return;
    const SharedEdit edit = *state.shared;
    constexpr Answer answers[] = {{"Cancel", "shared.cancel"}, {"Here only", "shared.here"}, {"All of them", "shared.everywhere"}};
    const std::string title = "Shared by " + std::to_string(edit.places) + " places";
    ask(
        state, ui, {"##shared", 460, title, answers, 1, "shared.cancel"}, [](const AppState& s) { return s.shared.has_value(); },
        [&](const Theme& theme) {
            text_in(theme.body, palette::quiet,
                    edit.label + ": the text stands at the anchor &" + edit.anchor + " and is used from there.");
        });
}

namespace {

void sheet_line(const Theme& theme, const std::string& what, const std::string& key, float column) {
    const float x = ImGui::GetCursorPosX();
    ImGui::TextUnformatted(what.c_str());
    ImGui::SameLine(0, 0);
    ImGui::SetCursorPosX(x + column);
    text_in(theme.body, palette::accent, key);
}

std::vector<std::string_view> menus_with_keys() {
    std::vector<std::string_view> menus;
    for (const Action& action : all_actions())
        if (!action.menu.empty() && !action.shortcut.empty() && std::find(menus.begin(), menus.end(), action.menu) == menus.end())
            menus.push_back(action.menu);
    return menus;
}

void table_keys(const AppState& state, const Theme& theme, float column) {
    text_in(theme.strong, palette::quiet, "On the table");
    for (const InputBinding& input : state.document.scene().inputs) {
        std::string keys;
        for (const std::string& key : input.keys) keys += (keys.empty() ? "" : ", ") + key;
        sheet_line(theme, input.name, keys, column);
    }
    ImGui::Dummy({0, theme.px(8)});
    text_in(theme.strong, palette::quiet, "Mouse");
    sheet_line(theme, "Select, move", "click, drag", column);
    sheet_line(theme, "Move by the grid", "arrows, Shift: ten", column);
    sheet_line(theme, "Move freely", "Ctrl + drag", column);
    sheet_line(theme, "Keep to one axis", "Shift + drag", column);
    sheet_line(theme, "Move a copy", "Alt + drag", column);
    sheet_line(theme, "Select many", "a box, Shift + click", column);
    sheet_line(theme, "Into an operator", "double click", column);
    sheet_line(theme, "All that can be done", "right click", column);
    sheet_line(theme, "Pan", "middle or right drag", column);
    sheet_line(theme, "Zoom", "wheel", column);
    sheet_line(theme, "Change a number", "drag it sideways", column);
    sheet_line(theme, "Finer, coarser", "Shift, Ctrl", column);
    sheet_line(theme, "Type a number", "double click", column);
}

}  // namespace

void shortcut_sheet(AppState& state, Ui& ui) {
    if (!state.show_help) return;
    const Theme& theme = ui.theme;
    if (!begin_modal(theme, "##keys", 1000)) return;
    text_in(theme.large, palette::text, "Keys");
    ImGui::Dummy({0, theme.px(6)});
    const float column = theme.px(160);
    // Where the window is too low for all of it, the keys scroll and the button stays.
    ImGui::BeginChild("##keys_list", {0, std::min(theme.px(560), 0.94f * ImGui::GetIO().DisplaySize.y - theme.px(130))});
    ImGui::Columns(3, "##columns", false);
    for (const std::string_view menu : menus_with_keys()) {
        if (menu == "Play") ImGui::NextColumn();
        text_in(theme.strong, palette::quiet, menu);
        for (const Action& action : all_actions())
            if (action.menu == menu && !action.shortcut.empty())
                sheet_line(theme, std::string(action.label), std::string(action.shortcut), column);
        ImGui::Dummy({0, theme.px(8)});
    }
    ImGui::NextColumn();
    table_keys(state, theme, column);
    ImGui::Columns(1);
    ImGui::EndChild();
    align_right(theme.px(92));
    if (dialog_button(theme, "Close", true) || escape_pressed()) state.show_help = false;
    if (!state.show_help) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace pinfield::editor
