// What a node can be over a box: its own formula over intervals, behind function pointers like those of kernels.h.
#pragma once
#include <concepts>

#include "engine/reflect/load.h"
#include "engine/sdf/packet_kernels.h"
#include "tests/conformance/interval_box.h"
#include "engine/sdf/interval_dual.h"

namespace pinfield::sdf {

/// Each holds all that the kernel of the same kind returns anywhere in the boxes and intervals it is given; null where the node has no such
/// kernel.
struct Enclosures {
    // shape
    Interval (*distance)(const double* params, const IntervalBox& p) = nullptr;
    IntervalSample (*sample)(const double* params, const IntervalBox& p) = nullptr;
    // fold: dx and dy are the derivatives by a and by b
    IntervalSample (*combine)(const double* params, const Interval& a, const Interval& b) = nullptr;
    // modify: dx is the derivative by d, dy is 0
    IntervalSample (*modify)(const double* params, const Interval& d) = nullptr;
    // warp
    IntervalWarped (*warped)(const double* params, const IntervalBox& p) = nullptr;
};

namespace detail {

inline Point<IntervalDual> with_slopes(const IntervalBox& p) {
    return {{p.x, Interval(1), Interval(0)}, {p.y, Interval(0), Interval(1)}};
}
inline IntervalSample sample_of(const IntervalDual& d) { return {d.v, d.dx, d.dy}; }

}  // namespace detail

template <template <class> class N>
Enclosures enclosures() {
    using T = N<Interval>;
    using D = N<IntervalDual>;
    Enclosures out;
    if constexpr (HasOutlineOnly<D> || requires(const D& node, const Point<IntervalDual>& p) { node.distance(p); }) {
        out.distance = [](const double* params, const IntervalBox& p) { return shape_distance<T, Interval>(load<T>(params), params, p); };
        out.sample = [](const double* params, const IntervalBox& p) {
            return detail::sample_of(shape_distance<D, IntervalDual>(load<D>(params), params, detail::with_slopes(p)));
        };
    } else if constexpr (requires(const D& node, const IntervalDual& d) { node.combine(d, d); }) {
        out.combine = [](const double* params, const Interval& a, const Interval& b) {
            const Interval one(1), none(0);
            return detail::sample_of(load<D>(params).combine(IntervalDual(a, one, none), IntervalDual(b, none, one)));
        };
    } else if constexpr (requires(const D& node, const IntervalDual& d) { node.modify(d); }) {
        out.modify = [](const double* params, const Interval& d) {
            return detail::sample_of(load<D>(params).modify(IntervalDual(d, Interval(1), Interval(0))));
        };
    } else if constexpr (requires(const D& node, const Point<IntervalDual>& p) { node.warp(p); }) {
        out.warped = [](const double* params, const IntervalBox& p) -> IntervalWarped {
            const D node = load<D>(params);
            const Point<IntervalDual> at = detail::with_slopes(p), to = node.warp(at);
            return {detail::sample_of(to.x), detail::sample_of(to.y), detail::sample_of(lift_of<D, IntervalDual>(node, at))};
        };
    }
    return out;
}

}  // namespace pinfield::sdf
