// A node's claims beside what is measured of them: the numbers of its page in docs/nodes/.
#pragma once
#include <vector>

#include "engine/reflect/catalog.h"

namespace pinfield::conformance {

/// What distances are measured against, from the best to the least.
enum class Reference : unsigned char {
    outline,   ///< the lines and arcs of a shape's outline
    curve,     ///< points from a shape's parametric definition
    zero_line  ///< the field's own zero line, traced
};
/// Errors up to this, in sizes, are the reference's own.
double floor_of(Reference reference);

/// One side of all the subjects that make the same claim for it and are measured alike; errors in sizes of the subject (see
/// Subject::extent()).
struct SideMeasure {
    Side claimed = Side::exact;
    Reference reference = Reference::outline;
    int subjects = 0, points = 0;
    double over = 0;   ///< largest |field| - distance
    double under = 0;  ///< largest distance - |field|
};

struct Measure {
    int subjects = 0;
    std::vector<SideMeasure> outside, inside;  ///< the exact ones first, of these the best measured
    double slope = 0, slope_claimed = 0;       ///< of the subject that comes nearest to its claim
    double float_error = -1;                   ///< in sizes; negative: no packets of its own
};

/// The defaults and `random_sets` random sets of parameters; an operation over several sets of children each. The same numbers in
/// every build, but for rounding.
Measure measure(const Catalog& catalog, const NodeType& type, int random_sets);

}  // namespace pinfield::conformance
