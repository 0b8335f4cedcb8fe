// The table that File > New begins with: small, playable, and worth reading.
#pragma once
#include <string_view>

namespace pinfield::editor {

inline constexpr std::string_view starter_table = R"(# A new table: metres, degrees, y up, origin at the bottom left.
pinfield: 1
table: {name: New table, size: [0.52, 1.06], slope: 6.5}

materials:
  rubber: {restitution: 0.8, falloff: 0.35, friction: 0.55, color: crimson}

scene:
  # Where balls may be; everything outside is solid.
  - domain: {children: [box: {size: [0.48, 1.02], round: 60mm, at: [0.26, 0.53]}]}
  - bumper: {id: pop, at: [0.27, 0.75], radius: 24mm, material: rubber}
  - flipper: {id: flip_left, at: [0.17, 0.14], rest: -30, swing: 51, input: [left], material: rubber}
  - flipper: {id: flip_right, at: [0.35, 0.14], rest: -30, swing: 51, flip: x, input: [right], material: rubber}
  - spawn: {id: start, at: [0.22, 0.90]}
  - drain: {id: drain, at: [0.26, 0.035], size: [0.40, 30mm]}

inputs: {left: [Z, LeftShift], right: [Slash, RightShift]}
)";

}  // namespace pinfield::editor
