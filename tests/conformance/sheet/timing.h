// What a node costs, in nanoseconds a point.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/reflect/catalog.h"

namespace pinfield::conformance {

/// The node's own work, without its children's: a shape's distance, one combination of two fields, one change of a field, one point
/// sent elsewhere. Nothing where the node does no work a point, as a mirror, which only places its child.
struct Timing {
    std::optional<double> in_double;  ///< ns a point
    std::optional<double> in_packets;
    std::string isa;  ///< of the packets
};
/// Median over several batches, in this process' own time, at the node's defaults.
Timing time_of(const Catalog& catalog, const NodeType& type);

/// Timings differ from run to run, so that they are kept in a file of their own: pages are written from it, and are stale or fresh
/// whatever the machine.
using Timings = std::map<std::string, Timing, std::less<>>;
std::string csv_of(const Catalog& catalog, const Timings& timings);
Result<Timings> read_timings(const std::string& csv);

}  // namespace pinfield::conformance
