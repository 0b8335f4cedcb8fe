// Scripts that drive the editor: a YAML list of steps, read as strictly as a table.
#pragma once
#include <string>
#include <vector>

#include "engine/core/diagnostic.h"
#include "engine/core/geometry.h"
#include "engine/io/limits.h"

namespace pinfield {

struct ScriptStep {
    enum class Kind : unsigned char { action, set, drag, key, wait, select, screenshot, expect };
    Kind kind = Kind::wait;
    std::string name;           ///< action: its name; select: a node; screenshot: a path; key: the key's name
    std::string node, field;    ///< set, expect
    std::string value;          ///< set, expect: as written, for the field to read: "30mm", "[0.2, 0.3]"
    std::string tolerance;      ///< expect: as written, in the field's unit; empty: exactly
    Vec2 from{0, 0}, to{0, 0};  ///< drag: metres, table coordinates
    int ticks = 0;              ///< key: how long it is held; wait
    Place where{};
};

struct Script {
    std::vector<ScriptStep> steps;
    Diagnostics diagnostics;  ///< the steps are fit to run when none is an error
};

Script read_script(const SourceText& source, const Limits& limits = {});

}  // namespace pinfield
