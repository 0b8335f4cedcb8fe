// Clearance: a time during which a moving ball is certified clear of a solid, per side, as a scalar of CSG formulas.
#pragma once

namespace pinfield::sdf {

/// For a solid with field f, a moving point and margins: `outside` is a time for which f stays above the outer margin,
/// `inside` a time for which -f stays above the inner one; 0 where it does not hold even now. min, max and minus of fields
/// turn into these operations, so a CSG formula evaluated over Clearance is its own rule of conservative advancement:
/// a union is clear outside as long as both are, and clear inside as long as either is.
struct Clearance {
    double outside = 0, inside = 0;  ///< seconds
};

inline Clearance operator-(const Clearance& a) { return {a.inside, a.outside}; }
inline Clearance min(const Clearance& a, const Clearance& b) {
    return {a.outside < b.outside ? a.outside : b.outside, a.inside < b.inside ? b.inside : a.inside};
}
inline Clearance max(const Clearance& a, const Clearance& b) { return -min(-a, -b); }

}  // namespace pinfield::sdf
