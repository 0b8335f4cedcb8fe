#include "engine/physics/sweep_pieces.h"

#include <algorithm>

namespace pinfield {

namespace {

constexpr int most_evaluations = 64;
// Sides and arcs count as a little longer than they are, so that no ball slips between two pieces that join smoothly.
constexpr double overlap = 1e-8;  // of the ball's radius
constexpr double smooth_join = 1e-9;

Vec2 start_tangent(const SweepPiece& p) {
    if (p.turn == 0) return p.along;
    const Vec2 t = perpendicular(p.a - p.centre) / p.radius;
    return p.turn > 0 ? t : Vec2(-t);
}

Vec2 end_tangent(const SweepPiece& p) {
    if (p.turn == 0) return p.along;
    const Vec2 t = perpendicular(p.b - p.centre) / p.radius;
    return p.turn > 0 ? t : Vec2(-t);
}

SweepPiece prepared(const BoundaryPiece& boundary) {
    const sdf::Piece& from = boundary.piece;
    SweepPiece p;
    p.a = from.a;
    p.b = from.b;
    p.centre = from.centre;
    p.radius = from.radius;
    p.turn = from.turn;
    p.reflex = from.reflex;
    p.full = from.is_full_circle();
    p.solid = boundary.solid;
    p.leaf = boundary.leaf;
    p.layers = boundary.layers;
    if (!from.is_arc()) {
        const Vec2 d = p.b - p.a;
        p.length = length(d);
        p.along = p.length > 0 ? Vec2(d / p.length) : Vec2(1, 0);
        p.normal = -perpendicular(p.along);
    }
    return p;
}

/// Does the ray from the arc's centre along x meet the arc, give or take `slack` radians?
bool in_sector(const SweepPiece& p, const Vec2& x, double slack) {
    if (p.full) return true;
    const Vec2 first = (p.turn > 0 ? p.a : p.b) - p.centre, last = (p.turn > 0 ? p.b : p.a) - p.centre;
    const double margin = slack * p.radius * length(x);
    if (p.reflex) return !(cross(last, x) > margin && cross(x, first) > margin);
    return cross(first, x) >= -margin && cross(x, last) >= -margin;
}

/// The centre x(t) of a ball, relative to a fixed point, against a circle of radius `reach` about that point:
/// g = sign (|x|^2 - reach^2), positive while clear.
struct RoundGap {
    Motion path;
    double reach = 0, sign = 1;

    double value(double t) const {
        const Vec2 x = path.at(t);
        return sign * (dot(x, x) - reach * reach);
    }
    double slope(double t) const { return 2 * sign * dot(path.at(t), path.velocity_at(t)); }
    /// Smallest value of `side` g'' on [t, end]: |x|^2 is a quartic, its second derivative a convex quadratic.
    double least_curvature(double t, double end, double side) const {
        const Vec2& v = path.velocity;
        const Vec2& a = path.acceleration;
        const double aa = dot(a, a), va = dot(v, a);
        const auto second = [&](double s) { return 2 * (dot(v, v) + dot(path.position, a) + 3 * va * s + 1.5 * aa * s * s); };
        const double first = second(t), last = second(end);
        if (sign * side < 0) return -std::max(first, last);
        const double lowest = aa > 0 ? -va / aa : t;
        return lowest > t && lowest < end ? second(lowest) : std::min(first, last);
    }
    /// First time from t on at which side * g has fallen to `accepted`; certified never to be late. When it starts there
    /// and rises, the time of its return. Infinity when not before `end`.
    double falls(double t, double end, double side, double accepted, bool leaving, int& evaluations, bool& capped) const {
        double gap = side * value(t);
        for (int i = 0; i < most_evaluations; ++i) {
            const double rate = side * slope(t);
            if (gap <= accepted && !(leaving && i == 0 && rate > 0)) return t;
            t += first_zero(std::max(gap, 0.0), rate, least_curvature(t, end, side));
            if (!(t <= end)) return infinity;
            gap = side * value(t);
            ++evaluations;
        }
        capped = true;
        return t;
    }
};

/// The ball against a circle of radius `round` (0: a corner), from outside (sign +1) or from inside (-1), where `valid(t)`
/// says whether the part of the circle that is met at t is really there.
template <class Valid>
PieceHit sweep_round(const Motion& path, double round, double sign, double duration, double radius, const ContactBand& band,
                     const Valid& valid, int& evaluations) {
    PieceHit hit;
    const double far = length(path.position), gap = sign * (far - round) - radius;
    if (gap > band.touching() && gap > path.travel(duration) + band.tolerance) return hit;
    const double rate = sign * dot(path.position, path.velocity);
    const bool touching = gap <= band.touching() && (gap > -band.tolerance || (gap > -0.5 * radius && valid(0)));
    double level = band.target();
    if (touching) level = rate > 0 ? std::min(level, gap) : band.floor_below(gap);
    const auto circle = [&](double clearance) { return RoundGap{path, round + sign * (radius + clearance), sign}; };
    RoundGap g = circle(level);
    if (g.reach <= 0) return hit;
    ++evaluations;

    double t = 0;
    const auto accepted = [&] { return 2 * g.reach * band.accepted(); };
    if (gap < 0 && !touching) {  // beyond the circle, where it is open: first wait until the ball is clear again
        t = g.falls(0, duration, -1, accepted(), false, evaluations, hit.capped);
        if (!(t <= duration) || hit.capped) { hit.time = hit.capped ? t : infinity; return hit; }
    }
    const int most_passes = path.is_straight() && sign > 0 ? 1 : 3;
    for (int pass = 0; pass < most_passes; ++pass) {
        const bool creeping = touching && pass == 0 && rate <= 0;
        t = g.falls(t, duration, 1, creeping ? 0 : accepted(), pass > 0 || (touching && rate > 0) || gap < 0, evaluations, hit.capped);
        if (!(t <= duration)) return hit;
        if (hit.capped || valid(t)) {
            if (creeping && !hit.capped && valid(0)) t = 0;
            hit.time = t;
            return hit;
        }
        if (pass + 1 == most_passes) break;
        g = circle(band.target());
        t = g.falls(t, duration, -1, accepted(), true, evaluations, hit.capped);
        if (hit.capped) hit.time = t;
        if (!(t <= duration) || hit.capped) return hit;
    }
    return hit;
}

PieceHit sweep_corner(const Vec2& corner, const Motion& motion, double duration, double radius, const ContactBand& band,
                      int& evaluations) {
    const Motion path{motion.position - corner, motion.velocity, motion.acceleration};
    PieceHit hit = sweep_round(path, 0, 1, duration, radius, band, [](double) { return true; }, evaluations);
    if (hit.time <= duration) {
        const Vec2 x = path.at(hit.time);
        hit.normal = x / length(x);
    }
    return hit;
}

PieceHit sweep_arc(const SweepPiece& p, const Motion& motion, double duration, double radius, const ContactBand& band,
                   int& evaluations) {
    const Motion path{motion.position - p.centre, motion.velocity, motion.acceleration};
    const double sign = p.turn > 0 ? 1 : -1, slack = overlap * radius / p.radius;
    PieceHit hit = sweep_round(path, p.radius, sign, duration, radius, band,
                               [&](double t) { return in_sector(p, path.at(t), slack); }, evaluations);
    if (hit.time <= duration) {
        const Vec2 x = path.at(hit.time);
        hit.normal = x * (sign / length(x));
    }
    return hit;
}

PieceHit sweep_side(const SweepPiece& p, const Motion& motion, double duration, double radius, const ContactBand& band,
                    int& evaluations) {
    PieceHit hit;
    const Vec2 from_a = motion.position - p.a;
    const double height = dot(p.normal, from_a), gap = height - radius;
    if (height <= 0) return hit;
    const double rate = dot(p.normal, motion.velocity), curvature = dot(p.normal, motion.acceleration);
    ++evaluations;
    const double slack = overlap * radius;
    const auto beside = [&](double t) {
        const double u = dot(p.along, motion.at(t) - p.a);
        return u >= -slack && u <= p.length + slack;
    };
    double t = infinity;
    if (gap > band.touching()) {
        t = first_zero(gap - band.target(), rate, curvature);
    } else if (rate > 0) {
        t = first_zero(std::max(0.0, gap - band.target()), rate, curvature);
    } else {
        t = first_zero(gap - band.floor_below(gap), rate, curvature);
        if (t <= duration && beside(0)) t = 0;
    }
    if (!(t <= duration) || !beside(t)) return hit;
    hit.time = t;
    hit.normal = p.normal;
    return hit;
}

}  // namespace

std::vector<SweepPiece> prepare_pieces(const Field& field) {
    std::vector<SweepPiece> pieces;
    pieces.reserve(field.pieces.size());
    for (const BoundaryPiece& boundary : field.pieces) pieces.push_back(prepared(boundary));
    for (const Solid& solid : field.solids) {
        const auto first = pieces.begin() + solid.first_piece, last = first + solid.piece_count;
        for (auto piece = first; piece != last; ++piece) {
            if (piece->full) { piece->corner_a = piece->corner_b = false; continue; }
            int successors = 0;
            for (auto next = first; next != last; ++next)
                if (next->a == piece->b) ++successors;
            if (successors != 1) continue;  // a loose end, or several outlines meet in one point
            const auto next = std::find_if(first, last, [&](const SweepPiece& q) { return q.a == piece->b; });
            const Vec2 in = end_tangent(*piece), out = start_tangent(*next);
            const bool turns_back = dot(in, out) < 0 && std::abs(cross(in, out)) < smooth_join;
            piece->corner_b = false;
            next->corner_a = turns_back || cross(in, out) > smooth_join;
        }
    }
    return pieces;
}

Foot nearest_on(const SweepPiece& p, const Vec2& point) {
    Foot foot;
    if (p.turn == 0) {
        const Vec2 from_a = point - p.a;
        const double u = dot(p.along, from_a);
        if (u >= 0 && u <= p.length) {
            const double height = dot(p.normal, from_a);
            return {std::abs(height), height < 0 ? Vec2(-p.normal) : p.normal, 0, height >= 0};
        }
    } else {
        const Vec2 x = point - p.centre;
        const double far = length(x);
        if (far > 0 && in_sector(p, x, 0)) {
            const bool beyond = far > p.radius;
            return {std::abs(far - p.radius), x * ((beyond ? 1 : -1) / far), p.turn < 0 && !beyond ? p.radius : 0,
                    beyond == (p.turn > 0)};
        }
    }
    const Vec2 from_a = point - p.a, from_b = point - p.b;
    const double to_a = length(from_a), to_b = length(from_b);
    const bool at_a = to_a <= to_b;
    foot.distance = at_a ? to_a : to_b;
    foot.normal = foot.distance > 0 ? Vec2((at_a ? from_a : from_b) / foot.distance) : Vec2(0, 1);
    foot.outside = at_a ? p.corner_a : p.corner_b;
    return foot;
}

PieceHit sweep_piece(const SweepPiece& piece, const Motion& motion, double duration, double radius, const ContactBand& band,
                     int& evaluations) {
    PieceHit best = piece.turn == 0 ? sweep_side(piece, motion, duration, radius, band, evaluations)
                                    : sweep_arc(piece, motion, duration, radius, band, evaluations);
    const auto corner = [&](const Vec2& at) {
        const PieceHit hit = sweep_corner(at, motion, std::min(duration, best.time), radius, band, evaluations);
        if (hit.time < best.time) best = hit;
    };
    if (piece.corner_a) corner(piece.a);
    if (piece.corner_b) corner(piece.b);
    return best;
}

}  // namespace pinfield
