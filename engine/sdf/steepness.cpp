// Subdivision where it pays: a box is split while the bound would reach farther without it. (Duff, "Interval arithmetic and recursive
// subdivision for implicit functions and constructive solid geometry", 1992; the mean value form: Moore, Kearfott and Cloud, "Introduction to
// Interval Analysis", 2009.)
#include "engine/sdf/steepness.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <vector>

#include "engine/core/at.h"

namespace pinfield::sdf {
namespace {

constexpr double hair = 1e-6;  // of the window, beyond it: a float's rounding and more
constexpr int first_cells = 16;  // across the window
/// As many boxes as cost some 15 ms, of very long formulas more.
int most_looks(const Steps& formula) { return std::clamp(240000 / std::max(formula.size(), 1), 1000, 12000); }
constexpr double finest = 0x1p-30;  // of the window
/// The bound must reach so far, in windows: else its digits and the way that a march takes are lost.
constexpr double least_reach = 1e-4;
constexpr double flattest = 1e-3;  // a formula that is flatter is not steepened further: its rounding would be, too

std::array<Box2, 4> quarters(const Box2& box) {
    const Vec2 c = box.centre();
    return {Box2{box.lo, c}, Box2{{c.x(), box.lo.y()}, {box.hi.x(), c.y()}}, Box2{{box.lo.x(), c.y()}, {c.x(), box.hi.y()}}, Box2{c, box.hi}};
}
Box2 window_box(const Vec2& window) { return Box2::centred(0.5 * window.x(), 0.5 * window.y()); }
Point<Interval> intervals(const Box2& box) { return {Interval(box.lo.x(), box.hi.x()), Interval(box.lo.y(), box.hi.y())}; }
Interval common(const Interval& a, const Interval& b) { return {std::max(a.lo, b.lo), std::min(a.hi, b.hi)}; }
double size(const Interval& a) { return std::max(std::fabs(a.lo), std::fabs(a.hi)); }

/// The part of the formula that a step is.
Watched look_at(const Steps& formula, const Box2& box, int step) {
    const Point<Interval> p = intervals(box);
    const Interval one(1), none(0);
    return value_at(formula, Point<Watched>{{{p.x, one, none}, 0, false}, {{p.y, none, one}, 0, false}}, step);
}

struct Cell {
    Box2 box;
    double least = 0, most = 0;  ///< of the value's size
    double slope = 0;            ///< infinite where it may jump
    bool is_none = false;
};

class Search {
public:
    Search(const Steps& formula, const Vec2& window)
        : formula_(formula), extent_(window.maxCoeff()), most_looks_(most_looks(formula)) {
        const Vec2 all = (1 + hair) * window, step = all / first_cells;
        const auto corner = [&](int i, int j) { return Vec2(-0.5 * all + step.cwiseProduct(Vec2(i, j))); };
        for (int j = 0; j < first_cells; ++j)
            for (int i = 0; i < first_cells; ++i) add({corner(i, j), corner(i + 1, j + 1)});
    }

    Steepness run() {
        Steepness best = choose();
        double before = 0;
        for (int next = 2 * looks_; looks_ < most_looks_ && split(best);) {
            best = choose();
            if (looks_ < next) continue;
            if (before > 0 && reach(best) < 1.1 * before) break;  // half as many looks again and hardly farther
            before = reach(best);
            next = looks_ + looks_ / 2;
        }
        return best;
    }
    static double reach(const Steepness& s) { return s.level / s.lipschitz; }
    /// The first cell that stands in the way of any bound, or null.
    const Cell* obstacle() const {
        for (const bool none : {true, false})
            for (const Cell& cell : cells_)
                if (none ? cell.is_none : cell.least == 0 && !std::isfinite(cell.slope)) return &cell;
        return nullptr;
    }
    /// Where the bound is held up most.
    const Cell& steepest() const {
        return *std::max_element(cells_.begin(), cells_.end(), [](const Cell& a, const Cell& b) {
            return (a.least == 0 ? a.slope : 0) < (b.least == 0 ? b.slope : 0);
        });
    }

private:
    void add(const Box2& box) {
        ++looks_;
        const Watched seen = look(formula_, box);
        const Interval &v = seen.d.v, slope_x = seen.d.dx, slope_y = seen.d.dy;
        const double x = size(slope_x), y = size(slope_y);
        cells_.push_back({box, std::max({v.lo, -v.hi, 0.0}), size(v), seen.jump == 0 ? std::sqrt(x * x + y * y) * (1 + 1e-12) : infinity,
                          seen.is_none});
    }

    /// Of all levels, below each of which other cells count, the one that lets level / lipschitz be largest.
    Steepness choose() {
        std::stable_sort(cells_.begin(), cells_.end(), [](const Cell& a, const Cell& b) { return a.least < b.least; });
        Steepness best{1, 0};
        double steepest = flattest, most = 0;
        const auto offer = [&](double level) {
            if (std::isfinite(steepest) && std::isfinite(level) && level / steepest > reach(best)) best = {steepest, level};
        };
        for (const Cell& cell : cells_) {
            offer(cell.least);
            steepest = std::max(steepest, cell.slope);
            most = std::max(most, cell.most);
        }
        offer(most);
        return best;
    }

    bool is_in_the_way(const Cell& cell, const Steepness& best) const {
        if (cell.is_none) return true;
        if (best.level == 0) return cell.least == 0 && !std::isfinite(cell.slope);
        if (cell.least < best.level) return cell.slope > 0.98 * best.lipschitz && best.lipschitz > flattest;
        return cell.least < 1.1 * best.level && cell.slope > best.lipschitz;
    }
    /// False when there is nothing more to be split.
    bool split(const Steepness& best) {
        std::vector<Cell> before;
        before.swap(cells_);
        bool any = false;
        for (const Cell& cell : before) {
            const bool splits = looks_ < most_looks_ && cell.box.size().maxCoeff() > finest * extent_ && is_in_the_way(cell, best);
            any = any || splits;
            if (!splits) cells_.push_back(cell);
            else for (const Box2& quarter : quarters(cell.box)) add(quarter);
        }
        return any;
    }

    const Steps& formula_;
    double extent_;
    int most_looks_;
    std::vector<Cell> cells_;
    int looks_ = 0;
};

/// To 20 digits of a mantissa, and a hair: so that another way to write the same formula, which rounds otherwise, gives the same number.
double rounded_up(double a) {
    int exponent = 0;
    const double mantissa = std::frexp(a, &exponent);
    return std::ldexp(std::ceil(mantissa * 0x1p20 + 0x1p-10), exponent - 20);
}

enum class Trouble : unsigned char { none, jump, steep };

bool has(const Watched& seen, Trouble trouble) {
    if (trouble == Trouble::none) return seen.is_none;
    return trouble == Trouble::jump ? seen.jump != 0 : !seen.d.dx.is_finite() || !seen.d.dy.is_finite();
}

/// The innermost part that has the trouble.
int culprit(const Steps& formula, const Box2& box, Trouble trouble) {
    const auto is_condition = [](Operation o) { return o >= Operation::less && o <= Operation::either; };
    int step = formula.size() - 1;
    for (bool deeper = true; deeper;) {
        deeper = false;
        const Step here = node_at(formula, step);
        if (here.operation == Operation::name) return step;
        for (const int operand : here.operands)
            if (operand >= 0 && !is_condition(node_at(formula, operand).operation) && has(look_at(formula, box, operand), trouble)) {
                step = operand;
                deeper = true;
                break;
            }
    }
    return step;
}

TextFault fault_at(const Steps& formula, const Box2& box, Trouble trouble, std::string_view text) {
    const int step = culprit(formula, box, trouble);
    const Step part = node_at(formula, step);
    const Span span = formula.span_of(step);
    const std::string_view slice = span.end <= text.size() ? text.substr(span.begin, span.end - span.begin) : std::string_view("the formula");
    const Vec2 at = 1e3 * box.centre();
    const auto because = [&](std::string_view why, std::string_view hint) {
        return TextFault{Code::no_distance, span, fmt::format("{} {} near ({:.3g}mm, {:.3g}mm)", slice, why, at.x(), at.y()), std::string(hint)};
    };
    if (trouble == Trouble::steep)
        return because("is without end steep, or steeper than can be proved,", "where its outline runs a formula has a slope: lengths have 1");
    const Operation operation = part.operation;
    if (trouble == Trouble::none) {
        if (operation == Operation::divide || operation == Operation::modulo || operation == Operation::tangent)
            return because(fmt::format("divides by what may be 0"), "max(..., 1mm) keeps a divisor above 0");
        if (operation == Operation::root || operation == Operation::logarithm)
            return because("may be of a number below 0", "abs(...) or max(0, ...) keeps it above");
        if (operation == Operation::power)
            return because("may be of a number below 0, or too large,", "abs(...) or max(0, ...) keeps what is raised above 0");
        return because("may have no value", "");
    }
    if (operation == Operation::choose) return because("may jump where one branch gives way to the other", "let them be the same there, or use min, max, abs or clamp");
    if (operation == Operation::arc_tangent) return because("jumps by a whole turn", "sin(n * atan2(y, x)) does not, with a whole n");
    return because("jumps", "of the outline a formula may not jump; min, max, abs and clamp never do");
}

/// The farthest along a coordinate axis that the formula may be no more than `level`, or -infinity. Best first: a box is split only while
/// nothing reaches farther.
double farthest_below(const Steps& formula, const Box2& window, double level, const Vec2& way, double tolerance) {
    const auto key = [&](const Box2& box) { return std::max(pinfield::dot(way, box.lo), pinfield::dot(way, box.hi)); };
    const auto nearer = [&](const Box2& a, const Box2& b) { return key(a) < key(b); };
    std::priority_queue<Box2, std::vector<Box2>, decltype(nearer)> open(nearer);
    const auto offer = [&](const Box2& box) {
        const Watched seen = look(formula, box);
        if (seen.is_none || seen.d.v.lo <= level) open.push(box);
    };
    offer(window);
    const int most = most_looks(formula) / 2;
    for (int looks = 0; !open.empty(); looks += 4) {
        const Box2 box = open.top();
        if (looks > most || box.size().maxCoeff() <= tolerance) return key(box);
        open.pop();
        for (const Box2& quarter : quarters(box)) offer(quarter);
    }
    return -infinity;
}

Box2 box_below(const Steps& formula, const Box2& window, double level, double tolerance) {
    const auto reach = [&](const Vec2& way) { return farthest_below(formula, window, level, way, tolerance); };
    const double right = reach({1, 0});
    if (right == -infinity) return {};
    return {{-reach({-1, 0}), -reach({0, -1})}, {right, reach({0, 1})}};
}

}  // namespace

Watched look(const Steps& formula, const Box2& box) {
    Watched seen = look_at(formula, box, formula.size() - 1);
    if (seen.jump != 0 || seen.is_none || !seen.d.dx.is_finite() || !seen.d.dy.is_finite()) return seen;
    const Vec2 c = box.centre();
    const Interval middle = value_at(formula, Point<Interval>{Interval(c.x()), Interval(c.y())});
    const Point<Interval> p = intervals(box);
    const Interval by_slope = middle + seen.d.dx * (p.x - Interval(c.x())) + seen.d.dy * (p.y - Interval(c.y()));
    seen.d.v = common(seen.d.v, by_slope);
    return seen;
}

tl::expected<Steepness, TextFault> steepness_of(const Steps& formula, const Vec2& window, std::string_view text) {
    Search search(formula, window);
    const Steepness found = search.run();
    const Cell* obstacle = search.obstacle();
    const bool reaches = found.level >= least_reach * window.maxCoeff() * found.lipschitz;
    if (reaches && !(obstacle && obstacle->is_none)) return Steepness{rounded_up(found.lipschitz), -rounded_up(-found.level)};
    if (!obstacle) return tl::unexpected(fault_at(formula, search.steepest().box, Trouble::steep, text));
    if (obstacle->is_none) return tl::unexpected(fault_at(formula, obstacle->box, Trouble::none, text));
    const bool jumps = look(formula, obstacle->box).jump != 0;
    return tl::unexpected(fault_at(formula, obstacle->box, jumps ? Trouble::jump : Trouble::steep, text));
}

Box2 box_below(const Steps& formula, const Vec2& window, double level) {
    Box2 box = window_box(window);
    for (int round = 0; round < 12 && !box.is_empty(); ++round) {
        const double before = box.size().maxCoeff();
        box = box_below(formula, box, level, before * 0x1p-14).intersected(box);
        if (!box.is_empty() && box.size().maxCoeff() > 0.25 * before) break;
    }
    return box;
}

}  // namespace pinfield::sdf
