// The enclosures of all built-in nodes, each family's compiled in a unit of its own, made from family_enclosures.cpp.in.
#pragma once
#include <map>
#include <string_view>

#include "engine/sdf/node_list.h"
#include "tests/conformance/enclosures.h"

namespace pinfield::conformance {

using EnclosuresByKey = std::map<std::string_view, sdf::Enclosures>;

template <template <class> class... N>
void add_enclosures(sdf::NodeList<N...>, EnclosuresByKey& out) {
    ((out[N<double>::describe().meta.key] = sdf::enclosures<N>()), ...);
}

/// By the names of the nodes.
EnclosuresByKey all_enclosures();

}  // namespace pinfield::conformance
