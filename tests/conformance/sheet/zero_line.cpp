#include "tests/conformance/sheet/zero_line.h"

#include <array>
#include <cmath>
#include <vector>

namespace pinfield::conformance {
namespace {

/// A quadtree down to the leaves that the line crosses, and further where a needle passes between a leaf's corners, chords across these
/// (Lorensen and Cline, "Marching cubes", 1987, in the plane), and each chord halved until its middle lies on the line: at a corner, where
/// no chord fits, down to the tolerance.
class Tracer {
public:
    Tracer(const std::function<double(const Vec2&)>& field, const ZeroLineOptions& options) : field_(field), options_(options) {}

    void cell(const Vec2& lo, double size) {
        const double half_diagonal = 0.7072 * size;
        const Vec2 centre = lo + Vec2(0.5 * size, 0.5 * size);
        // Half as much again as the claim allows, for the claim is under test.
        if (std::fabs(field_(centre)) > 1.5 * options_.lipschitz * half_diagonal) return;
        if (size <= options_.leaf) leaf(lo, size);
        else quarter(lo, size);
    }

    sdf::Outline chords;

private:
    bool solid(const Vec2& p) const { return field_(p) < 0; }

    void quarter(const Vec2& lo, double size) {
        const double half = 0.5 * size;
        for (const Vec2& corner : {Vec2(0, 0), Vec2(half, 0), Vec2(0, half), Vec2(half, half)}) cell(lo + corner, half);
    }

    /// Does the way down the field from the cell's centre end on the line within the cell? Then the line is there, whatever its corners
    /// say.
    bool holds_a_foot(const Vec2& lo, double size) const {
        const Vec2 centre = lo + Vec2(0.5 * size, 0.5 * size), x(1e-3 * size, 0), y(0, 1e-3 * size);
        const Vec2 slope = Vec2(field_(centre + x) - field_(centre - x), field_(centre + y) - field_(centre - y)) / (2e-3 * size);
        if (!(slope.squaredNorm() > 0)) return false;
        const Vec2 foot = centre - field_(centre) / slope.squaredNorm() * slope;
        return Box2{lo, lo + Vec2(size, size)}.grown(0.1 * size).contains(foot);
    }

    /// Between two points of different sign.
    Vec2 crossing(Vec2 a, Vec2 b) const {
        const bool solid_at_a = solid(a);
        const double near_enough = 0.1 * options_.tolerance;
        while (std::fabs(b.x() - a.x()) + std::fabs(b.y() - a.y()) > near_enough) {
            const Vec2 middle = 0.5 * (a + b);
            (solid(middle) == solid_at_a ? a : b) = middle;
        }
        return 0.5 * (a + b);
    }

    void leaf(const Vec2& lo, double size) {
        const std::array<Vec2, 4> corners{lo, lo + Vec2(size, 0), lo + Vec2(size, size), lo + Vec2(0, size)};
        std::array<bool, 4> is_solid{};
        for (std::size_t i = 0; i < 4; ++i) is_solid[i] = solid(corners[i]);
        std::vector<Vec2> crossings;
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t next = (i + 1) % 4;
            if (is_solid[i] != is_solid[next]) crossings.push_back(crossing(corners[i], corners[next]));
        }
        constexpr double narrowest = 1.0 / 256;  // of a leaf
        if (crossings.empty() && size > narrowest * options_.leaf && holds_a_foot(lo, size)) return quarter(lo, size);
        if (crossings.size() == 2) return refine(crossings[0], crossings[1]);
        if (crossings.size() != 4) return;
        // A saddle: the middle belongs to one pair of opposite corners, the chords cut off the other two.
        const std::size_t first = solid(lo + Vec2(0.5 * size, 0.5 * size)) == is_solid[0] ? 0 : 3;
        refine(crossings[first], crossings[(first + 1) % 4]);
        refine(crossings[(first + 2) % 4], crossings[(first + 3) % 4]);
    }

    void refine(const Vec2& a, const Vec2& b, int most_halvings = 40) {
        const double l = length(b - a);
        const Vec2 middle = 0.5 * (a + b);
        if (l < options_.tolerance || most_halvings == 0) return chords.push_back(sdf::Piece::segment(a, b));
        const Vec2 aside = perpendicular(b - a);
        const bool solid_at_middle = solid(middle);
        for (const double reach : {1.0 / 512, 1.0 / 64, 1.0 / 8, 1.0})
            for (const double side : {reach, -reach}) {
                const Vec2 beyond = middle + side * aside;
                if (solid(beyond) == solid_at_middle) continue;
                const Vec2 on_line = crossing(middle, beyond);
                if (length(on_line - middle) < options_.tolerance) return chords.push_back(sdf::Piece::segment(a, b));
                refine(a, on_line, most_halvings - 1);
                return refine(on_line, b, most_halvings - 1);
            }
        chords.push_back(sdf::Piece::segment(a, b));
    }

    const std::function<double(const Vec2&)>& field_;
    ZeroLineOptions options_;
};

}  // namespace

sdf::Outline zero_line(const std::function<double(const Vec2&)>& field, const ZeroLineOptions& options) {
    Tracer tracer(field, options);
    tracer.cell(options.window.lo, options.window.size().maxCoeff());
    return std::move(tracer.chords);
}

}  // namespace pinfield::conformance
