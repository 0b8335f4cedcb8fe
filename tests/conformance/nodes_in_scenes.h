// A node of the battery as it stands in a table: the same parameters, compiled.
#pragma once
#include "tests/conformance/parameters.h"
#include "tests/program/tables.h"

namespace pinfield::conformance {

inline NodeId add_with(Scene& scene, const NodeType& type, const Values& values, NodeId parent = {}) {
    Node& node = scene.add(type, parent);
    for (std::size_t i = 0; i < values.size(); ++i) {
        node.fields[i].value = values[i];
        node.fields[i].is_explicit = true;
    }
    return node.id;
}

/// The index of the static solid that a node of the scene's root became.
inline int solid_of(const Program& program, NodeId node) {
    for (std::size_t i = 0; i < program.fixed.solids.size(); ++i)
        if (program.fixed.solids[i].origin == node) return static_cast<int>(i);
    return -1;
}

/// Its defaults, and random parameters that ranges and contracts accept.
inline std::vector<Values> some_values(const NodeType& type, int random_sets) {
    std::vector<Values> out{defaults_of(type)};
    CounterRng rng(77);
    for (int i = 0; i < random_sets && type.own_fields > 0; ++i) out.push_back(random_values(type, rng));
    return out;
}

}  // namespace pinfield::conformance
