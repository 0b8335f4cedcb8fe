#include "engine/io/starters.h"

#include <fmt/format.h>

#include "engine/io/text_patch.h"

namespace pinfield {
namespace {

constexpr std::string_view classic = R"(# A new table: metres, degrees, y up, origin at the bottom left.
pinfield: 1
table: {name: New table, size: [0.52, 1.06], slope: 6.5}
physics: {ball_inertia: sphere, ball_rolls: true, rolling_resistance: 0.002}   # a steel ball on lacquer, as in machines

materials:
  wall:   {restitution: 0.3, friction: 0.2, color: "#31435e"}
  rubber: {restitution: 0.8, falloff: 0.35, friction: 0.55, color: "#d9795d"}
  lamp:   {restitution: 0.8, falloff: 0.2, friction: 0.2, scatter: 3, color: "#f0b94a"}
  bat:    {restitution: 0.8, falloff: 0.43, friction: 0.6, color: "#f4ead2"}

scene:
  # Where balls may be; everything outside is solid.
  - domain: {id: cabinet, material: wall, children: [box: {size: [0.48, 1.02], round: 60mm, at: [0.26, 0.53]}]}

  - bumper: {id: pop, at: [0.24, 0.75], radius: 24mm, kick: 1, material: lamp}

  # The same on both sides: written for the left, x counted from the middle.
  - mirror:
      id: slings
      at: [0.26, 0]
      material: rubber
      children:
        - triangle: {a: [-150mm, 320mm], b: [-150mm, 240mm], c: [-105mm, 210mm]}
  - mirror:
      id: inlanes
      at: [0.26, 0]
      material: wall
      children:
        - path: {points: [[-200mm, 300mm], [-200mm, 205mm], [-103mm, 149mm]], pieces: [line], thickness: 8mm}

  - flipper: {id: flipper_left, at: [0.1655, 0.14], rest: -30, swing: 51, material: bat, input: [left]}
  - flipper: {id: flipper_right, at: [0.3545, 0.14], rest: 210, swing: -51, material: bat, input: [right]}
  - spawn: {id: start, at: [0.22, 0.90]}
  - drain: {id: drain, at: [0.26, 0.035], size: [0.40, 30mm]}

inputs: {left: [Z, LeftShift], right: [Slash, RightShift], plunge: [Space]}

tests:
  - {name: the ball falls onto the bumper, run: 2s, expect: [pop.hits >= 1, escaped == 0]}
  - {name: a ball between the flippers drains, launch: {at: [0.26, 0.3]}, run: 2s, expect: [drained == 1]}
)";

constexpr std::string_view blank = R"(# An empty table: metres, degrees, y up, origin at the bottom left.
pinfield: 1
table: {name: New table, size: [0.52, 1.06], slope: 6.5}
physics: {ball_inertia: sphere, ball_rolls: true, rolling_resistance: 0.002}   # a steel ball on lacquer, as in machines

scene:
  # Where balls may be; everything outside is solid.
  - domain: {id: cabinet, children: [box: {size: [0.48, 1.02], at: [0.26, 0.53]}]}

inputs: {left: [Z, LeftShift], right: [Slash, RightShift], plunge: [Space]}
)";

constexpr std::string_view fan = R"(# Shots that fan out from the flippers: metres, degrees, y up, origin at the bottom left.
pinfield: 1
table: {name: New table, size: [0.52, 1.06], slope: 6.5}
physics: {ball_inertia: sphere, ball_rolls: true, rolling_resistance: 0.002}   # a steel ball on lacquer, as in machines

materials:
  wall:   {restitution: 0.3, friction: 0.2, color: "#31435e"}
  rail:   {restitution: 0.35, friction: 0.1, color: "#8fa9c4"}
  rubber: {restitution: 0.8, falloff: 0.35, friction: 0.55, color: "#d9795d"}
  lamp:   {restitution: 0.8, falloff: 0.2, friction: 0.2, scatter: 3, color: "#f0b94a"}
  bat:    {restitution: 0.8, falloff: 0.43, friction: 0.6, color: "#f4ead2"}

scene:
  # Where balls may be: a hall with an arch. Everything outside is solid.
  - domain:
      id: cabinet
      material: wall
      children:
        - box: {size: [0.48, 0.78], at: [0.26, 0.41]}
        - circle: {radius: 0.24, at: [0.26, 0.80]}

  # The plunger lane, open under the arch.
  - box: {id: lane, size: [8mm, 0.76], at: [0.456, 0.38], material: rail}
  - plunger: {id: plunger, at: [0.48, 80mm], size: [32mm, 60mm], speed: 3, material: rail, input: [plunge]}
  - spawn: {id: start, at: [0.48, 94mm]}

  # The fan: lanes between rails that all point at the space between the flippers.
  - group:
      id: fan
      at: [0.236, 0.14]
      children:
        - capsule: {length: 90mm, radius: 5mm, at: [-168mm, 462mm], turn: 110, material: rail}
        - capsule: {length: 90mm, radius: 5mm, at: [-86mm, 485mm], turn: 100, material: rail}
        - capsule: {length: 90mm, radius: 5mm, at: [0, 492mm], turn: 90, material: rail}
        - capsule: {length: 90mm, radius: 5mm, at: [86mm, 485mm], turn: 80, material: rail}
        - capsule: {length: 90mm, radius: 5mm, at: [168mm, 462mm], turn: 70, material: rail}

  # Throws balls that come round the arch down at the bumpers.
  - circle: {id: post, at: [0.159, 1.018], radius: 14mm, material: rubber}

  - bumper: {id: pop_left, at: [0.16, 0.80], radius: 24mm, kick: 1, material: lamp}
  - bumper: {id: pop_right, at: [0.33, 0.80], radius: 24mm, kick: 1, material: lamp}
  - bumper: {id: pop_top, at: [0.245, 0.91], radius: 24mm, kick: 1, material: lamp}

  # The same on both sides: written for the left, x counted from the middle of the playfield.
  - mirror:
      id: slings
      at: [0.236, 0]
      material: rubber
      children:
        - triangle: {a: [-137mm, 320mm], b: [-137mm, 240mm], c: [-95mm, 210mm]}
  - mirror:
      id: inlanes
      at: [0.236, 0]
      material: rail
      children:
        - path: {points: [[-184mm, 300mm], [-184mm, 200mm], [-99mm, 144mm]], pieces: [line], thickness: 8mm}

  - flipper: {id: flipper_left, at: [0.1445, 0.13], rest: -30, swing: 51, material: bat, input: [left]}
  - flipper: {id: flipper_right, at: [0.3275, 0.13], rest: 210, swing: -51, material: bat, input: [right]}
  - drain: {id: drain, at: [0.236, 0.035], size: [0.40, 30mm]}

inputs: {left: [Z, LeftShift], right: [Slash, RightShift], plunge: [Space]}

tests:
  - {name: a full pull goes round the arch to the post, inputs: {plunge: [0.2s, 1s]}, run: 4s, expect: [post.hits >= 1, escaped == 0]}
  - {name: a ball between the flippers drains, launch: {at: [0.236, 0.3]}, run: 2s, expect: [drained == 1]}
)";

constexpr std::string_view homework = R"(# One ball among obstacles: falling, bouncing, and where the energy goes. Metres, degrees, y up.
pinfield: 1
table: {name: Bouncing ball, size: [1, 1], slope: 90}

physics: {integrator: symplectic_euler, ball_radius: 25mm}

materials:
  # restitution is what an impact leaves of the normal speed: 1 keeps the energy, 0 sticks.
  default: {restitution: 0.9, friction: 0}

scene:
  - domain: {id: room, children: [box: {size: [0.96, 0.96], at: [0.5, 0.5]}]}
  - circle: {id: disc, at: [0.3, 0.6], radius: 80mm}
  - box: {id: block, at: [0.7, 0.65], size: [0.2, 60mm], turn: -20}
  - segment: {id: slope, a: [0.15, 0.40], b: [0.5, 0.25], thickness: 20mm}
  - difference:
      id: bowl
      at: [0.7, 0.3]
      children:
        - box: {size: [0.3, 0.2]}
        - circle: {radius: 0.12, at: [0, 0.1]}
  - spawn: {id: ball, at: [0.32, 0.9], velocity: [0.2, 0]}

tests:
  - {name: it falls onto the disc and goes on, run: 5s, expect: [disc.hits >= 1, slope.hits >= 1, escaped == 0]}
)";

constexpr Starter all[] = {
    {"classic", "Classic", "Two flippers, slings and a bumper: played at once.", classic},
    {"fan", "Fan", "An arch, a plunger and lanes that fan out from the flippers.", fan},
    {"homework", "Bouncing ball", "One ball and some obstacles: for CS248B and for trying things.", homework},
    {"blank", "Blank", "Four walls.", blank},
};

}  // namespace

std::span<const Starter> starters() { return all; }

std::string modeline(std::string_view schema) { return fmt::format("# yaml-language-server: $schema={}\n", schema); }

Result<std::string> new_table(const Starter& starter, const std::string& name, std::string_view schema, std::shared_ptr<const Catalog> catalog) {
    const std::string text = modeline(schema) + std::string(starter.text);
    const Reading reading = read_table(std::make_shared<const SourceText>(std::string(starter.key), text), std::move(catalog));
    const Node& table = reading.scene.table();
    const Edit rename = SetField{table.id, *table.type->find_field("name"), name, true};
    auto named = patch_for(reading, std::span(&rename, 1));
    if (!named) return tl::make_unexpected(named.error());
    return named->reading.source().text();
}

}  // namespace pinfield
