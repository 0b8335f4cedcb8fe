// The sheet as text: a page a node, and the index of all.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "tests/conformance/sheet/measure.h"
#include "tests/conformance/sheet/timing.h"

namespace pinfield::conformance {

/// All that is told of a node.
struct Entry {
    const NodeType* type = nullptr;
    Measure measure;
    Timing timing;
    std::string example;  ///< the text of its scene
};

/// Where the node's formula is, from the project's root.
std::string header_of(const NodeType& type);
std::string page_of(const Entry& entry);
std::string index_of(std::span<const Entry> entries);

/// An error as one digit, rounded up, so that the last bits of a compiler or a library do not show: 0.0321 is "0.04". Errors that may
/// be the reference's own are "< 1e-06".
std::string at_most(double error, double floor);

}  // namespace pinfield::conformance
