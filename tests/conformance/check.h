// The battery's front door: one shape or operation, the engine's or your own, under every law, in one line of a test:
//
//     CHECK(pinfield::conformance::check<MyShape>());
//
// A Report is true when no law was broken. Test frameworks that print what they compare (Catch2, doctest, GoogleTest) print it as a
// list of the broken laws with examples; so does any stream. Link `pinfield_conformance`, which needs no framework itself.
#pragma once
#include <iosfwd>
#include <string>
#include <vector>

#include "engine/reflect/catalog.h"
#include "engine/sdf/own_node.h"
#include "tests/conformance/witness.h"

namespace pinfield::conformance {

struct Violation {
    std::string law;      ///< a sentence: "no side over-estimates"
    std::string subject;  ///< the node with its parameters
    std::string what;     ///< where, and the numbers that disagree
};

struct Report {
    std::string node;  ///< its key
    std::vector<Violation> violations;

    explicit operator bool() const { return violations.empty(); }
    bool breaks(std::string_view law) const;
};

/// "shield obeys every law", or each broken law with how many sets of parameters break it and the first few of them.
std::string text(const Report& report);
std::ostream& operator<<(std::ostream& out, const Report& report);

/// A built-in node type with default, random and degenerate parameters, the same ones in every run. `catalog` provides circle, box,
/// intersection and complement as children of operations.
Report check(const Catalog& catalog, const NodeType& type, int random_sets);
/// Any node type, of which the laws know what the witness says; it need not be in the catalog.
Report check(const Catalog& catalog, const NodeType& type, const Witness& witness, int random_sets);
/// The same over the built-in catalog.
Report check(const NodeType& type, const Witness& witness, int random_sets);

/// Node template N: what sdf_node_type<N>() gives a program's own catalog. A shape that is not of lines and arcs may have its outline
/// checked against a parametric one.
template <template <class> class N>
Report check(int random_sets = 40, ParametricOutline outline = nullptr) {
    return check(sdf::sdf_node_type<N>(), {sdf::enclosures<N>(), outline}, random_sets);
}

}  // namespace pinfield::conformance
