#pragma once
#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"

namespace pinfield::sdf {

/// A local axis: `x` names the line x = 0, the one that reflecting x leaves alone.
enum class Axis : unsigned char { x, y };
constexpr std::array<std::string_view, 2> choice_names(Axis) { return {"x", "y"}; }

/// The child and its reflection, united: exact outside wherever the child is, also where the two overlap.
template <class Real>
struct Mirror {
    Axis across = Axis::x;

    std::vector<Similarity> images() const {
        Similarity reflection{.mirrored = true};  // negates y
        if (across == Axis::x) reflection.cosine = -1;
        return {Similarity{}, reflection};
    }
    static Exactness exactness(std::span<const Exactness> children) {
        return {children[0].outside, Side::bound, children[0].lipschitz};
    }

    static constexpr auto describe() {
        return operation<Mirror>({.key = "mirror",
                                  .exactness = {.inside = Side::bound},
                                  .children = {1, 1},
                                  .doc = "The child and its reflection in the local line x = 0 (or y = 0)."},
                                 fields(field("across", &Mirror::across, {.doc = "The coordinate that changes its sign."})));
    }
};

}  // namespace pinfield::sdf
