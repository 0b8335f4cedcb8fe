// What a distance may be trusted for.
#pragma once

namespace pinfield {

/// exact: the true distance. bound: never above it in absolute value (a step of that length is safe).
enum class Side : unsigned char { exact, bound };

/// Per side of the outline, and the Lipschitz constant |f(p) - f(q)| <= lipschitz |p - q|.
struct Exactness {
    Side outside = Side::exact, inside = Side::exact;
    double lipschitz = 1;
    constexpr bool operator==(const Exactness&) const = default;
};

}  // namespace pinfield
