#include "engine/io/other_words.h"

#include <algorithm>
#include <array>

namespace pinfield {
namespace {

struct Word {
    std::string_view theirs, hint;
};

constexpr std::string_view formula = "write formula: {distance: \"length(x, y) - 3cm\", bounds: [8cm, 8cm]}";

constexpr std::array nodes{
    Word{"target", "there are no targets yet; a box with an id is hit and counted as well: <id>.hits"},
    Word{"gate", "there are no gates yet; a ramp with a step behind it lets balls through one way"},
    Word{"sling", "there are no slings yet; a bumper takes a triangle as its child, and kicks"},
    Word{"slingshot", "there are no slings yet; a bumper takes a triangle as its child, and kicks"},
    Word{"spinner", "there are no spinners yet"},
    Word{"lane", "there are no lanes yet; segments or capsules make their guides"},
    Word{"hole", "there are no holes yet; a drain takes balls, and its spawn brings them back"},
    Word{"kicker", "there are no kickers yet; a bumper kicks, and a plunger shoots"},
    Word{"magnet", "there are no magnets yet"},
    Word{"lamp", "there are no lamps yet"},
    Word{"light", "there are no lamps yet"},
    Word{"mover", "there are no movers yet but flipper and plunger"},
    Word{"rotate", "every node has turn: degrees, counter-clockwise"},
    Word{"rotation", "every node has turn: degrees, counter-clockwise"},
    Word{"translate", "every node has at: [x, y]"},
    Word{"move", "every node has at: [x, y]"},
    Word{"transform", "every node has at, turn, scale and flip"},
    Word{"scale", "every node has scale: how many times as large"},
    Word{"flip", "every node has flip: x or y; mirror is the node and its reflection"},
    Word{"line", "write segment: {a: [x, y], b: [x, y], thickness: 8mm}"},
    Word{"wall", "write segment: {a: [x, y], b: [x, y], thickness: 8mm}, or box"},
    Word{"rail", "write segment: {a: [x, y], b: [x, y], thickness: 8mm}, or path for a bent one"},
    Word{"guide", "write segment: {a: [x, y], b: [x, y], thickness: 8mm}, or path for a bent one"},
    Word{"polyline", "write path: {points: [[x, y], ...], thickness: 8mm}"},
    Word{"curve", "write path, quadratic_bezier or cubic_bezier"},
    Word{"bezier", "write quadratic_bezier or cubic_bezier"},
    Word{"function", formula},
    Word{"equation", formula},
    Word{"expression", formula},
    Word{"implicit", formula},
    Word{"sdf", formula},
    Word{"metaballs", formula},
    Word{"rect", "write box: {size: [width, height]}"},
    Word{"rectangle", "write box: {size: [width, height]}"},
    Word{"square", "write box: {size: [side, side]}"},
    Word{"disc", "write circle: {radius: 3cm}"},
    Word{"disk", "write circle: {radius: 3cm}"},
    Word{"post", "write circle: {radius: 5mm}"},
    Word{"peg", "write circle: {radius: 5mm}"},
    Word{"subtract", "write difference: {children: [...]}: the first less the others"},
    Word{"subtraction", "write difference: {children: [...]}: the first less the others"},
    Word{"cut", "write difference: {children: [...]}: the first less the others"},
    Word{"add", "write union: {children: [...]}"},
    Word{"merge", "write union: {children: [...]}"},
    Word{"array", "write repeat: {count: [columns, rows], step: [x, y], children: [...]}"},
    Word{"ball", "balls start at a spawn: {at: [x, y]}"},
    Word{"start", "balls start at a spawn: {at: [x, y]}"},
    Word{"outhole", "write drain: {at: [x, y], size: [width, height]}"},
    Word{"bat", "write flipper"},
    Word{"launcher", "write plunger"},
    Word{"table", "table is a section beside scene"},
    Word{"material", "materials is a section beside scene; a node names its own: material: rubber"},
};

constexpr std::array fields{
    Word{"position", "write at: [x, y]"},
    Word{"pos", "write at: [x, y]"},
    Word{"x", "write at: [x, y]"},
    Word{"y", "write at: [x, y]"},
    Word{"centre", "write at: [x, y]"},
    Word{"center", "write at: [x, y]"},
    Word{"rotate", "write turn: degrees, counter-clockwise"},
    Word{"rotation", "write turn: degrees, counter-clockwise"},
    Word{"angle", "write turn: degrees, counter-clockwise"},
    Word{"name", "write id"},
    Word{"color", "a material has a color: write material, and the color in materials"},
    Word{"colour", "a material has a color: write material, and the color in materials"},
    Word{"restitution", "a material has it: write material, and restitution in materials"},
    Word{"bounce", "a material has it: write material, and restitution in materials"},
    Word{"friction", "a material has it: write material, and friction in materials"},
    Word{"key", "write input, and its keys in the section inputs"},
    Word{"diameter", "write radius, half of it"},
};

template <std::size_t n>
std::string_view hint_of(const std::array<Word, n>& words, std::string_view theirs) {
    const auto found = std::find_if(words.begin(), words.end(), [&](const Word& word) { return word.theirs == theirs; });
    return found == words.end() ? std::string_view{} : found->hint;
}

}  // namespace

std::string_view other_word_for_node(std::string_view word) { return hint_of(nodes, word); }
std::string_view other_word_for_field(std::string_view word) { return hint_of(fields, word); }

}  // namespace pinfield
