// Transcendental functions with the same bits from every compiler, processor and libm.
// libm's own differ in the last bit between versions and between gcc's and clang's constant folding, and one bit is
// enough to send a ball round the other side of a post. These use only + - * / sqrt and comparisons, which IEEE 754
// fixes. Error, in units of the last place of the result: below 1 for sine, cosine, exponential and logarithm,
// below 2.5 for the others (relative error below 6e-16), for angles up to 1e6 rad; beyond that sine and cosine stay in
// range and reproducible, but lose digits. NaN and infinities behave as in <cmath>.
#pragma once

namespace pinfield {

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double half_pi = 1.57079632679489661923;
inline constexpr double two_pi = 6.28318530717958647693;

/// Degrees at the file's border, radians inside.
constexpr double radians(double degrees) { return degrees * (pi / 180); }
constexpr double degrees(double radians) { return radians * (180 / pi); }

struct SineCosine {
    double sine, cosine;
};

/// Of an angle in radians. sine(-x) == -sine(x) and cosine(-x) == cosine(x), bit for bit.
double sine(double x);
double cosine(double x);
double tangent(double x);
SineCosine sine_cosine(double x);

/// Of an angle in degrees, reduced without rounding: multiples of 90 give exactly 0 and +-1, sine_degrees(30) is 0.5,
/// and sine_degrees(x) == cosine_degrees(90 - x) wherever 90 - x is exact.
double sine_degrees(double x);
double cosine_degrees(double x);
SineCosine sine_cosine_degrees(double x);

/// Angle of the vector (x, y) in [-pi, pi]. Reflecting the vector in an axis reflects the angle exactly.
double arc_tangent(double y, double x);
/// In [0, pi]; NaN outside [-1, 1].
double arc_cosine(double x);
/// In [-pi/2, pi/2]; NaN outside [-1, 1].
double arc_sine(double x);

double exponential(double x);
/// Natural logarithm; -infinity at 0, NaN below.
double logarithm(double x);

}  // namespace pinfield
