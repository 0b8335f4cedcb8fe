#pragma once
#include "engine/core/geometry.h"
#include "engine/core/trig.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/outline_path.h"

namespace pinfield::sdf {

/// Strip with flat ends that starts at the local origin towards +x and is bent evenly, keeping its length (Quilez, "Joint").
template <class Real>
struct Joint {
    static constexpr int most_pieces = 8;
    /// Below it, degrees, the bend keeps the radius it has there, between two straight parts: the centre of an even flatter one would
    /// be too far away for its digits. So the strip passes through straight without a jump.
    static constexpr double least_even_angle = 0.05;

    Real length = Real(0.1);
    Real angle = Real(90);
    Real thickness = Real(0.02);

    void outline(Outline& out) const {
        const double bend = abs(angle), w = 0.5 * thickness;
        // Straight parts of less than a part in 1e8 would be too short for their direction's digits.
        const double even = bend < (1 - 1e-8) * least_even_angle ? least_even_angle : bend, r = length / radians(even);
        const SineCosine half = sine_cosine_degrees(0.5 * bend), whole = sine_cosine_degrees(bend);
        const double straight = 0.5 * length * (1 - bend / even), chord = 2 * r * half.sine;
        const Vec2 along(whole.cosine, whole.sine), aside = w * perpendicular(along);
        const Vec2 bend_start(straight, 0), bend_end = bend_start + chord * Vec2(half.cosine, half.sine), centre(straight, r);
        const Vec2 end = bend_end + straight * along;
        Outline left;
        OutlinePen pen(left, {0, -w});
        pen.line_to(bend_start + Vec2(0, -w));
        pen.arc_to(bend_end - aside, centre, 1, bend > 180);
        pen.line_to(end - aside);
        pen.line_to(end + aside);
        pen.line_to(bend_end + aside);
        pen.arc_to(bend_start + Vec2(0, w), centre, -1, bend > 180);
        pen.line_to({0, w});
        pen.close();
        for (const Piece& piece : left) out.push_back(angle < 0 ? mirrored(piece) : piece);
    }

    static constexpr auto describe() {
        return shape<Joint>(
            {.key = "joint", .doc = "Evenly bent strip with flat ends that starts at the local origin towards +x."},
            fields(field("length", &Joint::length,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Along the middle of the strip."}),
                   field("angle", &Joint::angle,
                         {.unit = Unit::degree, .min = from(-350), .max = to(350), .step = 1,
                          .doc = "Between the directions of its ends: above 0 it bends left, below 0 right."}),
                   field("thickness", &Joint::thickness,
                         {.unit = Unit::metre, .min = above(0), .step = 0.0005, .doc = "Full width of the strip."})),
            contract("length / 1000 <= thickness <= 1000 length",
                     [](const auto& joint) { return joint.thickness >= 0.001 * joint.length && joint.thickness <= 1000 * joint.length; }),
            contract("the inner side keeps 0.05 of the bend's radius: thickness <= 1.9 length / angle in radians", [](const auto& joint) {
                return joint.thickness * radians(abs(joint.angle)) <= 1.9 * joint.length;
            }));
    }

private:
    /// In the x axis, which swaps the ends to keep the solid on the left.
    static Piece mirrored(const Piece& piece) {
        const auto flipped = [](const Vec2& p) { return Vec2(p.x(), -p.y()); };
        Piece out = piece;
        out.a = flipped(piece.b);
        out.b = flipped(piece.a);
        out.centre = flipped(piece.centre);
        return out;
    }
};

}  // namespace pinfield::sdf
