// A node's float packets beside its doubles: what they are fed, and what comes out.
#pragma once
#include <vector>

#include "tests/conformance/laws.h"

namespace pinfield::conformance {

/// Pairs of field values: of all signs, equal, opposite, far apart.
struct Operands {
    std::vector<double> a, b;
};
Operands operands(double extent);

/// What packets are fed: points for a shape, field values for an operation; in floats, so that rounding the input is no error.
struct Floats {
    std::vector<float> a, b;
};
Floats points_in_floats(const Trial& trial);
Floats packet_input(const Trial& trial);

/// All n results of one instruction set; empty where this machine or the node has none.
std::vector<float> run(const Subject& subject, sdf::Isa isa, const std::vector<float>& a, const std::vector<float>& b);
/// The same in double: a shape's distance at (a, b), an operation's field over the values a and b.
double in_double(const Subject& subject, double a, double b);

/// Where packets of one instruction set send the points, and what they lift there; empty as above.
struct Floats3 {
    std::vector<float> x, y, lift;
};
Floats3 warp(const Subject& subject, sdf::Isa isa, const Floats& points);
/// By how much the place where a packet sends p misses the warp's own, as the field sees it. Of two equal places of a lattice, on the
/// border of its cells, either will do.
double missed_by(const Subject& subject, const Vec2& sent, const Vec2& p);

}  // namespace pinfield::conformance
