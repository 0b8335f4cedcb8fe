#include "engine/physics/ball_order.h"

#include <algorithm>

namespace pinfield {

void BallOrder::take(std::span<const Ball> balls) {
    places_.clear();
    Box2 box;
    const auto counts = [](const Ball& ball) { return is_on_table(ball) && ball.position.allFinite(); };
    for (const Ball& ball : balls) {
        places_.push_back(ball.position);
        if (counts(ball)) box = box.merged(Box2::of(ball.position, ball.position));
    }
    axis_ = !box.is_empty() && box.size().y() > box.size().x() ? 1 : 0;
    entries_.clear();
    for (std::size_t i = 0; i < balls.size(); ++i)
        if (counts(balls[i])) entries_.push_back({places_[i][axis_], static_cast<int>(i)});
    std::sort(entries_.begin(), entries_.end(),
              [](const Entry& a, const Entry& b) { return a.along != b.along ? a.along < b.along : a.ball < b.ball; });
}

void BallOrder::near(const Vec2& p, double reach, std::vector<int>& out) const {
    out.clear();
    const double spare = 1e-12 * (reach + std::fabs(p[axis_])), from = p[axis_] - reach - spare, to = p[axis_] + reach + spare;
    auto entry = std::lower_bound(entries_.begin(), entries_.end(), from, [](const Entry& e, double value) { return e.along < value; });
    for (; entry != entries_.end() && entry->along <= to; ++entry) {
        const Vec2 apart = at(places_, entry->ball) - p;
        if (dot(apart, apart) <= reach * reach) out.push_back(entry->ball);
    }
    std::sort(out.begin(), out.end());
}

}  // namespace pinfield
