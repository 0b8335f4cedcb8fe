#include "editor/panels/fields.h"

#include <algorithm>
#include <cmath>

#include "editor/typed_number.h"
#include "editor/widgets/widgets.h"
#include "engine/core/at.h"
#include "engine/core/color.h"
#include "engine/core/numbers.h"

namespace pinfield::editor {

namespace {

/// What every control needs to know.
struct Row {
    AppState& state;
    Ui& ui;
    const Node& node;
    int index;
    float width;  ///< of the control

    const Theme& theme() const { return ui.theme; }
    const FieldType& field() const { return at(node.type->fields, index); }
    const FieldSlot& slot() const { return at(node.fields, index); }
    const Value& value() const { return slot().value; }
    void set(Value to) const {
        edit(state, {node.id, index, std::move(to)}, change_label(state.document.scene(), node.id, index));
    }
};

void begin_typing(const Row& row, int component) {
    Typing& typing = row.ui.typing;
    typing = {row.node.id, row.index, component, {}, true};
    if (component < 0) typing.text = text_of(row.state.document, row.node.id, row.index);
    else typing.text = shown(pinfield::editor::component(row.value(), component), row.field().meta.unit).number;
}

void finish_typing(const Row& row) {
    Typing& typing = row.ui.typing;
    Document& document = row.state.document;
    if (row.field().meta.meaning == Meaning::id) {
        take(row.state, rename_node(document, row.node.id, typing.text));
    } else if (typing.component < 0) {
        tell(row.state, set_from_text(document, row.node.id, row.index, typing.text));
    } else {
        // What is typed means the unit that is shown. Only lengths are shown in another than a bare number has.
        const Unit unit = row.field().meta.unit;
        const bool in_mm = shown(pinfield::editor::component(row.value(), typing.component), unit).unit == "mm";
        const Result<double> value = typed_number(typing.text, unit, in_mm ? "mm" : "");
        if (value) row.set(with_component(row.value(), typing.component, *value));
        else tell(row.state, value.error().message);
    }
    typing = {};
}

/// The text field that stands in for a control while its value is typed.
void typing_field(const Row& row, float width) {
    Typing& typing = row.ui.typing;
    char buffer[512] = {};
    typing.text.copy(buffer, sizeof buffer - 1);
    ImGui::SetNextItemWidth(width);
    if (typing.begins) ImGui::SetKeyboardFocusHere();
    const bool entered =
        ImGui::InputText("##type", buffer, sizeof buffer, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    typing.text = buffer;
    if (entered) finish_typing(row);
    else if (!typing.begins && ImGui::IsItemDeactivated()) {
        // Escape drops what was typed, clicking elsewhere takes it.
        if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) typing = {};
        else if (ImGui::IsItemDeactivatedAfterEdit()) finish_typing(row);
        else typing = {};
    }
    typing.begins = false;
}

/// How full a number's bar is, where the field has both ends of a range.
float share_of_range(const FieldMeta& meta, double value) {
    const double lo = meta.min.value, hi = meta.max.value;
    if (!std::isfinite(lo) || !std::isfinite(hi) || hi - lo > 1000) return 0;
    return static_cast<float>(std::clamp((value - lo) / (hi - lo), 0.0, 1.0));
}

/// Drags the number under the mouse, or begins to type it.
void scrub_number(const Row& row, int component, bool hot, bool held) {
    Scrub& scrub = row.ui.scrub;
    Document& document = row.state.document;
    if (hot || held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (hot && ImGui::IsMouseDoubleClicked(0)) {
        scrub.cancel(document);
        begin_typing(row, component);
    } else if (held && !scrub.active() && ImGui::IsMouseDragging(0, 2)) {
        scrub.begin(document, row.node.id, row.index, component);
    }
    if (held && scrub.active()) {
        const ImGuiIO& io = ImGui::GetIO();
        const double pixels = ImGui::GetMouseDragDelta(0, 0).x / row.theme().scale;
        scrub.update(document, pixels, io.KeyShift, io.KeyCtrl);
    }
    if (ImGui::IsItemDeactivated() && scrub.active()) tell(row.state, scrub.end(document));
}

/// The number with its name before and its unit behind, on a bar as full as the value is of its range.
void draw_number(const Row& row, int component, ImVec2 place, ImVec2 size, const Tint& background, const char* name) {
    const Theme& theme = row.theme();
    const double value = pinfield::editor::component(row.value(), component);
    const Shown text = shown(value, row.field().meta.unit);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{place.x + size.x, place.y + size.y};
    const float round = ImGui::GetStyle().FrameRounding, pad = theme.px(8);
    list.AddRectFilled(place, end, ink(background), round);
    const float share = share_of_range(row.field().meta, value);
    if (share > 0) {
        list.PushClipRect(place, {place.x + share * size.x, end.y}, true);
        list.AddRectFilled(place, end, ink(palette::accent.faded(0.16f)), round);
        list.PopClipRect();
    }
    const float y = place.y + 0.5f * (size.y - ImGui::GetFontSize());
    float x = place.x + pad;
    if (*name) {
        list.AddText({x, y}, ink(palette::faint), name);
        x += theme.px(16);
    }
    const float unit_width = theme.small->CalcTextSizeA(theme.small->FontSize, 1e9f, 0, text.unit.c_str()).x;
    const std::string number = fitted(text.number, end.x - pad - unit_width - theme.px(4) - x);
    list.AddText({x, y}, ink(palette::text), number.c_str());
    list.AddText(theme.small, theme.small->FontSize, {end.x - pad - unit_width, place.y + 0.5f * (size.y - theme.small->FontSize)},
                 ink(palette::quiet), text.unit.c_str());
}

/// A number that is dragged sideways, or typed after a double click.
void number_control(const Row& row, int component, float width, const char* name = "") {
    ImGui::PushID(component);
    if (row.ui.typing.is(row.node.id, row.index, component)) {
        typing_field(row, width);
    } else {
        const ImVec2 place = ImGui::GetCursorScreenPos(), size{width, ImGui::GetFrameHeight()};
        ImGui::InvisibleButton("scrub", size);
        const bool hot = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
        scrub_number(row, component, hot, held);
        draw_number(row, component, place, size, held ? palette::field_active : hot ? palette::field_hot : palette::field, name);
    }
    ImGui::PopID();
}

void vec2_control(const Row& row, int first) {
    const float gap = row.theme().px(6), half = 0.5f * (row.width - gap);
    number_control(row, first, std::floor(half), "x");
    ImGui::SameLine(0, gap);
    number_control(row, first + 1, std::floor(half), "y");
}

void points_control(const Row& row) {
    const auto points = std::get<std::vector<Vec2>>(row.value());
    ImGui::BeginGroup();
    for (int i = 0; i < static_cast<int>(points.size()); ++i) vec2_control(row, 2 * i);
    ImGui::EndGroup();
}

void boolean_control(const Row& row) {
    // A switch: its knob's place shows the state without any color.
    const Theme& theme = row.theme();
    const bool on = std::get<bool>(row.value());
    const ImVec2 place = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight(), w = theme.px(32), h = theme.px(18), r = 0.5f * h;
    if (ImGui::InvisibleButton("switch", {w, height})) row.set(!on);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float top = place.y + 0.5f * (height - h);
    list.AddRectFilled({place.x, top}, {place.x + w, top + h},
                       ink(on                       ? palette::hex(0x2f7ab3)
                           : ImGui::IsItemHovered() ? palette::field_active
                                                    : palette::field_hot),
                       r);
    list.AddCircleFilled({place.x + (on ? w - r : r), top + r}, r - theme.px(3), ink(on ? palette::text : palette::quiet));
}

/// A word of the field's choices, when the user takes another than `now`.
std::optional<std::string> other_choice(const Row& row, const std::string& now, float width) {
    std::optional<std::string> taken;
    if (!begin_combo(row.theme(), "##choice", now.c_str(), width)) return taken;
    for (const std::string_view word : row.field().choices) {
        const std::string text(word);
        if (ImGui::Selectable(text.c_str(), text == now) && text != now) taken = text;
    }
    ImGui::EndCombo();
    return taken;
}

void choice_control(const Row& row) {
    if (const auto taken = other_choice(row, std::get<std::string>(row.value()), row.width)) row.set(*taken);
}

void choices_control(const Row& row) {
    std::vector<std::string> words = std::get<std::vector<std::string>>(row.value());
    const float gap = row.theme().px(6), half = std::floor(0.5f * (row.width - gap));
    bool changed = false;
    ImGui::BeginGroup();
    for (std::size_t i = 0; i < words.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (i % 2 == 1) ImGui::SameLine(0, gap);
        if (const auto taken = other_choice(row, words[i], words.size() == 1 ? row.width : half)) words[i] = *taken, changed = true;
        ImGui::PopID();
    }
    ImGui::EndGroup();
    if (changed) row.set(words);
}

/// Any value in the format's own spelling: a click lets it be typed.
void text_control(const Row& row, float width, const std::string& text, const char* hint) {
    const Theme& theme = row.theme();
    const ImVec2 place = ImGui::GetCursorScreenPos(), size{width, ImGui::GetFrameHeight()};
    if (ImGui::InvisibleButton("text", size)) begin_typing(row, -1);
    const bool hot = ImGui::IsItemHovered();
    if (hot) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(place, {place.x + size.x, place.y + size.y}, ink(hot ? palette::field_hot : palette::field),
                       ImGui::GetStyle().FrameRounding);
    const std::string fits = fitted(text.empty() ? hint : text, width - theme.px(16));
    list.AddText({place.x + theme.px(8), place.y + 0.5f * (size.y - ImGui::GetFontSize())},
                 ink(text.empty() ? palette::faint : palette::text), fits.c_str());
}

void color_control(const Row& row) {
    const Theme& theme = row.theme();
    const std::string& text = std::get<std::string>(row.value());
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
        tell(row.state, document.preview({row.node.id, row.index, to_text(Color{byte(rgb[0]), byte(rgb[1]), byte(rgb[2])})}));
    }
    if (document.previewing() && !ImGui::IsMouseDown(0))
        tell(row.state, document.commit(change_label(document.scene(), row.node.id, row.index)));
    ImGui::EndPopup();
}

/// Names of inputs as chips to switch on and off; other names as text.
void names_control(const Row& row) {
    const auto& names = std::get<std::vector<std::string>>(row.value());
    const auto& inputs = row.state.document.scene().inputs;
    if (row.field().meta.meaning != Meaning::input || inputs.empty()) {
        std::string text;
        for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
        return text_control(row, row.width, text, "none");
    }
    const Theme& theme = row.theme();
    ImGui::BeginGroup();
    float x = 0;
    for (const InputBinding& input : inputs) {
        const bool on = std::find(names.begin(), names.end(), input.name) != names.end();
        const float width = ImGui::CalcTextSize(input.name.c_str()).x + theme.px(18);
        if (x > 0 && x + width <= row.width) ImGui::SameLine(0, theme.px(5));
        else x = 0;
        x += width + theme.px(5);
        ImGui::PushStyleColor(ImGuiCol_Button, on ? palette::accent_deep : palette::field);
        ImGui::PushStyleColor(ImGuiCol_Text, on ? palette::text : palette::quiet);
        if (ImGui::Button(input.name.c_str(), {width, 0})) {
            std::vector<std::string> changed = names;
            if (on) changed.erase(std::find(changed.begin(), changed.end(), input.name));
            else changed.push_back(input.name);
            row.set(changed);
        }
        ImGui::PopStyleColor(2);
    }
    ImGui::EndGroup();
}

/// The materials that there are, to choose from.
void material_control(const Row& row) {
    const Theme& theme = row.theme();
    const std::string chosen = std::get<std::string>(row.value());
    if (!begin_combo(theme, "##material", chosen.empty() ? "inherited" : chosen.c_str(), row.width)) return;
    std::optional<std::string> next;
    if (ImGui::Selectable("inherited", chosen.empty())) next = "";
    for (const NodeId id : row.state.document.scene().materials()) {
        const std::string& name = row.state.document.scene().find(id)->name;
        if (ImGui::Selectable(name.c_str(), name == chosen)) next = name;
    }
    ImGui::EndCombo();
    if (!next) return;
    const Value value = next->empty() ? row.field().initial : Value(*next);
    edit(row.state, {row.node.id, row.index, value, !next->empty()}, change_label(row.state.document.scene(), row.node.id, row.index));
}

void control(const Row& row) {
    if (row.ui.typing.is(row.node.id, row.index, -1)) return typing_field(row, row.width);
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
        case FieldKind::text: return text_control(row, row.width, std::get<std::string>(row.value()), "none");
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

}  // namespace

Shown shown(double value, Unit unit) {
    const auto hundredths = [](double x) { return to_text(std::round(100 * x) / 100 + 0.0); };  // + 0.0: never "-0"
    switch (unit) {
        case Unit::metre:
            // What is far below a hundredth of a millimetre (a tolerance) keeps its own digits.
            if (value != 0 && std::fabs(value) < 1e-5) return {to_text(1000 * value), "mm"};
            return {hundredths(1000 * value), "mm"};
        case Unit::degree: return {hundredths(value), "\u00b0"};
        case Unit::none: return {to_text(value), ""};
        default: return {to_text(value), written(symbol(unit))};
    }
}

void field_row(AppState& state, Ui& ui, const Node& node, int field) {
    const Theme& theme = ui.theme;
    ImGui::PushID(field);
    const float whole = ImGui::GetContentRegionAvail().x, label_width = std::floor(std::clamp(0.36f * whole, theme.px(84), theme.px(130)));
    const Row row{state, ui, node, field, whole - label_width};
    const ImVec2 place = ImGui::GetCursorScreenPos();

    ImGui::InvisibleButton("label", {label_width - theme.px(6), ImGui::GetFrameHeight()});
    std::string doc(row.field().meta.doc);
    if (!row.slot().is_explicit) doc += "\nNot in the file: this is the default.";
    else doc += "\nRight-click to take it out of the file.";
    tooltip(theme, doc);
    if (ImGui::BeginPopupContextItem("label menu")) {
        const bool can = row.slot().is_explicit && !row.field().meta.required;
        if (ImGui::MenuItem("Back to the default", nullptr, false, can))
            edit(state, {node.id, field, row.field().initial, false}, change_label(state.document.scene(), node.id, field));
        if (ImGui::MenuItem("Type the value", nullptr)) begin_typing(row, row.field().kind == FieldKind::number ? 0 : -1);
        ImGui::EndPopup();
    }
    const std::string label = fitted(label_of(row.field().key), label_width - theme.px(8));
    ImGui::GetWindowDrawList()->AddText({place.x, place.y + 0.5f * (ImGui::GetFrameHeight() - ImGui::GetFontSize())},
                                        ink(row.slot().is_explicit ? palette::text : palette::quiet), label.c_str());
    ImGui::SetCursorScreenPos({place.x + label_width, place.y});
    control(row);
    ImGui::PopID();
}

}  // namespace pinfield::editor
