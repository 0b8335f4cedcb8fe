#include "engine/program/bvh.h"

#include <catch2/catch.hpp>
#include <set>

#include "engine/core/at.h"
#include "engine/core/rng.h"

using namespace pinfield;

namespace {

std::vector<Box2> random_boxes(CounterRng& random, int n) {
    std::vector<Box2> boxes;
    for (int i = 0; i < n; ++i) {
        const double x = random.in(-1, 1);
        const Vec2 at(x, random.in(-1, 1));
        boxes.push_back(Box2::of(at, at + Vec2(random.in(0, 0.2), i % 7 == 0 ? 2.0 : 0.05)));
    }
    if (n > 3) boxes[1] = Box2::everything(), boxes[2] = Box2::empty();
    return boxes;
}

double brute(const std::vector<Box2>& boxes, const Vec2& p) {
    double best = infinity;
    for (const Box2& box : boxes)
        if (box.is_finite() && !box.is_empty()) best = std::min(best, box.distance(p));
    return best;
}

double searched(const Bvh& bvh, const std::vector<Box2>& boxes, const Vec2& p) {
    double best = infinity;
    bvh.nearest(p, infinity, [&](int entry) {
        if (at(boxes, entry).is_finite())
            best = std::min(best, at(boxes, entry).distance(p));
        return best;
    });
    return best;
}

}  // namespace

TEST_CASE("the hierarchy finds the box that a look at every box finds") {
    CounterRng random(1);
    for (const int n : {0, 1, 2, 5, 100, 700}) {
        std::vector<Box2> boxes = random_boxes(random, n);
        Bvh bvh(boxes);
        for (int round = 0; round < 2; ++round) {
            for (int i = 0; i < 300; ++i) {
                const double x = random.in(-2, 2);
                const Vec2 p(x, random.in(-2, 2));
                REQUIRE(searched(bvh, boxes, p) == brute(boxes, p));
            }
            for (Box2& box : boxes)
                if (box.is_finite() && !box.is_empty()) box = {box.lo + Vec2(0.3, -0.1), box.hi + Vec2(0.4, 0.1)};
            bvh = Bvh(boxes);
        }
    }
}

TEST_CASE("every overlapping box is visited, an infinite one always, an empty one never") {
    CounterRng random(2);
    const std::vector<Box2> boxes = random_boxes(random, 400);
    const Bvh bvh(boxes);
    for (int i = 0; i < 200; ++i) {
        const double x = random.in(-1, 1);
        const Vec2 at(x, random.in(-1, 1));
        const Box2 query = Box2::of(at, at + Vec2(0.1, 0.1));
        std::set<int> visited;
        bvh.overlapping(query, [&](int entry) { visited.insert(entry); });
        for (std::size_t k = 0; k < boxes.size(); ++k)
            if (!boxes[k].is_empty() && boxes[k].overlaps(query)) REQUIRE(visited.count(static_cast<int>(k)) == 1);
        REQUIRE(visited.count(1) == 1);
        REQUIRE(visited.count(2) == 0);
    }
}

TEST_CASE("identical boxes and boxes in a row do not make the tree too deep") {
    std::vector<Box2> boxes(5000, Box2::of({0, 0}, {1, 1}));
    for (int i = 0; i < 3000; ++i)
        boxes.push_back(Box2::of({std::ldexp(1.0, -i % 1000), 0}, {std::ldexp(1.0, -i % 1000), 1}));
    int visits = 0;
    Bvh(boxes).nearest({0.5, 0.5}, infinity, [&](int) {
        ++visits;
        return infinity;
    });
    CHECK(visits == 8000);
}
