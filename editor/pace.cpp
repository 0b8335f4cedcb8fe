#include "editor/pace.h"

#include <cmath>

namespace pinfield::editor {
namespace {

std::vector<double> places_of(const World& world) {
    std::vector<double> places;
    for (const Ball& ball : world.balls())
        places.insert(places.end(), {ball.position.x(), ball.position.y(), ball.state == BallState::drained ? 1e9 : 0.0});
    for (const MoverState& mover : world.movers()) places.push_back(mover.q);
    return places;
}

}  // namespace

bool FramePace::due(const Stir& stir) {
    if (stir.events) settling_ = settling_frames;
    return stir.hidden ? stir.events : settling_ > 0 || stir.table;
}

void ShownTable::take(const World& world) {
    program_ = world.shared_program();
    places_ = places_of(world);
}

bool ShownTable::differs(const World& world, double tolerance) const {
    const std::vector<double> places = places_of(world);
    if (world.shared_program() != program_ || places.size() != places_.size()) return true;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (!(std::fabs(places[i] - places_[i]) <= tolerance)) return true;
    return false;
}

void RealTime::add(double passed, double played) {
    passed_ += passed;
    played_ += played;
    if (passed_ < 1) return;
    share_before_ = share_;
    share_ = played_ / passed_;
    passed_ = played_ = 0;
}

}  // namespace pinfield::editor
