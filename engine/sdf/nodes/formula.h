#pragma once
#include <optional>
#include <string_view>
#include <tuple>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/reflect/text_fault.h"
#include "engine/sdf/dual_functions.h"
#include "engine/sdf/interval_functions.h"
#include "engine/sdf/packet_functions.h"
#include "engine/sdf/scalar.h"
#include "engine/sdf/steepness.h"
#include "engine/sdf/steps.h"

namespace pinfield::sdf {

/// Where a formula of x and y is 0 or less, within a rectangle about the local origin. A formula is seldom a distance: cut off at a level
/// and divided by how fast it then changes at most (steepness.h) it is a bound of one. Beyond the rectangle the nearest point of it is asked,
/// which changes no faster.
template <class Real>
struct Formula {
    Steps formula{.text = "y - 8mm * cos(x / 1mm * 9deg)"};
    Point<Real> window{Real(0.08), Real(0.05)};

    double scale = 0, level = 0;                                  // what is refused is nowhere solid
    double left = infinity, down = infinity, right = -infinity, up = -infinity;  ///< around the solid

    static constexpr bool known_over_boxes = true;

    static constexpr auto derived() {
        using T = Formula;
        return std::tuple(&T::scale, &T::level, &T::left, &T::down, &T::right, &T::up);
    }
    void derive() {
        const auto found = steepness_of(formula, {window.x, window.y}, {});
        if (!found) return;
        level = found->level;
        scale = 1 / found->lipschitz;
        const Box2 box = box_below(formula, {window.x, window.y}, 0);
        left = box.lo.x(), down = box.lo.y(), right = box.hi.x(), up = box.hi.y();
    }
    std::optional<TextFault> refusal(std::string_view text) const {
        auto found = steepness_of(formula, {window.x, window.y}, text);
        return found ? std::nullopt : std::optional(std::move(found.error()));
    }

    Real distance(const Point<Real>& p) const {
        const Point<Real> half = window * Real(0.5);
        const Point<Real> q{clamp(p.x, -half.x, half.x), clamp(p.y, -half.y, half.y)};
        // In this order, so that what is no number, of a formula that is refused, is cut off, too.
        const Real bound = min(max(Real(-level), value_at(formula, q)), Real(level)) * Real(scale);
        const Point<Real> beyond{abs(p.x) - half.x, abs(p.y) - half.y};
        const Real beside = max(beyond.x, beyond.y), around = norm(Point<Real>{max(beyond.x, Real(0)), max(beyond.y, Real(0))});
        return max(bound, select(min(beyond.x, beyond.y) > Real(0), around, beside));
    }
    Box2 bounds() const { return {{left, down}, {right, up}}; }
    /// Beyond the window the field is as much as the way to it at least.
    Box2 bounds_below(double least) const {
        const Vec2 all(window.x, window.y);
        const bool is_cut = least >= level * scale;
        return (is_cut ? Box2::centred(0.5 * all.x(), 0.5 * all.y()) : box_below(formula, all, least / scale)).grown(least);
    }

    static constexpr auto describe() {
        constexpr Exactness a_bound{Side::bound, Side::bound};
        return shape<Formula>({.key = "formula", .exactness = a_bound, .float_error = 5e-6, .doc = "Where a formula of x and y is 0 or less."},
                              fields(field("distance", &Formula::formula,
                                           {.meaning = Meaning::formula,
                                            .doc = "An expression of x and y, the point's place in metres, that comes to a length: below 0 where "
                                                   "it is solid. It need not be a distance, but neither jump nor be without end steep on its outline."}),
                                     field("bounds", &Formula::window,
                                           {.unit = Unit::metre,
                                            .min = above(0),
                                            .step = 0.001,
                                            .doc = "The rectangle about the origin that it counts in, full width and height."})));
    }
};

}  // namespace pinfield::sdf
