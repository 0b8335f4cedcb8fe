// An expression of x and y as the reals that a node's block holds of it: what the author's text says, read once, evaluated over any scalar by
// the one evaluation that all expressions have.
#pragma once
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/core/point.h"
#include "engine/core/source_text.h"
#include "engine/expression/evaluate.h"

namespace pinfield {

struct TextFault;  // engine/reflect/text_fault.h

namespace sdf {

/// An ExpressionNode of the block. A name is 0 for x, 1 for y.
struct Step {
    Operation operation;
    std::array<int, 3> operands;
    double value;  ///< of a literal; of a choice: 1 where its branches are known to meet
};

/// A view of the block. Its tree is not the text's letter for letter: what is constant is folded, `x * x` is a square, the root of two
/// squares a length, `abs(atan2(y, x))` an angle that does not jump, and zeros that are divided by or turned by have no sign: all with the
/// same values, and known to be what they are wherever boxes stand for points.
struct Steps {
    std::string_view text{};  ///< as a member's initialiser: what it says by default
    const double* reals = nullptr;
    int count = 0;

    /// operation, three operands, value, and the bytes of the text
    static constexpr int reals_of_step = 7;
    int size() const { return count / reals_of_step; }
    const double* step(int index) const { return reals + index * reals_of_step; }
    Span span_of(int index) const {
        return {static_cast<std::size_t>(step(index)[5]), static_cast<std::size_t>(step(index)[6])};
    }

    /// Of the text of a formula: x and y are lengths, and so must be what it comes to.
    static std::optional<TextFault> pack(std::string_view text, std::vector<double>& block);
};

inline Step node_at(const Steps& steps, int index) {
    const double* reals = steps.step(index);
    const auto whole = [&](int i) { return static_cast<int>(reals[i]); };
    return {static_cast<Operation>(whole(0)), {whole(1), whole(2), whole(3)}, reals[4]};
}

/// A step of the formula at p, in metres, infinite where it is. Of scalars that have the functions of dual_functions.h.
template <class Real>
Real value_at(const Steps& steps, const Point<Real>& p, int step) {
    const Real names[2] = {p.x, p.y};
    return expressions::Evaluation<Real, Steps>(steps, names).number(step);
}
/// The whole; of a text that could not be read, which is refused elsewhere, 0.
template <class Real>
Real value_at(const Steps& steps, const Point<Real>& p) {
    return steps.count > 0 ? value_at(steps, p, steps.size() - 1) : Real(0);
}

}  // namespace sdf
}  // namespace pinfield
