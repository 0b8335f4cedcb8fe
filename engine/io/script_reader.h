// Scripts that drive the editor: a YAML list of steps, read as strictly as a table.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "engine/core/diagnostic.h"
#include "engine/core/geometry.h"
#include "engine/io/limits.h"

namespace pinfield {

/// Where a hand goes: a place on the table in metres, or words on the screen, anywhere or in one of its panels.
struct ScriptPoint {
    std::optional<Vec2> place;
    std::string words;
    std::string panel;  ///< {palette: star}: hierarchy, palette, inspector ...
};

struct ScriptStep {
    enum class Kind : unsigned char {
        action,
        set,
        insert,
        paste,
        remove,
        move,
        wrap,
        unwrap,
        rename,
        select,
        click,
        drag,
        scroll,
        type,
        key,
        wait,
        screenshot,
        expect
    };
    Kind kind = Kind::wait;
    std::string name;           ///< action: its name; screenshot: a path; key: the key's name; wrap: a type; rename: the new id
    std::vector<std::string> nodes;  ///< select, remove, wrap, unwrap
    std::string node, field;    ///< set, expect, move, rename
    std::string parent;         ///< insert, move: empty for the top level
    int index = -1;             ///< insert, move: -1 for the end
    std::string value;          ///< set, expect: as written, for the field to read: "30mm", "[0.2, 0.3]"; insert, paste: YAML; type: what
    std::string tolerance;      ///< expect: as written, in the field's unit; empty: exactly
    ScriptPoint from, to;       ///< drag; of a click and a scroll the first
    std::string button = "left";     ///< click, drag: left, right, middle
    std::vector<std::string> with;   ///< click, drag, key: keys held meanwhile
    int times = 1;              ///< click: 2 is a double click
    double by = 0;              ///< scroll: notches, up is positive
    int ticks = 0;              ///< key: how long it is held; wait
    Place where{};
};

/// The word that a step begins with.
std::string_view word_of(ScriptStep::Kind kind);

struct Script {
    std::vector<ScriptStep> steps;
    Diagnostics diagnostics;  ///< the steps are fit to run when none is an error
};

Script read_script(const SourceText& source, const Limits& limits = {});

}  // namespace pinfield
