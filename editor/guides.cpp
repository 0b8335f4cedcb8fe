#include "editor/guides.h"

#include <algorithm>
#include <cmath>

#include "editor/edit_tools.h"
#include "engine/core/numbers.h"

namespace pinfield::editor {

std::optional<std::size_t> guide_at(std::span<const Guide> guides, const Vec2& world, double reach) {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < guides.size(); ++i) {
        const double distance = std::fabs(world[guides[i].axis] - guides[i].at);
        if (distance > reach) continue;
        reach = distance;
        best = i;
    }
    return best;
}

double guide_place(double hand, int axis, std::span<const Box2> boxes, double reach, double grid) {
    double best = on_grid(hand, grid);
    for (const Box2& box : boxes)
        for (const double line : {box.lo[axis], box.centre()[axis], box.hi[axis]}) {
            if (!(std::fabs(line - hand) <= reach)) continue;
            reach = std::fabs(line - hand);
            best = line;
        }
    return best;
}

std::vector<Box2> boxes_of(std::span<const Guide> guides, const Vec2& table) {
    std::vector<Box2> boxes;
    for (const Guide& guide : guides) {
        Box2 box{{0, 0}, table};
        box.lo[guide.axis] = box.hi[guide.axis] = guide.at;
        boxes.push_back(box);
    }
    return boxes;
}

std::string RulerScale::label(long long i) const {
    const double shown = static_cast<double>(i) * (step >= 1 ? step : 1000 * step);
    return i == 0 ? "0" : to_text(shown, step < 1e-3 ? (step < 1e-4 ? 2 : 1) : 0);
}

RulerScale ruler_scale(double pixels_per_metre, double least_pixels) {
    constexpr double least_step = 1e-5, most_step = 1e5, least_tick = 4;  // metres, metres, pixels
    for (double decade = least_step; decade < most_step; decade *= 10)
        for (const int leading : {1, 2, 5}) {
            const double step = leading * decade, pixels = step * pixels_per_metre;
            if (pixels < least_pixels) continue;
            for (const int parts : {10, 5, 4, 2})
                if (pixels / parts >= least_tick && (leading != 2 || parts != 5) && (leading != 5 || parts != 4) &&
                    (leading != 5 || parts != 2))
                    return {step, parts};
            return {step, 1};
        }
    return {most_step, 1};
}

}  // namespace pinfield::editor
