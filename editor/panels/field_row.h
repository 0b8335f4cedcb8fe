// A row of the inspector from within: what every control needs to know, and the controls. Only fields.cpp and the controls include this.
#pragma once
#include <optional>
#include <string>
#include <utility>

#include "editor/panels/ui.h"
#include "engine/core/at.h"

namespace pinfield::editor {

struct Row {
    AppState& state;
    Ui& ui;
    const Node& node;        ///< the one that is shown
    const SharedField& all;  ///< its field first, then those of the others that change with it
    float width;             ///< of the control

    const Theme& theme() const { return ui.theme; }
    int index() const { return all.front().field; }
    const FieldType& field() const { return at(node.type->fields, index()); }
    const Value& value() const { return at(node.fields, index()).value; }
    bool is_explicit() const { return any_explicit(state.document.scene(), all); }
    bool mixed(int component = -1) const { return is_mixed(state.document.scene(), all, component); }
    /// One of the changes of shared_fields.h: says what it was, or why it was not.
    template <class Change, class... Arguments>
    void change(Change how, Arguments&&... arguments) const {
        const std::string label = change_label(state.document.scene(), all);
        const std::optional<std::string> why = how(state.document, all, std::forward<Arguments>(arguments)...);
        say(state, why.value_or(label), why.has_value());
    }
    void set(const Value& to, bool is_explicit = true) const { change(set_all, to, is_explicit); }
};

/// What stands for a value that is not the same in all nodes.
inline constexpr const char* mixed_word = "mixed";

/// The value, or one number of it (`component`), is typed from now on; and the text field that then stands in for its control.
void begin_typing(const Row& row, int component);
void typing_field(const Row& row, float width);
/// Tab comes by here; where it has come to it, the value is typed from now on.
void tab_stop(const Row& row, int component);

/// A number that is dragged sideways, or typed after a double click.
void number_control(const Row& row, int component, float width, const char* name = "");
void vec2_control(const Row& row, int first);
void points_control(const Row& row);
/// One word of few as buttons, of many as a list that opens.
void choice_control(const Row& row);
void choices_control(const Row& row);
/// Any value in the format's own spelling: a click lets it be typed.
void text_control(const Row& row, float width, const std::string& text, const char* hint);
/// Names of inputs as chips to switch on and off; other names as text.
void names_control(const Row& row);
/// The materials that there are, to choose from.
void material_control(const Row& row);

}  // namespace pinfield::editor
