// What the distances of a table's nodes may be trusted for, as compiled with their children and values: for `check --verbose`, the
// editor's badge, and the warnings that follow from it.
#pragma once
#include <map>
#include <optional>

#include "engine/core/diagnostic.h"
#include "engine/program/program.h"
#include "engine/scene/scene.h"

namespace pinfield {

struct DistanceQuality {
    Exactness formula;            ///< of the node's own formula over its children
    bool boundary_known = false;  ///< its boundary was found and is asked in the formula's place: right on both sides
    double fit_error = 0;         ///< ... within that many metres; if 0, exact

    /// A fitted boundary is right for all that is done with it, but not exact.
    Exactness exactness() const { return boundary_known && fit_error == 0 ? Exactness{} : formula; }
};

/// Of every scene node that has a field: shapes, operations, and parts made of them.
std::map<NodeId, DistanceQuality> distance_qualities_of(const Program& program);
/// Of one node; nothing when it has no field.
std::optional<DistanceQuality> distance_quality_of(const Program& program, NodeId node);

/// What is doubtful about a program that runs, placed in the text of the scene it was compiled from: offsets (round, inset, onion) of a
/// side that is only a bound and whose boundary could not be found, solids on layers that no ball is on, solids of which nothing is left, and
/// solids that have an end and no boundary that was found: balls meet those by their formula.
Diagnostics warnings_of(const Program& program, const Scene& scene);

}  // namespace pinfield
