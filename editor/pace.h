// When a frame is due, and whether the table keeps real time. No window, no ImGui.
#pragma once
#include <algorithm>
#include <vector>

#include "engine/physics/world.h"

namespace pinfield::editor {

/// What a frame might be drawn for.
struct Stir {
    bool events = false;  ///< something happened to the window, a key or button is held, or there is something new to say
    bool table = false;   ///< the table would look different from the last frame
    bool hidden = false;  ///< nobody sees the window
};

/// Frames that look like the last one are not drawn. After anything that happened a few are, for what one of them lays out is seen in
/// the next.
class FramePace {
public:
    bool due(const Stir& stir);
    void drawn() { settling_ -= settling_ > 0 ? 1 : 0; }

private:
    static constexpr int settling_frames = 4;
    int settling_ = settling_frames;  ///< frames still to be drawn, whatever happens
};

/// Balls and movers as the last frame showed them.
class ShownTable {
public:
    void take(const World& world);
    /// Whether one of them has moved since by more than `tolerance`: metres, radians of a mover that turns.
    bool differs(const World& world, double tolerance) const;

private:
    ProgramPtr program_;
    std::vector<double> places_;
};

/// How much of real time the table has been given, judged once a second: one second that misses some is a stall, two are slowness.
class RealTime {
public:
    /// Seconds of the clock, and how many of them the table went on.
    void add(double passed, double played);
    /// 1: all of it.
    double share() const { return std::max(share_, share_before_); }

private:
    double passed_ = 0, played_ = 0, share_ = 1, share_before_ = 1;
};

}  // namespace pinfield::editor
