// E02xx: keys, values, and what may stand where.
#include "engine/core/explanations.h"

namespace pinfield {
namespace {

constexpr Explanation all[] = {
    {Code::wrong_shape,
     "{key: value} is a map, [a, b] a list, a word or number a single value, and each field takes one of them: a radius is a number, a size "
     "a pair, children a list.",
     "- box: {size: 3cm}\n",
     "- box: {size: [3cm, 3cm]}\n"},
    {Code::unknown_key,
     "No section, field or quantity of this name stands here. Nothing is skipped, as a misspelt field would silently do nothing. `pinfield "
     "nodes KEY` lists the fields of a node.",
     "- circle: {radious: 3cm}\n",
     "- circle: {radius: 3cm}\n"},
    {Code::unknown_node,
     "A node's key is its type, and there is none of this name. `pinfield nodes` lists all of them; what other programs call a target, a "
     "gate or a line has another name here, which the hint tells.",
     "- circel: {radius: 3cm}\n",
     "- circle: {radius: 3cm}\n"},
    {Code::missing_version,
     "A table says which version of the format it is written in, so that it loads for ever, whatever later versions change.",
     "scene: [circle: {}]\n",
     "pinfield: 1\nscene: [circle: {}]\n"},
    {Code::unknown_version,
     "This program reads the versions of the format up to its own. A table of a later one needs a later program.",
     "pinfield: 2\nscene: [circle: {}]\n",
     "pinfield: 1\nscene: [circle: {}]\n"},
    {Code::wrong_type,
     "The value is a word where a number is due, a fraction where a count is, or `yes` where true or false is.",
     "- circle: {visible: yes}\n",
     "- circle: {visible: true}\n"},
    {Code::missing_field,
     "Most fields have a default and may be left out; this one has none. A test, for one, without an expectation could not fail.",
     "pinfield: 1\nscene: [circle: {}]\ntests: [{run: 1s}]\n",
     "pinfield: 1\nscene: [circle: {}]\ntests: [{run: 1s, expect: [escaped == 0]}]\n"},
    {Code::out_of_range,
     "Every field has a range, which `pinfield nodes KEY` tells: radii and sizes lie above 0, a restitution between 0 and 1.",
     "- circle: {radius: -3cm}\n",
     "- circle: {radius: 3cm}\n"},
    {Code::broken_contract,
     "Each value lies in its range, but together they make no shape: a corner rounder than half its box, an inner radius beyond the outer. "
     "The message tells the relation that does not hold.",
     "- box: {size: [4cm, 2cm], round: 11mm}\n",
     "- box: {size: [4cm, 2cm], round: 10mm}\n"},
    {Code::malformed_number,
     "010 is eight to some programs and ten to others; 1_000, 1:30 and 0x10 are alike, and a blank parts a number from its unit. Write what "
     "nobody can misread.",
     "- circle: {radius: 3 cm}\n",
     "- circle: {radius: 3cm}\n"},
    {Code::not_finite,
     "Infinity and not-a-number have no place on a table. half_plane and repeat_infinite are shapes without an end.",
     "- box: {size: [inf, 1cm]}\n",
     "- half_plane: {}\n"},
    {Code::unknown_unit,
     "Lengths take um, mm, cm, m, in and ft, angles deg and rad, times ms and s; `pinfield nodes` lists all units. A bare number is metres, "
     "degrees, seconds.",
     "- circle: {radius: 3mmm}\n",
     "- circle: {radius: 3mm}\n"},
    {Code::wrong_dimension,
     "The unit measures something else than the field: a length where an angle is due. In an expression, numbers with units that do not "
     "agree are added, or the whole comes to another measure than is due.",
     "- circle: {turn: 30cm}\n",
     "- circle: {turn: 30deg}\n"},
    {Code::unknown_choice,
     "The field takes one of a few words, which the hint lists.",
     "- mirror: {across: z, children: [circle: {at: [5cm, 0]}]}\n",
     "- mirror: {across: x, children: [circle: {at: [5cm, 0]}]}\n"},
    {Code::unknown_color,
     "A color is a CSS name (crimson, gold), or three or six hexadecimal digits behind a #, quoted, as a bare # begins a comment.",
     "pinfield: 1\nmaterials: {goo: {color: crimsom}}\nscene: [circle: {}]\n",
     "pinfield: 1\nmaterials: {goo: {color: crimson}, moss: {color: \"#7c5\"}}\nscene: [circle: {}]\n"},
    {Code::missing_value,
     "A key stands alone where a value is due. To take the default, leave the key out, too.",
     "- circle: {radius: }\n",
     "- circle: {radius: 3cm}\n"},
    {Code::under_indented,
     "A node's fields stand deeper than its key. As far left as the key they belong to the list's item beside it, and the node is left "
     "empty. Indent them by two more.",
     "- circle:\n  radius: 3cm\n",
     "- circle:\n    radius: 3cm\n"},
    {Code::not_one_key,
     "A node is a map with exactly one key, its type. Two nodes are two items of the list.",
     "- circle: {radius: 3cm}\n  box: {size: [1cm, 1cm]}\n",
     "- circle: {radius: 3cm}\n- box: {size: [1cm, 1cm]}\n"},
    {Code::child_count,
     "Operators say how many children they take: complement and mirror one, difference at least one.",
     "- complement: {children: [circle: {}, box: {}]}\n",
     "- complement: {children: [union: {children: [circle: {}, box: {}]}]}\n"},
    {Code::misplaced_part,
     "Inside operators and parts are shapes only: what moves, drains or starts balls stands in the scene itself or in a group.",
     "- union: {children: [circle: {}, bumper: {at: [5cm, 0]}]}\n",
     "- circle: {}\n- bumper: {at: [5cm, 0]}\n"},
    {Code::second_domain,
     "The domain says where balls may be, and what is outside of it is solid. A second one would make its own outside solid, the first "
     "included. One domain takes any number of children, and each layer has its own.",
     "- domain: {children: [circle: {radius: 0.2}]}\n- domain: {children: [box: {size: [0.3, 0.3]}]}\n",
     "- domain: {children: [circle: {radius: 0.2}, box: {size: [0.3, 0.3]}]}\n"},
    {Code::bad_name,
     "Names are lower-case letters, digits and _, and do not begin with a digit: they stand in expressions and tests, where other signs mean "
     "something.",
     "- circle: {id: Pop-1}\n",
     "- circle: {id: pop_1}\n"},
    {Code::comma_split,
     "Within { } and [ ] a comma parts entries, also in the midst of an expression. Quote the expression.",
     "- circle: {radius: max(2cm, 3cm)}\n",
     "- circle: {radius: \"max(2cm, 3cm)\"}\n"},
    {Code::bad_expectation,
     "An expectation of a test is a quantity, one of == != < <= > >=, and a number.",
     "pinfield: 1\nscene: [circle: {}]\ntests: [{expect: [escaped = 0]}]\n",
     "pinfield: 1\nscene: [circle: {}]\ntests: [{expect: [escaped == 0]}]\n"},
    {Code::bad_expression,
     "A number may be calculated, with + - * / % ^, comparisons, `a if c else b`, and functions such as min, max, sqrt and sin. This one "
     "cannot be understood; its place is where understanding ended.",
     "- circle: {radius: 2cm ** 2}\n",
     "- circle: {radius: 2 ^ 2 * 1cm}\n"},
    {Code::no_value,
     "The expression can be understood, but comes to nothing here: a division by zero, a root of a negative number.",
     "- circle: {radius: 1cm / (2 - 2)}\n",
     "- circle: {radius: 1cm / 2}\n"},
};

}  // namespace

std::span<const Explanation> structure_explanations() { return all; }

}  // namespace pinfield
