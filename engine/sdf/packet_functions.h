// What expressions have beyond the operations of scalar.h, over SIMD lanes: by + - * / floor and square roots where this library has them so,
// else by xsimd's own series, which are made of the same operations for every instruction set.
#pragma once
#include "engine/sdf/angle.h"
#include "engine/sdf/functions.h"
#include "engine/sdf/packet.h"
#include "engine/sdf/waves.h"

namespace pinfield::sdf {

template <class Arch>
Packet<Arch> sine_degrees(const Packet<Arch>& a) { return sine_of_turns(a / Packet<Arch>(360)); }
template <class Arch>
Packet<Arch> cosine_degrees(const Packet<Arch>& a) { return cosine_of_turns(a / Packet<Arch>(360)); }
template <class Arch>
Packet<Arch> arc_tangent(const Packet<Arch>& y, const Packet<Arch>& x) {
    const Packet<Arch> size = angle_of(Point<Packet<Arch>>{x, abs(y)});
    return select(y < Packet<Arch>(0), -size, size);
}
template <class Arch>
Packet<Arch> exponential(const Packet<Arch>& a) { return Packet<Arch>(xsimd::exp(a.v)); }
template <class Arch>
Packet<Arch> logarithm(const Packet<Arch>& a) { return Packet<Arch>(xsimd::log(a.v)); }

}  // namespace pinfield::sdf
