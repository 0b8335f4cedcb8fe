#include "editor/snap.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/rng.h"

using namespace pinfield;
using namespace pinfield::editor;

namespace {

constexpr double reach = 0.01;

std::array<double, 3> lines(const Box2& box, int axis) { return {box.lo[axis], box.centre()[axis], box.hi[axis]}; }

Box2 pushed(Box2 box, int axis, double push) {
    box.lo[axis] += push;
    box.hi[axis] += push;
    return box;
}

/// The least push onto a line of another.
double least_to_line(const Box2& moved, const std::vector<Box2>& others, int axis) {
    double least = infinity;
    for (const Box2& other : others)
        for (const double there : lines(other, axis))
            for (const double here : lines(moved, axis)) least = std::min(least, std::fabs(there - here));
    return least;
}

bool shares_row(const Box2& a, const Box2& b, int axis) {
    const int across = 1 - axis;
    return std::min(a.hi[across], b.hi[across]) > std::max(a.lo[across], b.lo[across]);
}

/// Whether three stand in a row with equal gaps and nothing of the moved one's row has an edge in those.
bool evenly(const Box2& a, const Box2& b, const Box2& c, const Box2& moved, const std::vector<Box2>& others, int axis) {
    const double first = b.lo[axis] - a.hi[axis], second = c.lo[axis] - b.hi[axis];
    if (first <= 1e-9 || std::fabs(first - second) > 1e-9) return false;
    for (const Box2& other : others)
        for (const double edge : {other.lo[axis], other.hi[axis]})
            if (shares_row(other, moved, axis) &&
                ((edge > a.hi[axis] + 1e-9 && edge < b.lo[axis] - 1e-9) || (edge > b.hi[axis] + 1e-9 && edge < c.lo[axis] - 1e-9)))
                return false;
    return shares_row(a, b, axis) && shares_row(b, c, axis) && shares_row(a, c, axis);
}

/// Brute force: every two of the others and the moved one in every order, at the push that may make their gaps equal.
double least_to_equal_gaps(const Box2& moved, const std::vector<Box2>& others, int axis) {
    double least = infinity;
    for (const Box2& a : others)
        for (const Box2& b : others)
            for (const int place : {0, 1, 2}) {
                const double gap = b.lo[axis] - a.hi[axis];
                const double push = place == 0   ? a.lo[axis] - gap - moved.hi[axis]
                                    : place == 2 ? b.hi[axis] + gap - moved.lo[axis]
                                                 : 0.5 * (a.hi[axis] + b.lo[axis]) - moved.centre()[axis];
                const Box2 there = pushed(moved, axis, push);
                const bool even = place == 0   ? evenly(there, a, b, moved, others, axis)
                                  : place == 2 ? evenly(a, b, there, moved, others, axis)
                                               : evenly(a, there, b, moved, others, axis);
                if (even) least = std::min(least, std::fabs(push));
            }
    return least;
}

/// Boxes whose places come from few values, so that rows are frequent.
class RandomBoxes {
public:
    explicit RandomBoxes(std::uint64_t seed) : rng_(seed) {}
    Box2 box() {
        const double x = rng_.uniform(), y = 0.3 * rng_.uniform(), w = 0.02 + 0.1 * rng_.uniform(), h = 0.02 + 0.2 * rng_.uniform();
        return {{x, y}, {x + w, y + h}};
    }
    std::vector<Box2> boxes() {
        std::vector<Box2> all{{{0, 0}, {1.2, 0.6}}};  // the table's own
        for (std::uint64_t n = 2 + rng_.next_u64() % 5; n > 0; --n) all.push_back(box());
        return all;
    }

private:
    CounterRng rng_;
};

}  // namespace

TEST_CASE("a snap is the least push within its reach onto a line of another or to equal gaps") {
    RandomBoxes random(3);
    int on_lines = 0, at_gaps = 0;
    for (int round = 0; round < 20'000; ++round) {
        const std::vector<Box2> others = random.boxes();
        const Box2 moved = random.box();
        const Snap found = snap(moved, others, reach);
        for (const int axis : {0, 1}) {
            const double line = least_to_line(moved, others, axis), gaps = least_to_equal_gaps(moved, others, axis),
                         least = std::min(line, gaps);
            REQUIRE(found.axis[axis] == (least <= reach));
            REQUIRE(std::fabs(std::fabs(found.push[axis]) - (found.axis[axis] ? least : 0)) <= 2e-9);
            on_lines += found.axis[axis] && line < gaps;
            at_gaps += found.axis[axis] && gaps < line;
        }
    }
    CHECK(on_lines > 1000);
    CHECK(at_gaps > 300);
}

TEST_CASE("what has snapped is at its place to 1e-9, and the lines that say why are true of it") {
    RandomBoxes random(4);
    int lines_seen = 0, gaps_seen = 0;
    for (int round = 0; round < 5'000; ++round) {
        const std::vector<Box2> others = random.boxes();
        const Box2 moved = random.box();
        const Snap found = snap(moved, others, reach);
        const Box2 there{moved.lo + found.push, moved.hi + found.push};
        REQUIRE(found.lines.empty() == (!found.axis[0] && !found.axis[1]));
        std::vector<double> gaps[2];
        for (const SnapLine& line : found.lines) {
            const bool is_gap = line.kind == SnapLine::Kind::gap;
            const int axis = is_gap ? (line.a.y() == line.b.y() ? 0 : 1) : line.a.x() == line.b.x() ? 0 : 1;
            const auto touches = [&](const Box2& box) {
                const auto l = lines(box, axis);
                return std::any_of(l.begin(), l.end(), [&](double x) { return std::fabs(x - line.a[axis]) <= 1e-9; });
            };
            if (is_gap) {
                gaps[axis].push_back(line.b[axis] - line.a[axis]);
                continue;
            }
            ++lines_seen;
            REQUIRE(touches(there));
            REQUIRE(std::any_of(others.begin(), others.end(), touches));
        }
        for (const auto& both : gaps) {
            REQUIRE((both.empty() || both.size() == 2));
            if (both.empty()) continue;
            ++gaps_seen;
            REQUIRE(std::fabs(both[0] - both[1]) <= 1e-9);
            REQUIRE(both[0] > 0);
        }
        // And it rests there: what was pushed along one axis is not pushed any further along that.
        for (const int axis : {0, 1})
            if (found.axis[axis]) REQUIRE(std::fabs(snap(pushed(moved, axis, found.push[axis]), others, reach).push[axis]) <= 2e-9);
    }
    CHECK(lines_seen > 300);
    CHECK(gaps_seen > 100);
}

TEST_CASE("the third of three in a row comes as far from the second as that is from the first") {
    const std::vector<Box2> two{{{0, 0}, {0.1, 0.1}}, {{0.15, 0.02}, {0.25, 0.12}}};
    const Snap found = snap({{0.304, 0.047}, {0.331, 0.094}}, two, 0.006);
    CHECK(found.push.x() == Approx(-0.004).margin(1e-12));
    CHECK(std::count_if(found.lines.begin(), found.lines.end(), [](const SnapLine& line) { return line.kind == SnapLine::Kind::gap; }) ==
          2);
    const Snap below = snap({{0.304, 0.347}, {0.331, 0.394}}, two, 0.006);  // in no row with them
    CHECK_FALSE(below.axis[0]);
}
