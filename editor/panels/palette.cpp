// The palette: every shape, operator and part as a small picture, to be dragged onto the table.
#include <algorithm>
#include <cmath>

#include "editor/panels/ui.h"
#include "editor/widgets/widgets.h"

namespace pinfield::editor {
namespace {

constexpr float cell_width = 68, picture_height = 46, cell_height = 68;  // design pixels
constexpr std::size_t most_recent = 6;

const Picture& picture_for(const AppState& state, Ui& ui, const NodeType& type) {
    const auto [found, is_new] = ui.palette.pictures.try_emplace(std::string(type.key()));
    if (is_new) found->second = picture_of(state.catalog, type);
    return found->second;
}

bool is_wanted(const NodeType& type, const std::string& search) {
    return type.meta.kind != NodeKind::record && type.key() != "domain" &&
           (search.empty() || type.key().find(search) != std::string_view::npos);
}

/// A star in the cell's corner, whose click makes the node a favourite or takes that back; true while the mouse is on it.
bool star(AppState& state, const Theme& theme, const NodeType& type, ImVec2 corner, bool cell_hot) {
    const bool chosen = is_favourite(state.preferences, type.key());
    const float r = theme.px(5);
    const ImVec2 c{corner.x - theme.px(10), corner.y + theme.px(10)}, mouse = ImGui::GetIO().MousePos;
    const bool on = cell_hot && std::hypot(mouse.x - c.x, mouse.y - c.y) < 1.8f * r;
    if (!chosen && !cell_hot) return false;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_icon(list, chosen ? Icon::star : Icon::star_outline, c, 2 * r, ink(on ? palette::accent : chosen ? palette::amber : palette::quiet));
    if (on && ImGui::IsMouseClicked(0)) toggle_favourite(state.preferences, type.key());
    if (on) tooltip(theme, chosen ? "No favourite any more" : "A favourite");
    return on;
}

/// One cell; true when it was double-clicked. A drag out of it takes the type into the hand.
bool cell(AppState& state, Ui& ui, const NodeType& type) {
    const Theme& theme = ui.theme;
    const ImVec2 place = ImGui::GetCursorScreenPos(), size{theme.px(cell_width), theme.px(cell_height)};
    ImGui::InvisibleButton(std::string(type.key()).c_str(), size);
    const bool hot = ImGui::IsItemHovered(), twice = hot && ImGui::IsMouseDoubleClicked(0);
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0, 4)) ui.palette.carried = &type;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (hot || ui.palette.carried == &type)
        list.AddRectFilled(place, {place.x + size.x, place.y + size.y}, ink(palette::field_hot), theme.px(5));
    const float margin = theme.px(7), height = theme.px(picture_height);
    const Picture& picture = picture_for(state, ui, type);
    const Tint color = color_of(type);
    if (picture.lines.empty())
        draw_icon(list, icon_of(type), {place.x + 0.5f * size.x, place.y + 0.5f * height}, theme.px(20), ink(color));
    else
        draw_picture(list, picture, {place.x + margin, place.y + margin}, {size.x - 2 * margin, height - 1.6f * margin}, ink(color),
                     std::max(1.0f, theme.px(1.5f)));
    ImGui::PushFont(theme.small);
    const std::string name = fitted(type.key(), size.x - theme.px(4));
    const float width = ImGui::CalcTextSize(name.c_str()).x;
    list.AddText({std::round(place.x + 0.5f * (size.x - width)), place.y + height + theme.px(2)}, ink(hot ? palette::text : palette::quiet),
                 name.c_str());
    ImGui::PopFont();
    const bool on_star = star(state, theme, type, {place.x + size.x, place.y}, hot && !ui.palette.carried);
    if (on_star) return false;
    if (!ui.palette.carried) tooltip(theme, std::string(type.key()) + ": " + std::string(type.meta.doc));
    return twice;
}

/// What was added stands among the recent ones, and the search is over.
void remember(Ui& ui, const NodeType& type) {
    std::vector<const NodeType*>& recent = ui.palette.recent;
    std::erase(recent, &type);
    recent.insert(recent.begin(), &type);
    if (recent.size() > most_recent) recent.pop_back();
    ui.palette.search.clear();
}

void cells(AppState& state, Ui& ui, const char* title, const std::vector<const NodeType*>& types) {
    if (types.empty()) return;
    text_in(ui.theme.small, palette::quiet, title);
    ImGui::PushID(title);
    const int columns = std::max(1, static_cast<int>(ImGui::GetContentRegionAvail().x / ui.theme.px(cell_width)));
    for (std::size_t i = 0; i < types.size(); ++i) {
        if (i % static_cast<std::size_t>(columns) != 0) ImGui::SameLine(0, 0);
        if (!cell(state, ui, *types[i])) continue;
        remember(ui, *types[i]);
        add_node(state, *types[i]);
    }
    ImGui::PopID();
    ImGui::Dummy({0, ui.theme.px(4)});
}

std::vector<const NodeType*> favourite_types(const AppState& state) {
    std::vector<const NodeType*> out;
    for (const std::string& key : state.preferences.favourites)
        if (const NodeType* type = state.catalog->find(key); type && is_wanted(*type, "")) out.push_back(type);
    return out;
}

std::vector<const NodeType*> found_types(const AppState& state, NodeKind kind, const std::string& search) {
    std::vector<const NodeType*> out;
    for (const NodeType& type : state.catalog->types())
        if (type.meta.kind == kind && is_wanted(type, search)) out.push_back(&type);
    std::stable_sort(out.begin(), out.end(), [](const NodeType* a, const NodeType* b) { return a->key() < b->key(); });
    return out;
}

}  // namespace

void draw_picture(ImDrawList& list, const Picture& picture, ImVec2 place, ImVec2 size, ImU32 color, float width) {
    if (picture.box.is_empty()) return;
    const Vec2 extent = picture.box.size().cwiseMax(1e-6), centre = picture.box.centre();
    const double scale = std::min(size.x / extent.x(), size.y / extent.y());
    std::vector<ImVec2> points;
    for (const std::vector<Vec2>& line : picture.lines) {
        points.clear();
        for (const Vec2& p : line)
            points.push_back({place.x + 0.5f * size.x + static_cast<float>(scale * (p.x() - centre.x())),
                              place.y + 0.5f * size.y - static_cast<float>(scale * (p.y() - centre.y()))});
        list.AddPolyline(points.data(), static_cast<int>(points.size()), color, ImDrawFlags_None, width);
    }
}

void palette_panel(AppState& state, Ui& ui, ImVec2 position, ImVec2 size) {
    const Theme& theme = ui.theme;
    begin_region("##palette", position, size, palette::panel, {theme.px(8), theme.px(8)});
    ImGui::SetNextItemWidth(-1);
    char buffer[64] = {};
    ui.palette.search.copy(buffer, sizeof buffer - 1);
    if (ImGui::InputTextWithHint("##palette_search", "Find what to add", buffer, sizeof buffer)) ui.palette.search = buffer;
    ImGui::BeginChild("##palette_cells", {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, theme.px(2)));
    if (ui.palette.search.empty()) {
        cells(state, ui, "Favourites", favourite_types(state));
        cells(state, ui, "Recent", ui.palette.recent);
    }
    const std::pair<const char*, NodeKind> kinds[] = {
        {"Parts", NodeKind::part}, {"Shapes", NodeKind::shape}, {"Operators", NodeKind::operation}};
    bool any = false;
    for (const auto& [title, kind] : kinds) {
        const std::vector<const NodeType*> types = found_types(state, kind, ui.palette.search);
        any = any || !types.empty();
        cells(state, ui, title, types);
    }
    if (!any) text_in(theme.small, palette::quiet, "Nothing is called so.");
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::End();
}

void carry_from_palette(AppState& state, Ui& ui) {
    const NodeType* type = ui.palette.carried;
    if (!type) return;
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
        ui.palette.carried = nullptr;
        return;
    }
    const Box2 viewport{state.view.origin, state.view.origin + state.view.size};
    const bool over_table = viewport.contains(ui.mouse);
    if (!ImGui::IsMouseDown(0)) {
        ui.palette.carried = nullptr;
        if (!over_table) return;
        remember(ui, *type);
        return add_node(state, *type, state.view.world_from_pixel(ui.mouse));
    }
    const Picture& picture = picture_for(state, ui, *type);
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const auto scale = static_cast<float>(over_table ? state.view.pixels_per_metre : 200);
    const ImVec2 mouse{static_cast<float>(ui.mouse.x()), static_cast<float>(ui.mouse.y())};
    if (picture.box.is_empty()) return draw_icon(list, icon_of(*type), mouse, ui.theme.px(20), ink(color_of(*type)));
    // The node's own origin comes under the hand.
    const Vec2 middle = picture.box.centre(), half = 0.5 * picture.box.size();
    const ImVec2 size{2 * scale * static_cast<float>(half.x()), 2 * scale * static_cast<float>(half.y())};
    const ImVec2 corner{mouse.x + scale * static_cast<float>(middle.x() - half.x()),
                        mouse.y - scale * static_cast<float>(middle.y() + half.y())};
    draw_picture(list, picture, corner, size, ink(palette::accent), std::max(1.0f, ui.theme.px(1.5f)));
}

}  // namespace pinfield::editor
