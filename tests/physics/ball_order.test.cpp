#include "engine/physics/ball_order.h"

#include <catch2/catch.hpp>
#include <limits>

#include "engine/core/rng.h"

using namespace pinfield;

namespace {

/// Balls strewn over a box of this size; of ten one each is drained, taken out, and not finite.
std::vector<Ball> strewn(CounterRng& random, const Vec2& size, int count) {
    std::vector<Ball> balls(static_cast<std::size_t>(count));
    for (Ball& ball : balls) {
        const double x = random.in(0, size.x());
        ball.position = {x, random.in(0, size.y())};
        const double draw = random.in(0, 10);
        if (draw < 1) ball.state = BallState::drained;
        else if (draw < 2) ball.state = BallState::quarantined;
        else if (draw < 3) ball.position.y() = std::numeric_limits<double>::quiet_NaN();
    }
    return balls;
}

bool counts(const Ball& ball) { return is_on_table(ball) && ball.position.allFinite(); }

}  // namespace

TEST_CASE("the balls within reach of a place are those of which each, asked alone, is") {
    CounterRng random(1, 0);
    BallOrder order;  // one for all, as from tick to tick
    std::vector<int> found;
    for (int round = 0; round < 300; ++round) {
        const double width = random.in(0.01, 1), height = random.in(0.01, 1);
        const std::vector<Ball> balls = strewn(random, {width, height}, round % 70);
        order.take(balls);
        for (const Ball& about : balls) {
            if (!counts(about)) continue;
            const double reach = random.in(0, 0.3);
            std::vector<int> expected;
            for (std::size_t j = 0; j < balls.size(); ++j) {
                const Vec2 apart = balls[j].position - about.position;
                if (counts(balls[j]) && dot(apart, apart) <= reach * reach) expected.push_back(static_cast<int>(j));
            }
            order.near(about.position, reach, found);
            CHECK(found == expected);
        }
    }
}

TEST_CASE("a ball at exactly the reach is within it, along either axis") {
    BallOrder order;
    std::vector<int> found;
    for (const Vec2& away : {Vec2(0.3, 0), Vec2(0, 0.3)}) {
        std::vector<Ball> balls(2);
        balls[0].position = {0.1, 0.1};
        balls[1].position = balls[0].position + away;
        order.take(balls);
        order.near(balls[0].position, length(Vec2(balls[1].position - balls[0].position)), found);
        CHECK(found == std::vector<int>{0, 1});
    }
}
