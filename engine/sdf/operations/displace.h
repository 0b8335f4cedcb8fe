#pragma once
#include <span>
#include <tuple>

#include "engine/core/geometry.h"
#include "engine/core/trig.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/waves.h"

namespace pinfield::sdf {

/// The child's outline moved in and out by waves along x times waves along y. The waves are at most 2 pi amplitude / wavelength steep;
/// the field is divided by one more than that, so that it is a bound.
template <class Real>
struct Displace {
    Real amplitude = Real(0.002);
    Point<Real> wavelength{Real(0.02), Real(0.02)};

    double scale = 1;

    static constexpr auto derived() { return std::tuple(&Displace::scale); }
    void derive() { scale = 1 / (1 + 2 * pi * amplitude / min(wavelength.x, wavelength.y)); }

    Point<Real> warp(const Point<Real>& p) const { return p; }
    Real lift(const Point<Real>& p) const {
        return amplitude * Real(scale) * sine_of_turns(p.x / wavelength.x) * sine_of_turns(p.y / wavelength.y);
    }
    double factor() const { return scale; }

    Exactness exactness(std::span<const Exactness> children) const {
        if (amplitude == 0) return children[0];
        return {Side::bound, Side::bound, max(1.0, children[0].lipschitz)};
    }
    Box2 bounds(std::span<const Box2> children) const { return children[0].grown(amplitude); }
    double reach(int) const { return amplitude; }

    static constexpr auto describe() {
        using T = Displace;
        return operation<T>(
            {.key = "displace",
             .exactness = {Side::bound, Side::bound},
             .float_error = 1e-5,
             .children = {1, 1},
             .doc = "The child's outline moved in and out by waves."},
            fields(field("amplitude", &T::amplitude,
                         {.unit = Unit::metre, .min = from(0), .step = 0.0001, .doc = "How far the field is moved at most."}),
                   field("wavelength", &T::wavelength,
                         {.unit = Unit::metre, .min = from(0.005), .step = 0.001, .doc = "Of the waves along x and along y."})),
            contract("the waves are no higher than they are long",
                     [](const auto& d) { return d.amplitude <= d.wavelength.x && d.amplitude <= d.wavelength.y; }));
    }
};

}  // namespace pinfield::sdf
