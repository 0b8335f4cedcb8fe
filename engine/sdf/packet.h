// A SIMD packet of floats as a scalar of the distance formulas. The instruction set is named in the type (never xsimd's default,
// which may become one with fused multiply-add and other roundings), so that every symbol carries it.
#pragma once
#include <xsimd/xsimd.hpp>

#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// One truth value per lane. A type of our own, so that formulas find its operations by its namespace.
template <class Arch>
struct PacketMask {
    xsimd::batch_bool<float, Arch> v;

    friend PacketMask both(const PacketMask& a, const PacketMask& b) { return {a.v & b.v}; }
    friend PacketMask either(const PacketMask& a, const PacketMask& b) { return {a.v | b.v}; }
    friend PacketMask exactly_one(const PacketMask& a, const PacketMask& b) { return {a.v ^ b.v}; }
    friend PacketMask invert(const PacketMask& a) { return {!a.v}; }
};

template <class Arch>
struct Packet {
    using Batch = xsimd::batch<float, Arch>;
    using Mask = PacketMask<Arch>;
    static constexpr int width = static_cast<int>(Batch::size);
    Batch v;

    Packet() : v(0.0f) {}
    explicit Packet(double broadcast) : v(static_cast<float>(broadcast)) {}
    explicit Packet(const Batch& batch) : v(batch) {}
    static Packet load(const float* from) { return Packet(Batch::load_unaligned(from)); }
    void store(float* to) const { v.store_unaligned(to); }

    friend Packet operator+(const Packet& a, const Packet& b) { return Packet(a.v + b.v); }
    friend Packet operator-(const Packet& a, const Packet& b) { return Packet(a.v - b.v); }
    friend Packet operator-(const Packet& a) { return Packet(-a.v); }
    friend Packet operator*(const Packet& a, const Packet& b) { return Packet(a.v * b.v); }
    friend Packet operator/(const Packet& a, const Packet& b) { return Packet(a.v / b.v); }
    friend Mask operator<(const Packet& a, const Packet& b) { return {a.v < b.v}; }
    friend Mask operator>(const Packet& a, const Packet& b) { return {a.v > b.v}; }
    friend Mask operator<=(const Packet& a, const Packet& b) { return {a.v <= b.v}; }
    friend Mask operator>=(const Packet& a, const Packet& b) { return {a.v >= b.v}; }
    friend Packet sqrt(const Packet& a) { return Packet(xsimd::sqrt(a.v)); }
    friend Packet floor(const Packet& a) { return Packet(xsimd::floor(a.v)); }
    friend Packet abs(const Packet& a) { return Packet(xsimd::abs(a.v)); }
    friend Packet min(const Packet& a, const Packet& b) { return Packet(xsimd::min(a.v, b.v)); }
    friend Packet max(const Packet& a, const Packet& b) { return Packet(xsimd::max(a.v, b.v)); }
    friend Packet frozen(const Packet& a) { return a; }
    friend double epsilon_of(const Packet&) { return 0x1p-23; }
    friend Packet with_gradient(const Packet& value, const Packet&, const Packet&, const Point<Packet>&) { return value; }
    friend Packet select(const Mask& condition, const Packet& yes, const Packet& no) {
        return Packet(xsimd::select(condition.v, yes.v, no.v));
    }
};

}  // namespace pinfield::sdf
