// Numbers that change with time: what a table writes as {spin: ...}, {wave: ...} or {keys: ...}. Pure functions of the time: nothing is
// stepped, so that any moment can be asked for by itself, and the same moment has the same bits.
#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace pinfield {

/// from + rate t.
struct SpinMotion {
    double rate = 0, from = 0;
    bool operator==(const SpinMotion&) const = default;
};

/// low + (high - low) (1 + sin(2 pi t / period + phase)) / 2: with phase 0 it begins in the middle and goes towards `high`. The phase is an
/// angle in radians, as every angle inside; low may be the greater one.
struct WaveMotion {
    double low = 0, high = 0, period = 1, phase = 0;
    bool operator==(const WaveMotion&) const = default;
};

struct MotionKey {
    double time = 0, value = 0;
    bool operator==(const MotionKey&) const = default;
};

/// Straight from key to key; before the first it is the first's value, after the last the last's. One that loops repeats what lies between
/// its first and its last time for ever, in both directions of time.
struct KeyedMotion {
    std::vector<MotionKey> keys;
    bool loop = false;
    bool operator==(const KeyedMotion&) const = default;
};

struct NumberMotion {
    std::variant<SpinMotion, WaveMotion, KeyedMotion> kind;

    double value_at(double t) const;
    /// How much the value changes in a second at most; no smaller number would do.
    double rate_bound() const;

    /// All values it ever has; without end for what spins.
    struct Range {
        double low, high;
    };
    Range range() const;

    /// The same with the opposite sign, as seen in a mirror: the same bits but for the sign.
    NumberMotion negated() const;
    /// Why it is no motion, in words for the author: numbers that are not finite, a period that is not above 0, keys whose times do not
    /// increase, a loop that would jump. The functions above ask for one without a fault.
    std::optional<std::string> fault() const;

    bool operator==(const NumberMotion&) const = default;
};

}  // namespace pinfield
