// Method: reduce the argument to a small interval with the reduction error carried in a second double (Cody & Waite,
// "Software Manual for the Elementary Functions", 1980), then a Taylor series long enough to be exact to rounding
// there. Taylor rather than minimax: two terms more, and every coefficient can be checked by eye. The correction of the
// series by the second double follows K. C. Ng's notes in fdlibm.
#include "engine/core/trig.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pinfield {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

/// An unevaluated sum hi + lo, |lo| at most half a unit in the last place of hi.
struct TwoDoubles {
    double hi, lo;
};

/// Exact sum of two doubles (Knuth, TAOCP 4.2.2, theorem B).
TwoDoubles exact_sum(double a, double b) {
    const double hi = a + b;
    const double part = hi - a;
    return {hi, (a - (hi - part)) + (b - part)};
}

/// c[0] + c[1] z + c[2] z^2 + ... by Horner's rule.
template <int count>
double polynomial(double z, const double (&c)[count]) {
    double sum = c[count - 1];
    for (int i = count - 2; i >= 0; --i) sum = c[i] + z * sum;
    return sum;
}

/// An angle = quadrant * 90 degrees + rest, the rest in radians, at most 45 degrees (a hair more where rounding
/// decided).
struct Reduced {
    TwoDoubles rest;
    int quadrant;  // 0..3
};

/// Nearest multiple of pi/2 taken off x >= 0. pi/2 is split so that its first two parts have 33 bits: their products
/// with a quadrant count below 2^20 are exact.
Reduced reduce_radians(double x) {
    constexpr double part1 = 0x1.921fb544p+0, part2 = 0x1.0b4611a6p-34, part3 = 0x1.3198a2e037073p-69;
    constexpr double largest_count = 1 << 20;
    // Far out, whole turns of the double nearest 2 pi err by less than the argument's own last place.
    if (x > largest_count) x = std::fmod(x, two_pi);  // fmod is exact, hence the same everywhere
    const double count = std::floor(x * (2 / pi) + 0.5);
    TwoDoubles rest = exact_sum(x - count * part1, -(count * part2));
    rest = exact_sum(rest.hi, rest.lo - count * part3);
    return {rest, static_cast<int>(count) & 3};
}

/// sin(hi + lo) for |hi| <= pi/4 and a little more: Taylor to x^17, remainder below 1e-19 of the result.
double sine_series(TwoDoubles x) {
    const double z = x.hi * x.hi;
    static constexpr double taylor[] = {-1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
                                        -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
    const double tail = polynomial(z, taylor);
    return x.hi + (x.hi * z * tail + x.lo * (1 - 0.5 * z));
}

/// cos(hi + lo), likewise, to x^16. 1 - z/2 is rounded once and its rounding error put back.
double cosine_series(TwoDoubles x) {
    const double z = x.hi * x.hi;
    static constexpr double taylor[] = {1.0 / 24,        -1.0 / 720,         1.0 / 40320,         -1.0 / 3628800,
                                        1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000};
    const double tail = polynomial(z, taylor);
    const double half = 0.5 * z;
    const double head = 1 - half;
    return head + (((1 - head) - half) + (z * z * tail - x.hi * x.lo));
}

/// Turns the pair of the rest by whole quarter turns. Subtracting from 0 keeps a zero positive.
SineCosine turned(SineCosine rest, int quadrant) {
    switch (quadrant) {
        case 0: return rest;
        case 1: return {rest.cosine, 0 - rest.sine};
        case 2: return {0 - rest.sine, 0 - rest.cosine};
        default: return {0 - rest.cosine, rest.sine};
    }
}

/// x degrees to radians as two doubles: the upper 26 bits of x times the upper 26 bits of pi/180 are exact.
TwoDoubles radians_exactly(double x) {
    constexpr double upper = 0x1.1df46ap-6, lower = 0x1.294e9c8ae0ec6p-33;  // pi/180 = upper + lower
    const double x_upper = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0xfffffffff8000000u);
    const double x_lower = x - x_upper;
    return exact_sum(x_upper * upper, x_upper * lower + x_lower * upper + x_lower * lower);
}

/// Of |x| <= 45 degrees. The two angles whose sine is known in closed form do not depend on the luck of rounding.
SineCosine sine_cosine_of_rest_degrees(double x) {
    constexpr double sqrt_half = 0.70710678118654752440;
    if (x == 45) return {sqrt_half, sqrt_half};
    if (x == -45) return {-sqrt_half, sqrt_half};
    const TwoDoubles rest = radians_exactly(x);
    const SineCosine pair{sine_series(rest), cosine_series(rest)};
    if (x == 30) return {0.5, pair.cosine};
    if (x == -30) return {-0.5, pair.cosine};
    return pair;
}

/// atan(t) for t in [0, 1]: atan t = atan c + atan((t - c) / (1 + t c)) with c the nearest sixteenth, then Taylor.
double arc_tangent_of_ratio(double t) {
    static constexpr TwoDoubles at_sixteenth[17] = {
        {0, 0},
        {0.06241880999595735, -1.5490756308295046e-18},
        {0.12435499454676144, -3.1253241424539383e-18},
        {0.18534794999569476, 4.180692268843079e-18},
        {0.24497866312686414, 1.0698755618734451e-17},
        {0.3028848683749714, -1.1010827903001369e-17},
        {0.35877067027057225, -2.4623815582638635e-17},
        {0.4124104415973873, -1.587652227770689e-17},
        {0.4636476090008061, 2.2698777452961687e-17},
        {0.5123894603107377, -2.5462781472855804e-17},
        {0.5585993153435624, -5.4556305485916264e-18},
        {0.6022873461349642, 2.950430737228402e-17},
        {0.6435011087932844, 1.5834785051444286e-17},
        {0.6823165548747481, 6.943223671560008e-18},
        {0.7188299996216245, -2.1478388444456983e-17},
        {0.7531512809621944, -2.4256934659182068e-17},
        {0.7853981633974483, 3.061616997868383e-17},
    };
    const double sixteenths = std::floor(16 * t + 0.5);
    const double c = sixteenths / 16;
    const double u = (t - c) / (1 + t * c);
    const double z = u * u;
    static constexpr double taylor[] = {-1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11};
    const double tail = z * polynomial(z, taylor);
    const TwoDoubles known = at_sixteenth[static_cast<int>(sixteenths)];
    return known.hi + (u + (known.lo + u * tail));
}

/// x * 2^n, n within the exponents of normal doubles.
double scaled(double x, int n) { return x * std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52); }

}  // namespace

SineCosine sine_cosine(double x) {
    const double size = std::fabs(x);
    if (!(size < inf)) return {nan, nan};
    if (size < 0x1p-27) return {x, 1};  // keeps -0 and the smallest numbers
    const Reduced reduced = reduce_radians(size);
    SineCosine pair = turned({sine_series(reduced.rest), cosine_series(reduced.rest)}, reduced.quadrant);
    if (x < 0) pair.sine = -pair.sine;
    return pair;
}

double sine(double x) { return sine_cosine(x).sine; }
double cosine(double x) { return sine_cosine(x).cosine; }

double tangent(double x) {
    const SineCosine pair = sine_cosine(x);
    return pair.sine / pair.cosine;
}

SineCosine sine_cosine_degrees(double x) {
    const double size = std::fabs(x);
    if (!(size < inf)) return {nan, nan};
    const double turn = std::fmod(size, 360);
    const double quadrants = std::floor(turn / 90 + 0.5);
    SineCosine pair = turned(sine_cosine_of_rest_degrees(turn - 90 * quadrants), static_cast<int>(quadrants) & 3);
    if (std::signbit(x)) pair.sine = -pair.sine;
    return pair;
}

double sine_degrees(double x) { return sine_cosine_degrees(x).sine; }
double cosine_degrees(double x) { return sine_cosine_degrees(x).cosine; }

double arc_tangent(double y, double x) {
    if (std::isnan(x) || std::isnan(y)) return nan;
    constexpr double half_pi_lo = 6.123233995736766e-17, pi_lo = 1.2246467991473532e-16;  // what the doubles leave out
    const double across = std::fabs(x), up = std::fabs(y);
    const bool steep = up > across;
    const double larger = steep ? up : across, smaller = steep ? across : up;
    // Equal sizes are a case of their own, so that infinity / infinity is 1 too.
    const double ratio = larger == 0 ? 0 : smaller == larger ? 1 : smaller / larger;
    double angle = arc_tangent_of_ratio(ratio);
    if (steep) angle = half_pi - (angle - half_pi_lo);
    if (std::signbit(x)) angle = pi - (angle - pi_lo);
    return std::signbit(y) ? -angle : angle;
}

// (1 - x)(1 + x) and not 1 - x*x, which cancels near +-1.
double arc_cosine(double x) { return arc_tangent(std::sqrt((1 - x) * (1 + x)), x); }
double arc_sine(double x) { return arc_tangent(x, std::sqrt((1 - x) * (1 + x))); }

double exponential(double x) {
    constexpr double ln2_upper = 0x1.62e42feep-1, ln2_lower = 0x1.a39ef35793c76p-33;  // 32 bits: products with n exact
    if (std::isnan(x)) return nan;
    if (x > 709.79) return inf;
    if (x < -745.2) return 0;
    const double n = std::floor(x * 1.44269504088896340736 + 0.5);
    const TwoDoubles r = exact_sum(x - n * ln2_upper, -(n * ln2_lower));
    const double z = r.hi;
    static constexpr double taylor[] = {1.0 / 2,       1.0 / 6,        1.0 / 24,        1.0 / 120,
                                        1.0 / 720,     1.0 / 5040,     1.0 / 40320,     1.0 / 362880,
                                        1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};
    const double tail = polynomial(z, taylor);
    const double value = 1 + (z + (z * z * tail + r.lo));
    const int power = static_cast<int>(n), half = power / 2;  // in two steps: 2^1024 and 2^-1074 are no normal doubles
    return scaled(scaled(value, half), power - half);
}

double logarithm(double x) {
    constexpr double ln2_upper = 0x1.62e42feep-1, ln2_lower = 0x1.a39ef35793c76p-33;
    if (std::isnan(x) || x < 0) return nan;
    if (x == 0) return -inf;
    if (x == inf) return inf;
    int exponent = 0;
    if (x < std::numeric_limits<double>::min()) {
        x *= 0x1p54;
        exponent = -54;
    }
    // x = mantissa * 2^exponent with the mantissa in [sqrt 1/2, sqrt 2).
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    exponent += static_cast<int>(bits >> 52) - 1023;
    double mantissa = std::bit_cast<double>((bits & 0x000fffffffffffffu) | 0x3ff0000000000000u);
    if (mantissa > 1.41421356237309504880) {
        mantissa /= 2;
        ++exponent;
    }
    // log(1 + f) = 2 atanh s with s = f / (2 + f), written as f minus a small correction, since 2 s = f - s f.
    const double f = mantissa - 1;
    const double s = f / (2 + f);
    const double z = s * s;
    static constexpr double taylor[] = {2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11,
                                        2.0 / 13, 2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21};
    const double tail = z * polynomial(z, taylor);
    const double half_square = 0.5 * f * f;
    const double n = exponent;
    return n * ln2_upper - ((half_square - (s * (half_square + tail) + n * ln2_lower)) - f);
}

}  // namespace pinfield
