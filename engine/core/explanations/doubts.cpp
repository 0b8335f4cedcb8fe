// W05xx: what reads and runs, and is hardly what was meant. E06xx: files that are not tables.
#include "engine/core/explanations.h"

namespace pinfield {
namespace {

constexpr Explanation all[] = {
    {Code::empty_scene,
     "The table has no scene, or nothing in it: there is nothing to see or to hit but its edge.",
     "pinfield: 1\ntable: {name: Empty}\n",
     "pinfield: 1\ntable: {name: A disc}\nscene: [circle: {}]\n"},
    {Code::unknown_keyboard_key,
     "An input listens to keys, and no keyboard has one of this name. Letters are A to Z, digits Key0 to Key9, others have names such as "
     "Space, LeftShift, Slash and Left.",
     "pinfield: 1\nscene: [circle: {}]\ninputs: {left: [LShift]}\n",
     "pinfield: 1\nscene: [circle: {}]\ninputs: {left: [LeftShift]}\n"},
    {Code::offset_of_bound,
     "round, inset and onion move along the distance of their child. That of this child is a bound only, less than the true one, and its "
     "boundary could not be found: the walls come out thinner or thicker than written. Offset what can be traced, or the pieces of it.",
     "", ""},
    {Code::idle_field,
     "The field does nothing beside the node's other values: children take the place of a part's own shape, and steps are for the families "
     "of blends that have some. Leave it out, or what it stands beside.",
     "- bumper: {radius: 2cm, at: [0.3, 0.5], children: [box: {}]}\n",
     "- bumper: {at: [0.3, 0.5], children: [box: {}]}\n"},
    {Code::untouched_layer,
     "No ball is ever on this solid's layer, so none ever hits it. Most often the layer is misspelt.",
     "- spawn: {at: [0.26, 0.5], layer: [ramp]}\n- circle: {at: [0.1, 0.5], layer: [rmap]}\n",
     "- spawn: {at: [0.26, 0.5], layer: [ramp]}\n- circle: {at: [0.1, 0.5], layer: [ramp]}\n"},
    {Code::start_in_solid,
     "A ball would overlap something solid where it starts. The game holds it back until there is room: for ever, where a wall is there. The "
     "hint tells the nearest free place.",
     "- circle: {id: rock, at: [0.26, 0.5], radius: 5cm}\n- spawn: {at: [0.26, 0.5]}\n",
     "- circle: {id: rock, at: [0.26, 0.5], radius: 5cm}\n- spawn: {at: [0.26, 0.6]}\n"},
    {Code::start_outside,
     "A ball is to start where the domain, or the table's size, says that none may be.",
     "- domain: {children: [circle: {at: [0.26, 0.5], radius: 0.2}]}\n- spawn: {at: [3cm, 3cm]}\n",
     "- domain: {children: [circle: {at: [0.26, 0.5], radius: 0.2}]}\n- spawn: {at: [0.26, 0.5]}\n"},
    {Code::start_in_drain,
     "A ball would drain in the moment it starts.",
     "- spawn: {at: [0.26, 4cm]}\n- drain: {at: [0.26, 4cm], size: [0.1, 4cm]}\n",
     "- spawn: {at: [0.26, 0.5]}\n- drain: {at: [0.26, 4cm], size: [0.1, 4cm]}\n"},
    {Code::ball_too_large,
     "There is no place on the whole table where a ball of this size fits. A pinball has a radius of 13.5 mm.",
     "pinfield: 1\ntable: {size: [0.5, 1]}\nphysics: {ball_radius: 0.3}\nscene: [spawn: {at: [0.25, 0.5]}]\n",
     "pinfield: 1\ntable: {size: [0.5, 1]}\nphysics: {ball_radius: 13.5mm}\nscene: [spawn: {at: [0.25, 0.5]}]\n"},
    {Code::pocket,
     "A slow ball comes to rest here, and no flipper or plunger gets it out: the game would wait for ever. Turn a level top by two degrees, "
     "or close the gap that a ball lies in. Told by `check --pockets` only.",
     "- box: {size: [20cm, 2cm], at: [0.26, 0.5]}\n- spawn: {at: [0.26, 0.6]}\n- drain: {at: [0.26, 2cm], size: [0.52, 4cm]}\n",
     "- box: {size: [20cm, 2cm], at: [0.26, 0.5], turn: 2}\n- spawn: {at: [0.26, 0.6]}\n- drain: {at: [0.26, 2cm], size: [0.52, 4cm]}\n"},
    {Code::empty_solid,
     "Nothing is left of this solid: all of it was cut away, or what is common to its children is nowhere. Balls pass through where it was "
     "meant to be.",
     "- intersection:\n    children: [circle: {at: [0.1, 0.5], radius: 5cm}, circle: {at: [0.4, 0.5], radius: 5cm}]\n",
     "- union:\n    children: [circle: {at: [0.1, 0.5], radius: 5cm}, circle: {at: [0.4, 0.5], radius: 5cm}]\n"},
    {Code::no_boundary,
     "The solid's outline has too much detail to be found within what compiling may cost. Balls meet its formula instead: none passes, but "
     "its distance is a bound, and its corners may be off. Make its waves longer, or cut the solid into several.",
     "- displace: {at: [0.26, 0.5], amplitude: 6mm, wavelength: [40mm, 40mm], children: [circle: {radius: 0.2}]}\n",
     "- displace: {at: [0.26, 0.5], amplitude: 3mm, wavelength: [40mm, 40mm], children: [circle: {radius: 5cm}]}\n"},
    {Code::unused_param,
     "Nothing in the table depends on this param: often the name that was meant to stand for it is written as a number still.",
     "pinfield: 1\nparams: {gap: 46mm}\nscene: [circle: {radius: 46mm}]\n",
     "pinfield: 1\nparams: {gap: 46mm}\nscene: [circle: {radius: gap}]\n"},
    {Code::unused_template,
     "Nothing in the table uses this template, so that its nodes are nowhere, and what is wrong in it is not told.",
     "pinfield: 1\ntemplates: {gear: {nodes: [circle: {}]}}\nscene: [circle: {}]\n",
     "pinfield: 1\ntemplates: {gear: {nodes: [circle: {}]}}\nscene: [use: {template: gear}]\n"},

    {Code::unknown_step,
     "Scripts drive `pinfield-editor --script`. A step is a map with one key, and none is called this.",
     "- clik: {on: Play}\n",
     "- click: {on: Play}\n"},
};

}  // namespace

std::span<const Explanation> doubt_explanations() { return all; }

}  // namespace pinfield
