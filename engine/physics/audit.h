// The independent check of the promise: dense samples of every path segment against the true distance and other balls, never the sweep.
#pragma once
#include <cstdint>

#include "engine/physics/world.h"

namespace pinfield {

struct AuditReport {
    std::int64_t segments = 0;
    double worst_depth = 0;       ///< metres by which a ball overlapped a solid, at any sample and at the end of any tick
    double worst_overlap = 0;     ///< metres by which two balls overlapped, at any time
    std::int64_t crossings = 0;   ///< segments that ended on the other side of a solid, or had their centre inside one; balls that stood there
};

/// Metres by which any two balls in play overlap now; 0 where they do not, or ignore each other.
double overlap_of_balls(const World& world);

/// Feed it after every tick of a world that records its paths. Samples are spaced by at most `spacing` of path (at least 8 a segment);
/// movers are taken at their own place at each sample's time. Between two samples that are near a surface it also looks for a
/// boundary that lies between them, so that a jump over a wall thinner than the spacing does not go unseen.
class Auditor {
public:
    explicit Auditor(double spacing = 1e-3) : spacing_(spacing) {}
    void after_tick(const World& world);
    const AuditReport& report() const { return report_; }

private:
    void check(const World& world, const PathSegment& path);
    void check_places(const World& world);
    void check_pairs(const World& world);

    double spacing_;
    AuditReport report_;
    std::vector<double> q_;  ///< of the movers at the sample's time
};

}  // namespace pinfield
