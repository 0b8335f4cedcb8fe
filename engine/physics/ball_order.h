// Which balls may be near each other: balls in order of their places along the axis along which they are spread farther, so that who is
// within reach of a place is found without asking all of them (sweep and prune: Baraff, "Dynamic simulation of non-penetrating rigid
// bodies", 1992). Not part of the layer's interface.
#pragma once
#include <span>
#include <vector>

#include "engine/core/at.h"
#include "engine/physics/ball.h"

namespace pinfield {

class BallOrder {
public:
    /// The balls on the table, where they are now.
    void take(std::span<const Ball> balls);
    /// Where ball i was when they were taken.
    const Vec2& place(std::size_t i) const { return places_[i]; }
    /// The balls that were then at most `reach` metres from p, by their indices, in ascending order.
    void near(const Vec2& p, double reach, std::vector<int>& out) const;

private:
    struct Entry {
        double along = 0;
        int ball = 0;
    };
    int axis_ = 0;
    std::vector<Entry> entries_;
    std::vector<Vec2> places_;
};

}  // namespace pinfield
