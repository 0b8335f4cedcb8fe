#include "editor/panels/fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "editor/edit_tools.h"
#include "editor/panels/field_row.h"
#include "editor/widgets/widgets.h"
#include "engine/core/color.h"
#include "engine/core/numbers.h"

namespace pinfield::editor {

namespace {

void boolean_control(const Row& row) {
    // A switch: its knob's place shows the state without any color; in the middle, that some are on.
    const Theme& theme = row.theme();
    const bool mixed = row.mixed(), on = std::get<bool>(row.value()) && !mixed;
    const ImVec2 place = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight(), w = theme.px(32), h = theme.px(18), r = 0.5f * h;
    if (ImGui::InvisibleButton("switch", {w, height})) row.set(!on);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float top = place.y + 0.5f * (height - h);
    list.AddRectFilled({place.x, top}, {place.x + w, top + h},
                       ink(on                       ? Tint(Role::primary)
                           : ImGui::IsItemHovered() ? palette::field_active
                                                    : palette::field_hot),
                       r);
    list.AddCircleFilled({place.x + (mixed ? 0.5f * w : on ? w - r : r), top + r}, r - theme.px(3), ink(on ? palette::text : palette::quiet));
}

void color_control(const Row& row) {
    const Theme& theme = row.theme();
    const std::string text = row.mixed() ? mixed_word : std::get<std::string>(row.value());
    const auto parsed = parse_color(text);
    const auto part = [](std::uint8_t c) { return static_cast<float>(c) / 255; };
    float rgb[3] = {0.5f, 0.5f, 0.5f};
    if (parsed) rgb[0] = part(parsed->r), rgb[1] = part(parsed->g), rgb[2] = part(parsed->b);
    const float height = ImGui::GetFrameHeight();
    if (ImGui::ColorButton("swatch", {rgb[0], rgb[1], rgb[2], 1}, ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoBorder,
                           {height, height}))
        ImGui::OpenPopup("picker");
    ImGui::SameLine(0, theme.px(6));
    text_control(row, row.width - height - theme.px(6), text, "theme's");
    if (!ImGui::BeginPopup("picker")) return;
    Document& document = row.state.document;
    if (ImGui::ColorPicker3("##color", rgb, ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoInputs)) {
        const auto byte = [](float c) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(c, 0.0f, 1.0f))); };
        for (const FieldOf& f : row.all)
            tell(row.state, document.preview({f.node, f.field, to_text(Color{byte(rgb[0]), byte(rgb[1]), byte(rgb[2])})}));
    }
    if (document.previewing() && !ImGui::IsMouseDown(0)) tell(row.state, document.commit(change_label(document.scene(), row.all)));
    ImGui::EndPopup();
}

void control(const Row& row) {
    const FieldKind kind = row.field().kind;
    const bool in_numbers = kind == FieldKind::integer || kind == FieldKind::number || kind == FieldKind::vec2 || kind == FieldKind::points;
    if (!in_numbers || row.ui.typing.is(row.node.id, row.index(), -1)) tab_stop(row, -1);
    if (row.ui.typing.is(row.node.id, row.index(), -1)) return typing_field(row, row.width);
    switch (row.field().kind) {
        case FieldKind::boolean: return boolean_control(row);
        case FieldKind::integer:
        case FieldKind::number: return number_control(row, 0, row.width);
        case FieldKind::vec2: return vec2_control(row, 0);
        case FieldKind::points: return points_control(row);
        case FieldKind::choice: return choice_control(row);
        case FieldKind::choices: return choices_control(row);
        case FieldKind::color: return color_control(row);
        case FieldKind::names: return names_control(row);
        case FieldKind::id:
            if (row.field().meta.meaning == Meaning::material) return material_control(row);
            [[fallthrough]];
        case FieldKind::text: return text_control(row, row.width, row.mixed() ? mixed_word : std::get<std::string>(row.value()), "none");
    }
}

/// "deg/s^2" as people write it.
std::string written(std::string_view symbol) {
    std::string text;
    for (std::size_t i = 0; i < symbol.size();) {
        const std::string_view rest = symbol.substr(i);
        if (rest.starts_with("deg")) text += "\u00b0", i += 3;
        else if (rest.starts_with("^2")) text += "\u00b2", i += 2;
        else text += symbol[i++];
    }
    return text;
}

std::string label_of(std::string_view key) {
    std::string label(key);
    std::replace(label.begin(), label.end(), '_', ' ');
    return label;
}

/// A number that stands in the file as it is may become a param.
void param_items(const Row& row) {
    const FieldSlot& slot = at(row.node.fields, row.index());
    const int parts = row.field().kind == FieldKind::vec2 ? 2 : row.field().kind == FieldKind::number || row.field().kind == FieldKind::integer ? 1 : 0;
    const bool may = row.all.size() == 1 && slot.is_explicit && slot.where;
    for (int part = 0; part < parts; ++part) {
        const char* label = parts == 1 ? "Make it a param" : part == 0 ? "Make x a param" : "Make y a param";
        const auto is_part = [part](const WrittenPart& written) { return written.index == part; };
        const bool is_expression = slot.written && std::any_of(slot.written->begin(), slot.written->end(), is_part);
        if (ImGui::MenuItem(label, nullptr, false, may && !is_expression)) make_param(row.state, row.node.id, row.index(), part);
    }
}

void label_menu(const Row& row) {
    AppState& state = row.state;
    if (ImGui::MenuItem("Back to the default", nullptr, false, row.is_explicit() && !row.field().meta.required)) row.change(reset_all);
    if (ImGui::MenuItem("Type the value")) begin_typing(row, row.field().kind == FieldKind::number ? 0 : -1);
    param_items(row);
    ImGui::Separator();
    if (ImGui::MenuItem("Copy the value", nullptr, false, !row.mixed()))
        ImGui::SetClipboardText(text_of(state.document, row.node.id, row.index()).c_str());
    const char* copied = ImGui::GetClipboardText();
    if (ImGui::MenuItem("Paste the value", nullptr, false, copied && *copied)) row.change(set_all_from_text, std::string_view(copied));
}

/// "bloom * 2", or "bloom * 2 and gap" of a point; empty where plain values stand.
std::string expression_of(const Row& row) {
    const FieldSlot& slot = at(row.node.fields, row.index());
    std::string out;
    for (const WrittenPart& part : slot.written ? *slot.written : WrittenParts{}) out += (out.empty() ? "" : " and ") + part.text;
    return out;
}

}  // namespace

Shown shown(double value, Unit unit) {
    const auto hundredths = [](double x) { return to_text(std::round(100 * x) / 100 + 0.0); };  // + 0.0: never "-0"
    switch (unit) {
        case Unit::metre:
            // What is far below a hundredth of a millimetre (a tolerance) keeps its own digits; the thousand must not add any.
            if (value != 0 && std::fabs(value) < 1e-5) return {fmt::format("{:.12g}", 1000 * value), "mm"};
            return {hundredths(1000 * value), "mm"};
        case Unit::degree: return {hundredths(value), "\u00b0"};
        case Unit::none: return {to_text(value), ""};
        default: return {to_text(value), written(symbol(unit))};
    }
}

void field_row(AppState& state, Ui& ui, const Node& node, const SharedField& field) {
    const Theme& theme = ui.theme;
    ImGui::PushID(field.front().field);
    const float whole = ImGui::GetContentRegionAvail().x, label_width = std::floor(std::clamp(0.36f * whole, theme.px(84), theme.px(130)));
    const Row row{state, ui, node, field, whole - label_width};
    const ImVec2 place = ImGui::GetCursorScreenPos();

    ImGui::InvisibleButton("label", {label_width - theme.px(6), ImGui::GetFrameHeight()});
    std::string doc(row.field().meta.doc);
    const bool is_explicit = row.is_explicit();
    doc += is_explicit ? "\nRight-click to take it out of the file, or to copy it." : "\nNot in the file: this is the default.";
    const std::string expression = expression_of(row);
    if (!expression.empty()) doc += "\nIn the file it is " + expression + ".";
    tooltip(theme, doc);
    if (ImGui::BeginPopupContextItem("label menu")) {
        label_menu(row);
        ImGui::EndPopup();
    }
    const float badge = expression.empty() ? 0 : theme.px(20);
    if (badge > 0)
        ImGui::GetWindowDrawList()->AddText(theme.small, theme.small->FontSize,
                                            {place.x + label_width - theme.px(6) - badge, place.y + 0.5f * (ImGui::GetFrameHeight() - theme.small->FontSize)},
                                            ink(palette::accent), "fx");
    const std::string label = fitted(label_of(row.field().key), label_width - theme.px(8) - badge);
    ImGui::GetWindowDrawList()->AddText({place.x, place.y + 0.5f * (ImGui::GetFrameHeight() - ImGui::GetFontSize())},
                                        ink(is_explicit ? palette::text : palette::quiet), label.c_str());
    ImGui::SetCursorScreenPos({place.x + label_width, place.y});
    control(row);
    ImGui::PopID();
}

}  // namespace pinfield::editor
