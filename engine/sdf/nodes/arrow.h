#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/corners.h"
#include "engine/sdf/edges.h"

namespace pinfield::sdf {

/// Straight arrow from its flat tail at a to its tip at b. Without a shaft it is a triangle, with a head as narrow as
/// its shaft a picket.
template <class Real>
struct Arrow {
    static constexpr int most_pieces = 7;

    Point<double> a{-0.05, 0}, b{0.05, 0};
    Real thickness = Real(0.02), head_length = Real(0.04), head_width = Real(0.05);

    void outline(Outline& out) const {
        const Edge axis = edge_between(a, b);
        const double t = 0.5 * thickness, w = 0.5 * head_width;
        const double neck = axis.length - snapped(head_length, axis.length, axis.length);
        const auto place = [&](double x, double y) { return Vec2(a.x + x * axis.tx - y * axis.ty, a.y + x * axis.ty + y * axis.tx); };
        outline_through(out, {place(0, -t), place(neck, -t), place(neck, -w), {b.x, b.y}, place(neck, w), place(neck, t), place(0, t)});
    }

    static constexpr auto describe() {
        using T = Arrow;
        return shape<T>(
            {.key = "arrow", .doc = "Straight arrow from a to b."},
            fields(field("a", &T::a, {.unit = Unit::metre, .step = 0.001, .meaning = Meaning::place, .doc = "Middle of the flat tail."}),
                   field("b", &T::b, {.unit = Unit::metre, .step = 0.001, .meaning = Meaning::place, .doc = "The tip."}),
                   field("thickness", &T::thickness,
                         {.unit = Unit::metre, .min = above(0), .step = 0.0005, .doc = "Full width of the shaft."}),
                   field("head_length", &T::head_length,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Of the head, along the arrow."}),
                   field("head_width", &T::head_width,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Of the head, across the arrow."})),
            contract("head_length <= the distance from a to b",
                     [](const auto& arrow) { return arrow.head_length <= edge_between(arrow.a, arrow.b).length; }),
            contract(
                "the distance from a to b and head_width are at most 1000 times the thickness",
                [](const auto& arrow) { return max(edge_between(arrow.a, arrow.b).length, arrow.head_width) <= 1000 * arrow.thickness; }),
            // Float packets could tell neither the sides of a shaft farther out apart, nor the corners of a narrower ledge.
            contract("no coordinate of a and b is more than 10000 times the thickness",
                     [](const auto& arrow) {
                         const auto reach = [](const auto& p) { return max(abs(p.x), abs(p.y)); };
                         return max(reach(arrow.a), reach(arrow.b)) <= 10000 * arrow.thickness;
                     }),
            contract("head_width = thickness, or larger by at least a thousandth of the thickness and of the length",
                     [](const auto& arrow) {
                         const auto least = 0.001 * max(arrow.thickness, edge_between(arrow.a, arrow.b).length);
                         return arrow.head_width == arrow.thickness || arrow.head_width - arrow.thickness >= least;
                     }),
            contract("head_length / 20 <= head_width <= 20 head_length", [](const auto& arrow) {
                return arrow.head_length <= 20 * arrow.head_width && arrow.head_width <= 20 * arrow.head_length;
            }));
    }
};

}  // namespace pinfield::sdf
