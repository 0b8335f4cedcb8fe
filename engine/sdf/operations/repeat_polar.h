#pragma once
#include <span>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/core/trig.h"
#include "engine/reflect/describe.h"

namespace pinfield::sdf {

/// Copies of the child at equal angles about the local origin, united: exact outside wherever the child is.
template <class Real>
struct RepeatPolar {
    int count = 6;

    std::vector<Similarity> images() const {
        std::vector<Similarity> out;
        for (int i = 0; i < count; ++i) {
            const SineCosine turn = sine_cosine_degrees(360.0 * i / count);
            out.push_back({.cosine = turn.cosine, .sine = turn.sine});
        }
        return out;
    }
    Exactness exactness(std::span<const Exactness> children) const {
        Exactness out = children[0];
        if (count > 1) out.inside = Side::bound;
        return out;
    }

    static constexpr auto describe() {
        return operation<RepeatPolar>(
            {.key = "repeat_polar",
             .exactness = {.inside = Side::bound},
             .children = {1, 1},
             .doc = "Copies of the child at equal angles about the local origin."},
            fields(field(
                "count", &RepeatPolar::count,
                {.min = from(1), .max = to(360), .step = 1, .meaning = Meaning::count, .doc = "How many, the child itself included."})));
    }
};

}  // namespace pinfield::sdf
