// Random expressions as trees of their own, apart from the parser's: printed as text, evaluated directly.
#pragma once
#include <string>
#include <vector>

#include "engine/core/rng.h"
#include "engine/expression/expression.h"

namespace pinfield::test {

struct Tree {
    Operation operation = Operation::literal;
    std::vector<Tree> operands;
    int number = 0;  ///< of a literal
    int name = 0;
};

/// Three names to depend on: a, b_2, c.x.
inline constexpr std::array name_texts{"a", "b_2", "c.x"};

/// A number, of at most `depth` operations within each other.
Tree random_number(CounterRng& rng, int depth);

/// With the brackets it needs, or, by chance, with some more, and blanks.
std::string printed(const Tree& tree, CounterRng& rng, double more);

/// The value by the textbook; `names` are those of name_texts. Not a number where there is none.
double direct_value(const Tree& tree, const std::array<double, 3>& names);

/// Does the parsed expression say this tree?
bool says(const Expression& expression, int node, const Tree& tree);

}  // namespace pinfield::test
