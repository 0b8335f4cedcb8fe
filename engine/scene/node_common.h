// The fields every scene node has, whatever its type, and the frame they make.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "engine/reflect/describe.h"

namespace pinfield {

enum class Flip : unsigned char { none, x, y };
constexpr std::array<std::string_view, 3> choice_names(Flip) { return {"none", "x", "y"}; }

/// world = at + R(turn) S(scale) F(flip) local.
struct NodeCommon {
    std::string id;
    Point<double> at{0, 0};
    double turn = 0;
    double scale = 1;
    Flip flip = Flip::none;
    std::string material;
    std::vector<std::string> layer;
    bool visible = true;
    bool locked = false;
    std::string note;

    static constexpr auto describe() {
        using C = NodeCommon;
        return record<C>(
            {.key = "common", .doc = "Fields of every scene node."},
            fields(field("id", &C::id,
                         {.meaning = Meaning::id, .affects = Affects::structure, .doc = "Name of the node, unique in its file."}),
                   field("at", &C::at, {.unit = Unit::metre, .step = 0.001, .doc = "Where the local origin lies in the parent's frame."}),
                   field("turn", &C::turn, {.unit = Unit::degree, .step = 1, .doc = "Rotation, counter-clockwise."}),
                   field("scale", &C::scale, {.min = above(0), .step = 0.01, .doc = "Uniform scale, so that distances stay distances."}),
                   field("flip", &C::flip, {.doc = "Negates that local axis."}),
                   field("material", &C::material,
                         {.meaning = Meaning::material, .doc = "What the surface is made of; inherited by children."}),
                   field("layer", &C::layer,
                         {.meaning = Meaning::layer,
                          .affects = Affects::structure,
                          .doc = "Layers the node belongs to; none means the ground layer."}),
                   field("visible", &C::visible, {.affects = Affects::drawing, .doc = "Drawn. The field does not change."}),
                   field("locked", &C::locked, {.affects = Affects::nothing, .doc = "The editor neither picks nor moves it."}),
                   field("note", &C::note, {.affects = Affects::nothing, .doc = "For people."})));
    }
};

}  // namespace pinfield
