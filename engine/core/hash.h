// One 64-bit fingerprint of a sequence of values, for comparing states and files. Not against malice.
#pragma once
#include <bit>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

#include "engine/core/rng.h"

namespace pinfield {

/// 16 lower-case hex digits.
inline std::string hex16(std::uint64_t x) {
    std::string text(16, '0');
    for (auto digit = text.rbegin(); digit != text.rend(); ++digit, x >>= 4) *digit = "0123456789abcdef"[x & 15];
    return text;
}

/// Depends on the order and the count of what is fed. A double counts by its bits: 0 and -0 differ.
class Hash64 {
public:
    /// Any integer, widened to 64 bits.
    template <std::integral T>
    constexpr Hash64& feed(T x) {
        state_ = mixed_bits((state_ ^ mixed_bits(static_cast<std::uint64_t>(x) + step)) * step + 1);
        return *this;
    }
    constexpr Hash64& feed(double x) { return feed(std::bit_cast<std::uint64_t>(x)); }
    /// Its bytes in little-endian words of eight, then its length: "ab", "c" and "a", "bc" differ.
    constexpr Hash64& feed(std::string_view text) {
        std::uint64_t word = 0;
        for (std::size_t i = 0; i < text.size(); ++i) {
            word |= std::uint64_t{static_cast<unsigned char>(text[i])} << (8 * (i % 8));
            if (i % 8 == 7 || i + 1 == text.size()) {
                feed(word);
                word = 0;
            }
        }
        return feed(text.size());
    }
    constexpr std::uint64_t value() const { return state_; }
    std::string hex() const { return hex16(state_); }

private:
    static constexpr std::uint64_t step = 0x9e3779b97f4a7c15u;  // odd, well spread
    std::uint64_t state_ = 0x70696e6669656c64u;  // "pinfield"
};

}  // namespace pinfield
