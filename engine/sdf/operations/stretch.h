#pragma once
#include <span>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// The child scaled by different factors along its local axes. Distances are multiplied by the lesser one: a bound, exact only
/// when both are equal.
template <class Real>
struct Stretch {
    Point<Real> by{Real(2), Real(1)};

    Point<Real> warp(const Point<Real>& p) const { return {p.x / by.x, p.y / by.y}; }
    double factor() const { return min(by.x, by.y); }

    Exactness exactness(std::span<const Exactness> children) const {
        if (by.x == by.y) return children[0];
        return {Side::bound, Side::bound, children[0].lipschitz};
    }
    Box2 bounds(std::span<const Box2> children) const {
        const Vec2 scale(by.x, by.y);
        return children[0].is_empty() ? children[0] : Box2{children[0].lo.cwiseProduct(scale), children[0].hi.cwiseProduct(scale)};
    }

    static constexpr auto describe() {
        return operation<Stretch>({.key = "stretch",
                                   .exactness = {Side::bound, Side::bound},
                                   .children = {1, 1},
                                   .doc = "The child scaled by different factors along its local axes."},
                                  fields(field("by", &Stretch::by,
                                               {.min = from(0.01), .max = to(100), .step = 0.01, .doc = "Factors along x and along y."})));
    }
};

}  // namespace pinfield::sdf
