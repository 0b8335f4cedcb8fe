// Random numbers by counting: the n-th number of a stream is a pure function of (seed, stream, n), so that adding a
// consumer never shifts the numbers of another, and a saved game needs to keep only the counter. The mixer is the
// finaliser of SplitMix64 (Steele, Lea, Flood, "Fast splittable pseudorandom number generators", 2014).
#pragma once
#include <cstdint>

namespace pinfield {

/// Bijective scrambling of 64 bits: each input bit flips each output bit half the time.
constexpr std::uint64_t mixed_bits(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

class CounterRng {
public:
    constexpr explicit CounterRng(std::uint64_t seed, std::uint64_t stream = 0)
        : key_(mixed_bits(mixed_bits(seed + golden) + stream * golden)) {}

    constexpr std::uint64_t next_u64() { return mixed_bits(key_ + ++counter_ * golden); }
    /// Uniform in [0, 1), a multiple of 2^-53.
    constexpr double uniform() { return static_cast<double>(next_u64() >> 11) * 0x1p-53; }
    /// Uniform in [lo, hi).
    constexpr double in(double lo, double hi) { return lo + (hi - lo) * uniform(); }

    /// How many numbers were drawn; setting it back replays them.
    constexpr std::uint64_t counter() const { return counter_; }
    constexpr void set_counter(std::uint64_t counter) { counter_ = counter; }

private:
    static constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio, odd: steps spread evenly
    std::uint64_t key_;
    std::uint64_t counter_ = 0;
};

}  // namespace pinfield
