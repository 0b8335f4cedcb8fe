// E03xx: names that refer to something. E04xx: what is designed and not there yet.
#include "engine/core/explanations.h"

namespace pinfield {
namespace {

constexpr Explanation all[] = {
    {Code::unknown_material,
     "The table's `materials:` has none of this name. `default` is always there.",
     "pinfield: 1\nmaterials: {rubber: {}}\nscene: [circle: {material: ruber}]\n",
     "pinfield: 1\nmaterials: {rubber: {}}\nscene: [circle: {material: rubber}]\n"},
    {Code::unknown_input,
     "Flippers and plungers listen to inputs, and the table's `inputs:` says which keys each has. None has this name.",
     "pinfield: 1\nscene: [flipper: {input: [lefft]}]\ninputs: {left: [Z]}\n",
     "pinfield: 1\nscene: [flipper: {input: [left]}]\ninputs: {left: [Z]}\n"},
    {Code::duplicate_id,
     "An id is one thing's name in the whole file, inputs and what stands in operators included: tests, events and the editor find it by "
     "that.",
     "- bumper: {id: pop}\n- bumper: {id: pop, at: [10cm, 0]}\n",
     "- bumper: {id: pop_left}\n- bumper: {id: pop_right, at: [10cm, 0]}\n"},
    {Code::unknown_quantity,
     "A test compares what is counted: `escaped`, `drained`, `max penetration`, and ID.hits of what can be hit. What could only ever be 0 is "
     "refused, too: nothing hits a spawn.",
     "pinfield: 1\nscene: [bumper: {id: pop}]\ntests: [{expect: [pop.hit >= 0]}]\n",
     "pinfield: 1\nscene: [bumper: {id: pop}]\ntests: [{expect: [pop.hits >= 0]}]\n"},
    {Code::unknown_name,
     "An expression calls numbers by name: the table's `params:`, in a template its arguments, in copies `i`. None of them is called this "
     "here. Texts are called with a $ before their name.",
     "pinfield: 1\nparams: {gap: 46mm}\nscene: [circle: {radius: gap}, circle: {radius: gab / 2}]\n",
     "pinfield: 1\nparams: {gap: 46mm}\nscene: [circle: {radius: gap}, circle: {radius: gap / 2}]\n"},
    {Code::unknown_template,
     "The table's `templates:` has none of this name.",
     "pinfield: 1\ntemplates: {gear: {nodes: [circle: {}]}}\nscene: [use: {template: gear}, use: {template: geer}]\n",
     "pinfield: 1\ntemplates: {gear: {nodes: [circle: {}]}}\nscene: [use: {template: gear}, use: {template: gear}]\n"},
    {Code::unknown_argument,
     "A use gives the template what it does not take: what it takes stands under its `args:`.",
     "pinfield: 1\ntemplates: {gear: {args: {r: 1cm}, nodes: [circle: {radius: r}]}}\nscene: [use: {template: gear, with: {radius: 2cm}}]\n",
     "pinfield: 1\ntemplates: {gear: {args: {r: 1cm}, nodes: [circle: {radius: r}]}}\nscene: [use: {template: gear, with: {r: 2cm}}]\n"},
    {Code::unreadable_include,
     "No file goes by this path, or it is none that can be read: a folder, a pipe, one without permission, a link out of the table's folder. "
     "Paths count from the folder of the file that says them.",
     "pinfield: 1\ninclude: [parts/wals.yaml]\nscene: [circle: {}]\n",
     "pinfield: 1\ninclude: [parts/walls.yaml]\nscene: [circle: {}]\n"},

    {Code::motion_unsupported,
     "Numbers that move by themselves are designed, and this version does not have them yet. Flippers and plungers move at an input.",
     "- circle: {turn: {spin: 60}}\n",
     "- circle: {turn: 60}\n"},
    {Code::game_unsupported,
     "Scores, balls and modes as data are designed, and this version does not have them yet. Tables play without; hits are counted.",
     "pinfield: 1\nscene: [circle: {}]\ngame: {balls: 3}\n",
     "pinfield: 1\nscene: [circle: {}]\n"},
};

}  // namespace

std::span<const Explanation> reference_explanations() { return all; }

}  // namespace pinfield
