#pragma once
#include <span>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"

namespace pinfield::sdf {

/// A grid of copies of the child, centred on where the child would stand, united. Every copy is asked, so that the distance is right
/// however far the child reaches out of its cell: exact outside wherever the child is.
template <class Real>
struct Repeat {
    static constexpr int most_copies = 1024;

    Point<Real> count{Real(3), Real(1)};
    Point<Real> step{Real(0.05), Real(0.05)};

    std::vector<Similarity> images() const {
        std::vector<Similarity> out;
        for (int j = 0; j < static_cast<int>(count.y); ++j)
            for (int i = 0; i < static_cast<int>(count.x); ++i)
                out.push_back(Similarity::translation({step.x * (i - 0.5 * (count.x - 1)), step.y * (j - 0.5 * (count.y - 1))}));
        return out;
    }
    Exactness exactness(std::span<const Exactness> children) const {
        Exactness out = children[0];
        if (count.x * count.y > 1) out.inside = Side::bound;
        return out;
    }

    static constexpr auto describe() {
        return operation<Repeat>(
            {.key = "repeat", .exactness = {.inside = Side::bound}, .children = {1, 1}, .doc = "A grid of copies of the child, centred on its origin."},
            fields(field("count", &Repeat::count,
                         {.min = from(1),
                          .max = to(most_copies),
                          .step = 1,
                          .meaning = Meaning::count,
                          .doc = "Columns and rows: whole numbers."}),
                   field("step", &Repeat::step, {.unit = Unit::metre, .step = 0.001, .doc = "From one column, and one row, to the next."})),
            contract("whole numbers of columns and rows",
                     [](const auto& r) { return r.count.x == static_cast<int>(r.count.x) && r.count.y == static_cast<int>(r.count.y); }),
            contract("at most 1024 copies", [](const auto& r) { return r.count.x * r.count.y <= most_copies; }));
    }
};

}  // namespace pinfield::sdf
