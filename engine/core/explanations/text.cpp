// E01xx: the text itself, and what it may cost.
#include "engine/core/explanations.h"

namespace pinfield {
namespace {

constexpr Explanation all[] = {
    {Code::empty_file,
     "A table is a map with at least the version of its format. A file of blanks and comments holds nothing, and so does one that an editor "
     "has made and not written yet.",
     "# only a comment\n",
     "pinfield: 1\nscene: [circle: {}]\n"},
    {Code::not_utf8,
     "Tables are UTF-8, with or without a byte order mark. Old programs write Latin-1 or UTF-16: save the file as UTF-8 in your editor, or "
     "change it with `iconv -f latin1 -t utf-8`. There is no example, as a terminal could not show it.",
     "", ""},
    {Code::control_character,
     "Only line breaks and tabs are control characters that a text needs. Others (NUL, escape, a carriage return without a line feed) are "
     "invisible, and mean different things to different programs: take them out. There is no example, as a terminal would obey it.",
     "", ""},
    {Code::tab_indentation,
     "YAML counts columns, and a tab is as wide as the reader likes: it may stand between words, but never where a line begins. Let your "
     "editor write spaces.",
     "pinfield: 1\ntable:\n\tname: Moon\nscene: [circle: {}]\n",
     "pinfield: 1\ntable:\n  name: Moon\nscene: [circle: {}]\n"},
    {Code::yaml_syntax,
     "The text cannot be taken apart: a bracket or quote is open, or a text holds a colon and a blank, which make a key of it. The place is "
     "where reading stopped or the open thing began; the mistake may stand a line above.",
     "pinfield: 1\ntable:\n  name: Moon: the second\nscene: [circle: {}]\n",
     "pinfield: 1\ntable:\n  name: \"Moon: the second\"\nscene: [circle: {}]\n"},
    {Code::file_too_large,
     "A table is read only up to a size, so that no file can cost more time and memory than it is worth. A table this large was most likely "
     "generated: repeat, repeat_polar and mirror make many shapes of one. No few lines can show it.",
     "", ""},
    {Code::too_deep,
     "Maps and lists may stand within each other up to a depth, brackets counted too. Operators that hold one operator each add up: union "
     "takes any number of children. No few lines can show it.",
     "", ""},
    {Code::too_many_events,
     "The text has more keys, values and brackets than are read, whatever its size. repeat, repeat_polar and mirror make many shapes of one. "
     "No few lines can show it.",
     "", ""},
    {Code::scalar_too_long,
     "One name, number or text is longer than anybody writes: a quote that was never closed, perhaps. No few lines can show it.", "", ""},
    {Code::too_many_nodes,
     "The scene has more nodes than are read, those of aliases counted each time. repeat, repeat_polar and mirror make many shapes of one. "
     "No few lines can show it.",
     "", ""},
    {Code::too_many_points,
     "A list of points or words is longer than is read. A drawing that was traced has far more points than its shape needs: let the program "
     "it comes from simplify it, or write curves, as path has them. No few lines can show it.",
     "", ""},
    {Code::too_many_repeats,
     "Copies of a repetition are counted before they are made. repeat_infinite has no count and costs nothing.",
     "- repeat_polar: {count: 100000, children: [circle: {radius: 2mm, at: [5cm, 0]}]}\n",
     "- repeat_polar: {count: 12, children: [circle: {radius: 2mm, at: [5cm, 0]}]}\n"},
    {Code::cyclic_alias,
     "An alias (*name) stands for what its anchor (&name) marks. Inside of that it would stand for itself, for ever.",
     "- &ring\n  union: {children: [circle: {}, *ring]}\n",
     "- union: {children: [&disc {circle: {}}, *disc]}\n"},
    {Code::alias_bomb,
     "Aliases within aliases grow by their product: ten of ten of ten are a thousand. Counted as written out, these are more than the limits "
     "allow.",
     "- &a {union: {children: [circle: {}, circle: {}, circle: {}, circle: {}, circle: {}, circle: {}, circle: {}, circle: {}]}}\n"
     "- &b {union: {children: [*a, *a, *a, *a, *a, *a, *a, *a]}}\n"
     "- &c {union: {children: [*b, *b, *b, *b, *b, *b, *b, *b]}}\n"
     "- &d {union: {children: [*c, *c, *c, *c, *c, *c, *c, *c]}}\n"
     "- &e {union: {children: [*d, *d, *d, *d, *d, *d, *d, *d]}}\n"
     "- &f {union: {children: [*e, *e, *e, *e, *e, *e, *e, *e]}}\n",
     "- &a {union: {children: [circle: {}, circle: {at: [3cm, 0]}]}}\n- repeat: {count: [8, 8], step: [10cm, 10cm], children: [*a]}\n"},
    {Code::duplicate_key,
     "YAML would silently take one of the two. Which one was meant is for you to say: delete the other. Sections, too, stand once.",
     "- circle: {radius: 3cm, radius: 4cm}\n",
     "- circle: {radius: 4cm}\n"},
    {Code::merge_key,
     "`<<` copies keys from elsewhere, which many YAML programs do and the standard no longer does. Plain anchors and aliases work: give the "
     "whole a name, or write the fields out.",
     "pinfield: 1\nmaterials:\n  rubber: &rubber {restitution: 0.8}\n  post: {<<: *rubber}\nscene: [circle: {}]\n",
     "pinfield: 1\nmaterials:\n  rubber: &rubber {restitution: 0.8}\n  post: *rubber\nscene: [circle: {}]\n"},
    {Code::tag,
     "`!word` is a type in YAML, and tables have none: a field knows what it takes. A text that begins with ! needs quotes.",
     "- circle: {radius: !mm 24}\n",
     "- circle: {radius: 24mm}\n"},
    {Code::several_documents,
     "`---` begins another document in YAML, and a file holds one table. Write each table into a file of its own.",
     "pinfield: 1\nscene: [circle: {}]\n---\npinfield: 1\nscene: [box: {}]\n",
     "pinfield: 1\nscene: [circle: {}]\n"},
    {Code::comment_ate_value,
     "A # after a blank begins a comment, so a color written bare is none. Quote it, or take a color's name.",
     "pinfield: 1\nmaterials:\n  goo:\n    color: #7c5\nscene: [circle: {}]\n",
     "pinfield: 1\nmaterials:\n  goo:\n    color: \"#7c5\"\nscene: [circle: {}]\n"},
    {Code::unknown_alias,
     "A value that begins with * is an alias and needs an anchor (&name) above it. There are no wildcards; where a text begins with *, quote "
     "it.",
     "- circle: {at: *middle}\n",
     "- circle: {at: &middle [10cm, 10cm]}\n- box: {at: *middle, size: [10cm, 1cm]}\n"},
    {Code::bad_key,
     "Keys are words. A list, a map or nothing where a key is due comes from brackets in the wrong place.",
     "- circle: {[radius]: 3cm}\n",
     "- circle: {radius: 3cm}\n"},
    {Code::too_many_errors,
     "Reading stops after very many errors, as most of them have one cause: mend the first ones and check again. No few lines can show it.",
     "", ""},
    {Code::expression_too_deep,
     "Brackets, signs and branches of an expression may stand within each other up to a depth. Calculate a part of it yourself and write the "
     "number. No few lines can show it.",
     "", ""},
    {Code::expression_too_long,
     "An expression has more numbers, names and operations than are read. Calculate a part of it yourself and write the number. No few lines "
     "can show it.",
     "", ""},
    {Code::too_many_params,
     "There are more params, or arguments of one template, than are read. No few lines can show it.",
     "", ""},
    {Code::too_many_includes,
     "The table and the files it includes name more files than are read. Put several into one. No few lines can show it.",
     "", ""},
    {Code::table_too_large,
     "The table and the files it includes have more bytes together than are read. No few lines can show it.",
     "", ""},
};

}  // namespace

std::span<const Explanation> text_explanations() { return all; }

}  // namespace pinfield
