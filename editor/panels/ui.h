// What the panels remember between frames that is no part of the document: layout, drags in progress, open rows.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/app_state.h"
#include "editor/command_search.h"
#include "editor/edit_tools.h"
#include "editor/handles.h"
#include "editor/line_marks.h"
#include "editor/pick.h"
#include "editor/picture.h"
#include "editor/scrub.h"
#include "editor/showing.h"
#include "editor/snap.h"
#include "editor/text_cursor.h"
#include "editor/theme/theme.h"
#include "editor/transform.h"
#include "editor/widgets/icons.h"
#include "editor/yaml_highlight.h"

namespace pinfield::editor {

/// A value being typed in the inspector.
struct Typing {
    NodeId node;
    int field = -1;
    int component = -1;  ///< -1: the whole value
    std::string text;
    std::string before;  ///< that text at first: Tab takes only what differs
    bool begins = false;  ///< the text field must take the keyboard in the next frame
    bool is(NodeId n, int f, int c) const { return node == n && field == f && component == c; }
};

/// A value of the inspector, or one number of it, that Tab comes by.
struct TabStop {
    NodeId node;
    int field = -1;
    int component = -1;  ///< -1: the whole value
    bool operator==(const TabStop&) const = default;
};

/// A node's id being typed in the tree.
struct Renaming {
    NodeId node{};
    std::string text{};
    bool begins = false;  ///< the text field must take the keyboard in the next frame
};

struct PathDialog {
    std::string action;  ///< whose path is being asked for; empty: closed
    std::string folder;
    std::string name;
    std::vector<std::string> folders, files;  ///< of `folder`, sorted
};

/// A row of the table's inputs or tests whose name, or keys, are being typed.
struct ListsDialog {
    bool open = false;
    bool of_tests = false, of_keys = false;
    int row = -1;         ///< -1: none; as many as there are: a new one
    std::string text{};
    std::string why{};    ///< it was not taken
    bool begins = false;  ///< the text field must take the keyboard in the next frame
};

/// The handles of the selected node, as long as its values are these.
struct Handles {
    NodeId node{};
    std::vector<Value> values{};
    std::vector<Handle> all{};
    Copy copy{};  ///< at which they are seen: the one under the mouse last
};

/// What can be added, as pictures.
struct Palette {
    std::string search{};
    std::map<std::string, Picture> pictures{};  ///< by node type, and of the tables to begin with by their action
    std::vector<const NodeType*> recent{};      ///< the last one first
    const NodeType* carried = nullptr;          ///< being dragged onto the table
};

/// What dragged nodes may stop at, and the box they had when the drag began.
struct Magnets {
    Box2 box_before{};
    std::vector<Box2> others{};
    std::vector<SnapLine> lines{};  ///< that hold them now
};

/// From place to place, metres.
struct Measurement {
    Vec2 from{0, 0}, to{0, 0};
};

/// A guide in the hand.
struct GuideHand {
    std::optional<std::size_t> index{};  ///< among the table's
    bool is_new = false;                 ///< drawn out of a ruler
    double before = 0;                   ///< where it was, metres
};

/// The table's text as it is shown, and where somebody types in it.
struct SourcePanel {
    std::shared_ptr<const SourceText> shown{};
    std::vector<Token> tokens{};          ///< of `shown`
    int widest = 0;                       ///< of its lines, in characters
    Splice typed{};                       ///< what makes `shown` of the document's text
    std::optional<LineMarks> changes{};   ///< since the last save, if they are to be shown
    std::string compared_with{};          ///< the saved text
    TextCursor cursor{};
    bool focused = false;                 ///< the keyboard types here
    bool dragging = false;                ///< the mouse selects text
    bool hand_on_keys = false;            ///< something was typed since the mouse moved last: what is under it says nothing
    bool reveals_caret = false;           ///< scroll so that the caret is seen
    float foot = 0;                       ///< height of what is said below the text
    NodeId revealed{};                    ///< selection that the panel has scrolled to
    std::optional<std::size_t> wanted{};  ///< a place to go to
};

/// What a few letters find, and which of it Enter takes.
struct CommandPalette {
    bool open = false;
    std::string query{};
    std::vector<Command> commands{};
    std::vector<FoundCommand> found{};
    std::size_t chosen = 0;       ///< among `found`
    bool begins = false;          ///< the text field must take the keyboard in the next frame
    bool has_keyboard = false;    ///< it has it
    bool cursor_waits = false;    ///< until it has, to be put behind the text
    std::string early{};          ///< typed in this frame, in which it has not
    bool reveals_chosen = false;  ///< scroll so that it is seen
};

/// A length being typed beside its label.
struct TypedLength {
    std::string text{};
    bool active = false;
    bool begins = false;  ///< the text field must take the keyboard in the next frame
};

/// The hand of the underlay's tool. Places are of the picture's own frame.
struct UnderlayHand {
    std::vector<Vec2> points{};  ///< at most two, whose distance is known
    bool wants_distance = false; ///< it is to be typed now
    TypedLength width{}, distance{};
    bool pressing = false, dragging = false;
    Underlay before{};           ///< when the button went down
    Vec2 pressed_at{0, 0};       ///< window pixels
    int point = -1;              ///< in the hand; -1: the picture is
    Vec2 point_before{0, 0};
};

struct Ui {
    Theme theme;
    bool problems_open = false;
    std::size_t problems_seen = 0;

    NodeId hovered;         ///< under the mouse, in the viewport or the hierarchy
    NodeId revealed;        ///< selection that the hierarchy has scrolled to
    std::string filter;     ///< of the hierarchy

    NodeDrag drag;
    Palette palette;
    std::size_t history_seen = 0;                      ///< steps done when the history was drawn last: it scrolls to where they end
    int starter = 0;             ///< chosen of the tables to begin with
    Magnets magnets;
    GuideHand guide_hand;
    std::optional<Measurement> measurement;  ///< with the measure tool
    bool measuring = false;                  ///< its end follows the mouse
    UnderlayHand underlay;
    TransformDrag transform;
    Handles handles;
    HandleDrag handle_drag;
    double param_before = 0;  ///< what the param was when its slider was taken
    Hit pressed;            ///< under the mouse when its button went down; becomes a drag once it moves
    Vec2 pressed_at{0, 0};  ///< world
    bool double_click = false;
    bool pressing = false;  ///< the left button went down over the table and is still held
    bool copies = false;    ///< the drag is of copies (Alt)
    bool marquee = false;   ///< a box is being drawn from pressed_at
    Vec2 menu_at{0, 0};     ///< window pixels, where the right button went down
    std::vector<NodeId> under_mouse;  ///< what the node menu was opened over
    bool panning = false;
    bool viewport_hovered = false;
    Vec2 mouse{0, 0};       ///< window pixels, with the fractions that Dear ImGui drops
    Vec2 mouse_world{0, 0};

    Scrub scrub;
    Typing typing;
    std::vector<TabStop> tab_stops;     ///< as they were drawn in this frame
    std::optional<TabStop> tabbed_from;  ///< Tab was pressed there in this frame
    bool tabs_back = false;              ///< with Shift
    std::optional<TabStop> types_at;     ///< to be typed from the next frame on
    int open_menu = -1;  ///< of the menu bar, in this frame; -1: none
    int menu_way = 0;    ///< 1: Right was pressed in this frame, -1: Left
    Renaming renaming;
    SourcePanel source;
    CommandPalette commands;
    NodeId menu_node;       ///< row of the tree whose menu is to open
    PathDialog dialog;
    ListsDialog lists;
    int answer = 0;         ///< the button of a question that Enter presses
    int preference = 0;     ///< the row of the preferences that arrows change
    bool frame_wanted = true;  ///< show the whole table in the next frame
};

/// Shows why an edit did not happen; one that did ends what was said of a problem.
inline void tell(AppState& state, const std::optional<std::string>& problem) {
    if (problem) say(state, *problem, true);
    else forget_problem(state);
}

/// Does a text field, or the source, have the keyboard?
inline bool is_typing(const AppState& state, const Ui& ui) {
    return ImGui::GetIO().WantTextInput || ui.typing.field >= 0 || ui.types_at || ui.renaming.node || ui.source.focused || state.type_source;
}

/// Is a menu open, or a list of choices? What asks is none.
inline bool menu_is_open(const AppState& state) {
    return !asks(state) && ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

/// The picture and the color for a node's kind; records by their key.
Icon icon_of(const NodeType& type);
Tint color_of(const NodeType& type);
/// The author's id, else the type's word.
std::string title_of(const Node& node);
/// "48 \u00d7 20 mm", and "at 250, 700" where its middle is; empty of what has no end.
std::string size_in_words(const Box2& box);
std::string place_in_words(const Box2& box);

/// What is wrong: in what is being typed, in the file and, when that reads without an error, in making it run.
struct Problems {
    Diagnostics in_draft, in_file, in_program;
    std::size_t of_table() const { return in_file.size() + in_program.size(); }
    std::size_t count() const { return in_draft.size() + of_table(); }
    bool any_error() const { return has_errors(in_draft) || has_errors(in_file) || has_errors(in_program); }
};
Problems problems_of(const AppState& state);

/// What the mouse does over the table, which is the last item; and the end of it (Esc): whether there was a drag.
void table_mouse(AppState& state, Ui& ui);
bool cancel_drag(AppState& state, Ui& ui);

/// A picture as large as fits a place.
void draw_picture(ImDrawList& list, const Picture& picture, ImVec2 place, ImVec2 size, ImU32 color, float width);
/// What is dragged out of the palette follows the mouse and is added where it is let go over the table.
void carry_from_palette(AppState& state, Ui& ui);

/// What nodes may come in line with: other nodes, axes of mirrors, guides.
std::vector<Box2> magnets_for(const AppState& state, const std::vector<NodeId>& nodes);
inline constexpr double snap_pixels = 5;

// Handles of the selected node: found anew when it changed; under the mouse (-1: none); taken hold of; dragged; drawn.
void look_for_handles(const AppState& state, Ui& ui);
int handle_under_mouse(const AppState& state, const Ui& ui);
bool press_handle(AppState& state, Ui& ui);
void drag_handle(AppState& state, Ui& ui);
void draw_handles(const AppState& state, const Ui& ui, ImDrawList& list);

// Rows of menus: an action; what can be added; what the selection can be put into; all that can be done with the selected nodes.
void action_item(AppState& state, const Theme& theme, std::string_view name);
void add_menu(AppState& state, const Theme& theme);
void wrap_menu(AppState& state, const Theme& theme);
void node_menu(AppState& state, Ui& ui);

// Each draws its part of the window at a place, in screen pixels.
float menu_bar(AppState& state, Ui& ui);  ///< returns its height
void hierarchy_panel(AppState& state, Ui& ui, ImVec2 position, ImVec2 size);
/// The params of the table as sliders, below what is selected.
void param_rows(AppState& state, Ui& ui);
void inspector_panel(AppState& state, Ui& ui, ImVec2 position, ImVec2 size);
void history_panel(AppState& state, Ui& ui, ImVec2 position, ImVec2 size);
void viewport_panel(AppState& state, Ui& ui, ImVec2 position, ImVec2 size);
void palette_panel(AppState& state, Ui& ui, ImVec2 position, ImVec2 size);
void transport_bar(AppState& state, Ui& ui, ImVec2 position, ImVec2 size);
void source_panel(AppState& state, Ui& ui, ImVec2 position, ImVec2 size);
void problems_panel(AppState& state, Ui& ui, ImVec2 position, ImVec2 size);
void status_bar(AppState& state, Ui& ui, ImVec2 position, ImVec2 size);
void path_dialog(AppState& state, Ui& ui);
void prompt_dialog(AppState& state, Ui& ui);
void recovery_dialog(AppState& state, Ui& ui);
void merge_dialog(AppState& state, Ui& ui);
void shared_dialog(AppState& state, Ui& ui);
void home_dialog(AppState& state, Ui& ui);
void lists_dialog(AppState& state, Ui& ui);
void starter_dialog(AppState& state, Ui& ui);
void command_palette(AppState& state, Ui& ui);
void shortcut_sheet(AppState& state, Ui& ui);
void preferences_dialog(AppState& state, Ui& ui);

/// All of them, laid out in the window.
void draw_panels(AppState& state, Ui& ui);

}  // namespace pinfield::editor
