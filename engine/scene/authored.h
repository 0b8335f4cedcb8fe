// What a table says once and uses often: its params, and where nodes come from that a template or `copies` made.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "engine/core/source_text.h"
#include "engine/core/units.h"

namespace pinfield {

/// A number as its author wrote it, and what it comes to: in m, deg, s, kg and what they make.
struct WrittenQuantity {
    double value = 0;
    std::string text;
};

/// A number of the table's own that expressions call by its name; in the editor, a slider.
struct Param {
    std::string name;
    WrittenQuantity value;
    std::optional<WrittenQuantity> min, max, step;
    Dimension dimension{};
    bool is_bare = true;         ///< no unit is in it: as a plain number it may stand for any
    bool is_calculated = false;  ///< it follows other params: no hand moves it
    std::string label, unit;     ///< as the author wrote them; may be empty
    Place where{};               ///< its name
    Place value_where{};
};

bool same_param(const Param& a, const Param& b);

/// Why a node is there that has no lines of its own: each step from the template or copy that made it out to the author's own item.
struct Origin {
    std::string what;  ///< "the template gear", "copy 2 of pop"
    Place where;       ///< the word that asks for it: `use`, `copies`, `pair`
    std::shared_ptr<const Origin> outer;
};

/// What makes the children of a group: an item that says `use`, `copies` or `pair`.
struct Generator {
    std::string item;      ///< as a line: "- use: {template: gear}"
    bool is_group = true;  ///< the group's fields are those of the item; else they are those of what is copied
};

}  // namespace pinfield
