#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

#include "editor/panels/ui.h"
#include "editor/pick.h"
#include "editor/shared_fields.h"
#include "editor/widgets/widgets.h"
#include "engine/core/at.h"
#include "engine/core/color.h"

namespace pinfield::editor {

namespace {

bool contains_word(std::string_view text, std::string_view word) {
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    return std::search(text.begin(), text.end(), word.begin(), word.end(), same) != text.end();
}

bool is_found(const Node& node, std::string_view filter) {
    return contains_word(title_of(node), filter) || contains_word(node.type->key(), filter);
}

constexpr float flag_width = 18;  // design pixels

/// Draws the tree row by row and notes what was clicked.
class Tree {
public:
    Tree(AppState& state, Ui& ui) : state_(state), ui_(ui), scene_(state.document.scene()) {
        for (const Node* node = scene_.find(state.selection.primary()); node && node->parent; node = scene_.find(node->parent))
            above_selection_.push_back(node->parent);
        reveal_ = !state.selection.empty() && state.selection.primary() != ui.revealed;
        if (const NodeId node = std::exchange(state.renaming, NodeId{})) {
            if (const Node* found = scene_.find(node)) ui.renaming = {node, found->name, true};
            ui.filter.clear();
            reveal_ = true;
        }
    }

    void draw() {
        if (ui_.filter.empty()) {
            record(scene_.table(), 0);
            record(scene_.physics(), 0);
            if (heading("Materials", scene_.materials().size()))
                for (const NodeId id : scene_.materials()) record(*scene_.find(id), 1);
            if (plus_at_heading()) adds_material_ = true;
            if (heading("Scene", scene_.roots().size()))
                for (const NodeId id : scene_.roots()) subtree(*scene_.find(id), 1);
        } else {
            for (const NodeId id : scene_.all()) {
                const Node& node = *scene_.find(id);
                if (is_found(node, ui_.filter)) row(node, 0, false);
            }
        }
        if (reveal_) ui_.revealed = state_.selection.primary();
        if (!rename_drawn_) ui_.renaming = {};  // no row, no typing
        if (renamed_.first) take(state_, rename_node(state_.document, renamed_.first, renamed_.second));
        if (switched_.first) switch_flag();
        if (adds_material_) run(state_, "edit.add_material");
        if (dropped_) take(state_, move_nodes(state_.document, dropped_nodes_, *dropped_, !ImGui::GetIO().KeyCtrl));
        if (!clicked_) return;
        const bool more = ImGui::GetIO().KeyCtrl || ImGui::GetIO().KeyShift;
        if (more) state_.selection.toggle(clicked_);
        else select(state_, clicked_);
        ui_.revealed = state_.selection.primary();
    }

private:
    bool heading(const char* title, std::size_t count) {
        const Theme& theme = ui_.theme;
        ImGui::Dummy({0, theme.px(3)});
        bool* open = ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID(title), true);
        if (reveal_) *open = true;
        const ImVec2 place = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x, height = theme.px(24);
        if (ImGui::InvisibleButton(title, {width, height})) *open = !*open;
        const float y = place.y + 0.5f * (height - theme.small->FontSize);
        arrow({place.x + theme.px(9), place.y + 0.5f * height}, *open);
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddText(theme.small, theme.small->FontSize, {place.x + theme.px(20), y}, ink(palette::quiet), title);
        const std::string number = std::to_string(count);
        const float w = theme.small->CalcTextSizeA(theme.small->FontSize, 1e9f, 0, number.c_str()).x;
        list.AddText(theme.small, theme.small->FontSize, {place.x + width - w - theme.px(8), y}, ink(palette::faint), number.c_str());
        return *open;
    }

    /// A plus below the materials; whether it was clicked.
    bool plus_at_heading() const {
        const Theme& theme = ui_.theme;
        const ImVec2 place = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x, height = theme.px(24);
        const bool clicked = ImGui::InvisibleButton("new material", {width, height});
        const Tint color = ImGui::IsItemHovered() ? palette::text : palette::faint;
        tooltip(theme, "A new material with default values");
        ImGui::GetWindowDrawList()->AddText(theme.small, theme.small->FontSize, {place.x + theme.px(44), place.y + 0.5f * (height - theme.small->FontSize)},
                                            ink(color), "+ New material");
        return clicked;
    }

    void arrow(ImVec2 c, bool open) const {
        const float s = ui_.theme.px(3.5f);
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImU32 color = ink(palette::quiet);
        const float w = std::max(1.0f, 0.1f * ui_.theme.px(14));
        if (open) {
            list.AddLine({c.x - s, c.y - 0.5f * s}, {c.x, c.y + 0.5f * s}, color, w);
            list.AddLine({c.x, c.y + 0.5f * s}, {c.x + s, c.y - 0.5f * s}, color, w);
        } else {
            list.AddLine({c.x - 0.5f * s, c.y - s}, {c.x + 0.5f * s, c.y}, color, w);
            list.AddLine({c.x + 0.5f * s, c.y}, {c.x - 0.5f * s, c.y + s}, color, w);
        }
    }

    void record(const Node& node, int depth) { row(node, depth, false); }

    void subtree(const Node& node, int depth) {
        const bool parent = !node.children.empty();
        const bool open = row(node, depth, parent);
        if (parent && open)
            for (const NodeId child : node.children) subtree(*scene_.find(child), depth + 1);
    }

    /// One row; whether its children are shown.
    bool row(const Node& node, int depth, bool parent) {
        const Theme& theme = ui_.theme;
        ImGui::PushID(static_cast<int>(node.id.value));
        // A part with its shapes inside is one thing to look at; groups open themselves.
        bool* open = ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("open"), depth < 2 && icon_of(*node.type) == Icon::group);
        if (reveal_ && std::find(above_selection_.begin(), above_selection_.end(), node.id) != above_selection_.end()) *open = true;

        const ImVec2 place = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x, height = theme.px(25);
        const float indent = theme.px(4 + 15 * static_cast<float>(depth)), arrow_width = theme.px(16);
        if (ui_.renaming.node == node.id) {
            rename_field(node, place, indent + arrow_width, width, height);
            ImGui::PopID();
            return *open;
        }
        const bool pressed = ImGui::InvisibleButton("row", {width, height});
        const bool hot = ImGui::IsItemHovered(), selected = state_.selection.contains(node.id);
        const std::string_view flag_hit = hot ? flag_under_mouse(node, place.x + width, height) : std::string_view();
        if (pressed) {
            if (!flag_hit.empty()) switched_ = {node.id, flag_hit};
            else if (parent && ImGui::GetIO().MousePos.x < place.x + indent + arrow_width) *open = !*open;
            else clicked_ = node.id;
        }
        if (hot && parent && ImGui::IsMouseDoubleClicked(0) && ImGui::GetIO().MousePos.x > place.x + indent + arrow_width) *open = !*open;
        if (hot) ui_.hovered = node.id;
        if (!node.is_record()) drag_and_drop(node, place, {width, height}, indent + arrow_width);
        if (hot && ImGui::IsMouseReleased(1)) ui_.menu_node = node.id;
        if (reveal_ && selected && !ImGui::IsItemVisible()) ImGui::SetScrollHereY(0.5f);
        paint(node, place, {width, height}, indent, arrow_width, selected, hot, parent, *open);
        ImGui::PopID();
        return *open;
    }

    /// At the right end of a row that the mouse is on: an eye and a lock; the field of the one that it is over.
    std::string_view flag_under_mouse(const Node& node, float right, float height) const {
        const float from_right = (right - ui_.theme.px(5) - ImGui::GetIO().MousePos.x) / ui_.theme.px(flag_width);
        if (node.is_record() || from_right < 0 || from_right >= 2 || height <= 0) return {};
        const bool lock = from_right < 1, locked = flag(node, "locked", false), seen = flag(node, "visible", true);
        tooltip(ui_.theme, lock ? locked ? "Unlock: the mouse takes hold of it on the table" : "Lock: the mouse goes through it on the table"
                                : seen ? "Hide: balls still meet it" : "Show");
        return lock ? "locked" : "visible";
    }

    /// Of all that is selected, where the row is one of it. A value as at first needs no words in the file.
    void switch_flag() {
        const auto [node, key] = switched_;
        const bool on = !flag(*scene_.find(node), key, key == "visible");
        SharedField fields;
        for (const NodeId id : state_.selection.contains(node) ? state_.selection.nodes() : std::vector{node})
            if (const auto field = scene_.find(id)->type->find_field(key)) fields.push_back({id, *field});
        const std::string label = change_label(scene_, fields);
        const auto why = set_all(state_.document, fields, on, on != (key == "visible"));
        say(state_, why.value_or(label), why.has_value());
    }

    /// A row is dragged to before, behind or into another; a line or a frame shows where.
    void drag_and_drop(const Node& node, ImVec2 place, ImVec2 size, float indent) {
        constexpr const char* kind = "scene nodes";
        if (ImGui::BeginDragDropSource(ImGuiDragDropFlags_SourceNoDisableHover)) {
            if (!state_.selection.contains(node.id)) select(state_, node.id);
            ImGui::SetDragDropPayload(kind, nullptr, 0);
            const std::size_t count = state_.selection.nodes().size();
            ImGui::TextUnformatted(count == 1 ? title_of(node).c_str() : (std::to_string(count) + " nodes").c_str());
            ImGui::EndDragDropSource();
        }
        if (!ImGui::BeginDragDropTarget()) return;
        const ImGuiPayload* payload =
            ImGui::AcceptDragDropPayload(kind, ImGuiDragDropFlags_AcceptBeforeDelivery | ImGuiDragDropFlags_AcceptNoDrawDefaultRect);
        if (payload) {
            const float along = (ImGui::GetIO().MousePos.y - place.y) / size.y;
            const bool into = node.type->meta.children.max > 0 && along > 0.25f && along < 0.75f, behind = along >= 0.5f;
            ImDrawList& list = *ImGui::GetWindowDrawList();
            const ImVec2 end{place.x + size.x, place.y + size.y};
            const float y = behind ? end.y : place.y;
            if (into) list.AddRect(place, end, ink(palette::accent), ui_.theme.px(4), 0, ui_.theme.px(1.5f));
            else list.AddLine({place.x + indent, y}, {end.x, y}, ink(palette::accent), ui_.theme.px(2));
            if (payload->IsDelivery()) {
                dropped_nodes_ = state_.selection.nodes();
                dropped_ = into ? Spot{node.id, static_cast<int>(node.children.size())}
                                : Spot{node.parent, scene_.index_of(node.id) + (behind ? 1 : 0)};
            }
        }
        ImGui::EndDragDropTarget();
    }

    /// The node's id while it is typed anew: Enter takes it, Esc leaves it.
    void rename_field(const Node& node, ImVec2 place, float indent, float width, float height) {
        Renaming& renaming = ui_.renaming;
        rename_drawn_ = true;
        ImGui::SetCursorScreenPos({place.x + indent, place.y});
        ImGui::SetNextItemWidth(width - indent);
        if (renaming.begins) ImGui::SetKeyboardFocusHere();
        char buffer[128] = {};
        renaming.text.copy(buffer, sizeof buffer - 1);
        const bool entered =
            ImGui::InputText("##rename", buffer, sizeof buffer, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
        renaming.text = buffer;
        const bool left = !renaming.begins && ImGui::IsItemDeactivated();
        const bool escaped = left && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
        renaming.begins = false;
        if (entered || (left && !escaped)) renamed_ = {node.id, renaming.text};
        if (entered || left) renaming = {};
        ImGui::SetCursorScreenPos({place.x, place.y + height});
    }

    void paint(const Node& node, ImVec2 place, ImVec2 size, float indent, float arrow_width, bool selected, bool hot,
               bool parent, bool open) const {
        const Theme& theme = ui_.theme;
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 end{place.x + size.x, place.y + size.y};
        const float middle = place.y + 0.5f * size.y, round = theme.px(4);
        if (selected) list.AddRectFilled(place, end, ink(palette::accent_deep), round);
        else if (hot || ui_.hovered == node.id) list.AddRectFilled(place, end, ink(palette::field), round);
        if (parent) arrow({place.x + indent + theme.px(7), middle}, open);

        float x = place.x + indent + arrow_width + theme.px(9);
        const bool seen = flag(node, "visible", true), locked = flag(node, "locked", false);
        Tint color = color_of(*node.type);
        if (const FieldSlot* slot = color_slot(node))
            if (const auto parsed = parse_color(std::get<std::string>(slot->value)))
                color = palette::hex(static_cast<unsigned>(parsed->r << 16 | parsed->g << 8 | parsed->b));
        draw_icon(list, icon_of(*node.type), {x, middle}, theme.px(14), ink(color.faded(seen ? 1.0f : 0.45f)));
        x += theme.px(15);

        float right = end.x - theme.px(8);
        const bool offers = hot && !node.is_record();  // what is as usual is shown where a click changes it
        const auto mark = [&](bool unusual, Icon icon, Icon usual) {
            if (!unusual && !offers) return;
            draw_icon(list, unusual ? icon : usual, {right - theme.px(6), middle}, theme.px(12), ink(unusual ? palette::text : palette::quiet));
            right -= theme.px(flag_width);
        };
        mark(locked, Icon::locked, Icon::unlocked);
        mark(!seen, Icon::hidden, Icon::seen);

        const Tint name_color = seen ? palette::text : palette::faint;
        const float text_y = middle - 0.5f * ImGui::GetFontSize();
        const std::string title = fitted(title_of(node), right - x);
        list.AddText({x, text_y}, ink(node.name.empty() && !selected ? palette::quiet : name_color), title.c_str());
        const float after = x + ImGui::CalcTextSize(title.c_str()).x + theme.px(10);
        if (node.is_record()) return;
        const auto beside = [&](const std::string& words) {
            const float size_of_text = theme.small->FontSize, words_width = theme.small->CalcTextSizeA(size_of_text, 1e9f, 0, words.c_str()).x;
            if (words.empty() || right - words_width <= after) return false;
            list.AddText(theme.small, size_of_text, {right - words_width, middle - 0.5f * size_of_text},
                         ink(selected ? palette::quiet : palette::faint), words.c_str());
            return true;
        };
        if (!node.name.empty()) return static_cast<void>(beside(std::string(node.type->key())));
        // Without an id one box is told from the next by how large it is, and where.
        if (!ImGui::IsRectVisible(place, end)) return;
        const Box2 box = bounds_of(state_, node.id);
        const std::string size_words = size_in_words(box);
        if (!beside(size_words + " " + place_in_words(box))) beside(size_words);
    }

    static bool flag(const Node& node, std::string_view key, bool otherwise) {
        const auto field = node.type->find_field(key);
        if (!field) return otherwise;
        const bool* value = std::get_if<bool>(&at(node.fields, *field).value);
        return value ? *value : otherwise;
    }

    static const FieldSlot* color_slot(const Node& node) {
        for (std::size_t i = 0; i < node.type->fields.size(); ++i)
            if (node.type->fields[i].kind == FieldKind::color) return &node.fields[i];
        return nullptr;
    }

    AppState& state_;
    Ui& ui_;
    const Scene& scene_;
    std::vector<NodeId> above_selection_;
    NodeId clicked_;
    std::pair<NodeId, std::string> renamed_;
    std::pair<NodeId, std::string_view> switched_;
    std::vector<NodeId> dropped_nodes_;
    std::optional<Spot> dropped_;
    bool reveal_ = false, rename_drawn_ = false, adds_material_ = false;
};

/// After the rows are done: what the menu does may replace the scene that they are drawn from.
void row_menu(AppState& state, Ui& ui) {
    if (const NodeId node = std::exchange(ui.menu_node, NodeId{})) {
        if (!state.selection.contains(node)) select(state, node);
        ImGui::OpenPopup("##row_menu");
    }
    if (!ImGui::BeginPopup("##row_menu")) return;
    node_menu(state, ui);
    ImGui::EndPopup();
}

/// Enter goes to the first node that was found.
void select_found(AppState& state, Ui& ui) {
    const Scene& scene = state.document.scene();
    const std::vector<NodeId> all = scene.all();
    const auto found = std::find_if(all.begin(), all.end(), [&](NodeId id) { return is_found(*scene.find(id), ui.filter); });
    if (ui.filter.empty() || found == all.end()) return;
    select(state, *found);
    ui.filter.clear();
}

void filter_box(AppState& state, Ui& ui) {
    const Theme& theme = ui.theme;
    const ImVec2 place = ImGui::GetCursorScreenPos();
    ImGui::SetNextItemWidth(-1);
    if (std::exchange(state.find_node, false)) ImGui::SetKeyboardFocusHere();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(theme.px(28), theme.px(5)));
    char buffer[128] = {};
    ui.filter.copy(buffer, sizeof buffer - 1);
    const bool entered = ImGui::InputTextWithHint("##filter", "Find a node", buffer, sizeof buffer, ImGuiInputTextFlags_EnterReturnsTrue);
    ui.filter = buffer;
    ImGui::PopStyleVar();
    draw_icon(*ImGui::GetWindowDrawList(), Icon::search, {place.x + theme.px(15), place.y + 0.5f * ImGui::GetItemRectSize().y},
              theme.px(14), ink(palette::quiet));
    if (entered) select_found(state, ui);
}

}  // namespace

void hierarchy_panel(AppState& state, Ui& ui, ImVec2 position, ImVec2 size) {
    const Theme& theme = ui.theme;
    begin_region("##hierarchy", position, size, palette::panel, {theme.px(8), theme.px(8)});
    filter_box(state, ui);
    ImGui::BeginChild("##tree", {0, 0}, false, ImGuiWindowFlags_NoNav);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    Tree(state, ui).draw();
    ImGui::PopStyleVar();
    row_menu(state, ui);
    ImGui::EndChild();
    ImGui::End();
}

}  // namespace pinfield::editor
