// What the engine can compute of a shape or operation, behind function pointers: the dispatch table that replaces any
// switch over node kinds. make_kernels.h fills it from the node's struct.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/reflect/exactness.h"
#include "engine/sdf/clearance.h"
#include "engine/sdf/lattice.h"
#include "engine/sdf/outline.h"

namespace pinfield {
struct TextFault;  // engine/reflect/text_fault.h
}

namespace pinfield::sdf {

/// Instruction sets that packet kernels exist for; sse2 is the x86-64 baseline and always there.
enum class Isa : unsigned char { sse2, avx2 };
inline constexpr int isa_count = 2;
/// The widest one that this processor runs.
Isa best_isa();

/// Value and gradient; |gradient| = 1 wherever the distance is exact.
struct Sample {
    double value = 0;
    Vec2 gradient{0, 0};
};

/// f = combine(a, b) with its partial derivatives.
struct Partials {
    double value = 0, by_a = 0, by_b = 0;
};

/// Holds what a field can be anywhere in a box.
struct FieldOverBox {
    double least = 0, most = 0;
    Box2 gradients;  ///< as points of a plane of its own
};

/// How a unary operation changes a distance: f = sign * d + offset, or f = |d| + offset. sign is +1 or -1.
struct Affine {
    double sign = 1;
    double offset = 0;  ///< metres
    bool absolute = false;
};

/// A fold lies within [hard - below, hard + above] of its lattice counterpart built of min, max and minus alone.
struct Slack {
    double below = 0, above = 0;  ///< metres
};

/// shape: a distance of its own. fold: combines its children's fields pairwise in file order.
/// modify: changes its only child's field. images: its only child, seen through a list of isometries, united.
/// warp: its only child, asked at another point: f(p) = factor * child(warp(p)) + lift(p).
enum class Form : unsigned char { shape, fold, modify, images, warp };

/// Where a warp sends a point, what it adds there, and the derivatives of both: `from_x` and `from_y` are those of the point along x
/// and along y.
struct Warped {
    Vec2 point, from_x, from_y;
    double lift = 0;
    Vec2 lift_gradient{0, 0};

    Vec2 gradient(double factor, const Vec2& of_child) const {
        return factor * Vec2(pinfield::dot(from_x, of_child), pinfield::dot(from_y, of_child)) + lift_gradient;
    }
};

/// From the points that a packet kernel is given to a shape's local frame, and back with the distance.
struct PacketFrame {
    float xx = 1, xy = 0, x0 = 0, yx = 0, yy = 1, y0 = 0;  ///< local x = xx x + xy y + x0, local y alike
    float scale = 1;                                        ///< of the distances
};

/// n distances at the points x, y, seen through `frame` (any n >= 0; arrays need no padding).
using PacketDistance = void (*)(const double* params, const PacketFrame& frame, const float* x, const float* y, float* distance, int n);
/// a[i] = combine(a[i], b[i]); a modify kernel ignores b.
using PacketCombine = void (*)(const double* params, float* a, const float* b, int n);

/// (x, y) = warp(x, y) and lift = lift(x, y) of the points that came in.
using PacketWarp = void (*)(const double* params, float* x, float* y, float* lift, int n);

struct PacketKernels {
    PacketDistance distance = nullptr;
    PacketCombine combine = nullptr;
    PacketWarp warp = nullptr;
};

/// `params` is the node's packed block after derive().
struct Kernels {
    Form form = Form::shape;
    int derived_count = 0;
    void (*derive)(double* params) = nullptr;
    Exactness (*exactness)(const double* params, std::span<const Exactness> children) = nullptr;
    std::array<PacketKernels, isa_count> packets{};  ///< an empty entry falls back to sse2

    // shape
    double (*distance)(const double* params, double x, double y) = nullptr;
    Sample (*sample)(const double* params, double x, double y) = nullptr;
    Box2 (*bounds)(const double* params) = nullptr;
    void (*outline)(const double* params, Outline& out) = nullptr;  ///< null: never of lines and arcs; may give none
    bool convex = false;
    bool endless = false;  ///< a half plane: its outline is all of the local x axis
    /// Of a shape whose outside is only a bound: holds where its field is below `level` metres > 0, which may be far out. Null: no farther than that.
    Box2 (*bounds_below)(const double* params, double level) = nullptr;
    FieldOverBox (*over_box)(const double* params, const Box2& box) = nullptr;  ///< null: the field is known by samples
    /// Why the values make no shape, as only its mathematics can tell: the fault is of the text that it reads. Null: there is no such reason.
    std::optional<TextFault> (*refusal)(const double* params, std::string_view text) = nullptr;

    // fold
    double (*combine)(const double* params, double a, double b) = nullptr;
    Partials (*combine_partials)(const double* params, double a, double b) = nullptr;
    Clearance (*combine_clearance)(const double* params, const Clearance& a, const Clearance& b) = nullptr;
    double (*combine_hard)(const double* params, double a, double b) = nullptr;  ///< the lattice counterpart
    Slack (*slack)(const double* params) = nullptr;
    // fold, modify and warp; a warp's boxes are in its local frame
    Box2 (*bounds_over)(const double* params, std::span<const Box2> children) = nullptr;
    /// How far, in metres of field, the solid may spread over where its children are solid: it lies where some child's field is below
    /// this. bounds_over() grows its boxes by as much, which is enough where that field is the exact distance; over a child
    /// whose outside is only a bound, ask for the box of the child's own isoline instead. Null: 0.
    double (*reach)(const double* params, int children) = nullptr;

    // modify
    double (*modify)(const double* params, double d) = nullptr;
    Affine (*affine)(const double* params) = nullptr;

    // images: local_from_image maps a point as the child has it to where the image has it
    std::vector<Similarity> (*images)(const double* params) = nullptr;

    // warp
    Vec2 (*warp)(const double* params, const Vec2& p) = nullptr;
    double (*lift)(const double* params, const Vec2& p) = nullptr;
    Warped (*warped)(const double* params, const Vec2& p) = nullptr;
    double (*factor)(const double* params) = nullptr;
    /// Of a warp that folds the plane into a lattice's middle cell: its child is to be asked together with its neighbours.
    Lattice (*lattice)(const double* params) = nullptr;
};

}  // namespace pinfield::sdf
