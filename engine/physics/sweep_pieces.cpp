#include "engine/physics/sweep_pieces.h"

#include <algorithm>

namespace pinfield {

namespace {

constexpr int most_evaluations = 64;  // of one arc or corner: each step squares the error, and what has not arrived by then grazes
constexpr double overlap = 1e-8;  // of two pieces that join smoothly, so that no ball slips between them; in ball radii
constexpr double smooth_join = 1e-9;  // sine of the angle by which two pieces turn where they meet: far above rounding, far below corners

SweepPiece prepared(const BoundaryPiece& boundary) {
    SweepPiece p{boundary.piece};
    p.solid = boundary.solid;
    p.leaf = boundary.leaf;
    p.layers = boundary.layers;
    if (!p.is_arc()) {
        const Vec2 d = p.b - p.a;
        p.length = length(d);
        p.along = p.length > 0 ? Vec2(d / p.length) : Vec2(1, 0);
        p.normal = -perpendicular(p.along);
        p.centre = 0.5 * (p.a + p.b);
    }
    return p;
}

/// The times between which a path runs beside a piece or off its ends, in order.
struct Splits {
    double time[8] = {0};
    int count = 1;

    /// Adds the sign changes of value + rate t + curvature t^2 / 2 within (0, duration).
    void add_roots(double value, double rate, double curvature, double duration) {
        const double discriminant = rate * rate - 2 * curvature * value;
        if (!(discriminant >= 0)) return;
        const double q = -(rate + (rate < 0 ? -std::sqrt(discriminant) : std::sqrt(discriminant)));
        if (curvature != 0) add(q / curvature, duration);
        if (q != 0) add(2 * value / q, duration);
    }
    void finish(double duration) {
        std::sort(time + 1, time + count);
        time[count] = duration;
    }

private:
    void add(double t, double duration) {
        if (t > 0 && t < duration) time[count++] = t;
    }
};

/// The first hit of `sweep(path from, duration)` over the stretches in which `valid(t)` holds. Each is taken a hair longer than
/// it is: a ball that follows a wall in contact must be seen by the next piece from the first instant on, not when it is in it.
template <class Valid, class Sweep>
PieceHit over_stretches(const Splits& splits, const Motion& path, double duration, double radius, const Valid& valid, const Sweep& sweep) {
    const double speed = path.top_speed(duration), hair = speed > 0 ? overlap * radius / speed : 0.0;
    for (int k = 0; k < splits.count; ++k) {
        if (!valid(0.5 * (splits.time[k] + splits.time[k + 1]))) continue;
        const double from = std::max(0.0, splits.time[k] - hair), to = std::min(duration, splits.time[k + 1] + hair);
        PieceHit hit = sweep(from == 0 ? path : path.from(from), to - from);
        hit.time += from;
        if (hit.time < infinity) return hit;
    }
    return {};
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
    /// Smallest value of g'' on [t, end]: |x|^2 is a quartic, its second derivative a convex quadratic.
    double least_curvature(double t, double end) const {
        const Vec2& v = path.velocity;
        const Vec2& a = path.acceleration;
        const double aa = dot(a, a), va = dot(v, a);
        const auto second = [&](double s) { return 2 * (dot(v, v) + dot(path.position, a) + 3 * va * s + 1.5 * aa * s * s); };
        const double first = second(t), last = second(end);
        if (sign < 0) return -std::max(first, last);
        const double lowest = aa > 0 ? -va / aa : t;
        return lowest > t && lowest < end ? second(lowest) : std::min(first, last);
    }
    /// First time at which g has fallen to `accepted`; certified never to be late. When it starts there and `leaving`, the
    /// time of its return. Infinity when not before `end`.
    double falls(double end, double accepted, bool leaving, int& evaluations, bool& capped) const {
        double t = 0, gap = value(0);
        for (int i = 0; i < most_evaluations; ++i) {
            const double rate = slope(t);
            if (gap <= accepted && !(leaving && i == 0)) return t;
            t += first_zero(std::max(gap, 0.0), rate, least_curvature(t, end));
            if (!(t <= end)) return infinity;
            gap = value(t);
            ++evaluations;
        }
        capped = true;
        return t;
    }
};

/// The ball against a circle of radius `round` about the origin (0: a corner), from outside (sign +1) or from inside (-1).
PieceHit sweep_round(const Motion& path, double round, double sign, double duration, double radius, const ContactBand& band,
                     int& evaluations) {
    PieceHit hit;
    const double far = length(path.position), gap = sign * (far - round) - radius;
    if (gap < -0.5 * radius) return hit;  // the centre is near the circle or behind it: not where a ball can be
    if (gap > path.travel(duration) + band.tolerance) return hit;
    const double rate = sign * dot(path.position, path.velocity);
    const bool touching = gap <= band.touching(), creeping = touching && rate <= 0;
    const double level = creeping ? band.floor_below(gap) : touching ? std::min(band.target(), gap) : band.target();
    const RoundGap g{path, round + sign * (radius + level), sign};
    if (g.reach <= 0) return hit;
    ++evaluations;
    const double t = g.falls(duration, creeping ? 0.0 : 2 * g.reach * band.accepted(), touching && rate > 0, evaluations, hit.capped);
    if (!(t <= duration)) return hit;
    hit.time = creeping && !hit.capped ? 0.0 : t;
    const Vec2 x = path.at(hit.time);
    hit.normal = x * (sign / length(x));
    return hit;
}

PieceHit sweep_corner(const Vec2& corner, const Motion& motion, double duration, double radius, const ContactBand& band,
                      int& evaluations) {
    return sweep_round({motion.position - corner, motion.velocity, motion.acceleration}, 0, 1, duration, radius, band, evaluations);
}

PieceHit sweep_arc(const SweepPiece& p, const Motion& motion, double duration, double radius, const ContactBand& band,
                   int& evaluations) {
    const Motion path{motion.position - p.centre, motion.velocity, motion.acceleration};
    const double sign = p.turn > 0 ? 1 : -1;
    if (p.is_full_circle()) return sweep_round(path, p.radius, sign, duration, radius, band, evaluations);
    if (sign * (length(path.position) - p.radius) - radius > path.travel(duration) + band.tolerance) return {};
    Splits splits;
    for (const Vec2& end : {Vec2(p.a - p.centre), Vec2(p.b - p.centre)})
        splits.add_roots(cross(end, path.position), cross(end, path.velocity), cross(end, path.acceleration), duration);
    splits.finish(duration);
    return over_stretches(
        splits, path, duration, radius, [&](double t) { return in_sweep(p, path.at(t)); },
        [&](const Motion& stretch, double lasts) { return sweep_round(stretch, p.radius, sign, lasts, radius, band, evaluations); });
}

/// The ball against the line through a side, wherever along it.
PieceHit sweep_line(const SweepPiece& p, const Motion& motion, double duration, double radius, const ContactBand& band) {
    const double height = dot(p.normal, motion.position - p.centre), gap = height - radius;
    if (gap < -0.5 * radius) return {};
    const double rate = dot(p.normal, motion.velocity), curvature = dot(p.normal, motion.acceleration);
    double t = infinity;
    if (gap > band.touching() || rate > 0) {
        t = first_zero(std::max(0.0, gap - band.target()), rate, curvature);
    } else {
        t = first_zero(gap - band.floor_below(gap), rate, curvature) <= duration ? 0 : infinity;
    }
    return t <= duration ? PieceHit{t, p.normal, false} : PieceHit{};
}

PieceHit sweep_side(const SweepPiece& p, const Motion& motion, double duration, double radius, const ContactBand& band,
                    int& evaluations) {
    const Vec2 from_a = motion.position - p.a;
    if (dot(p.normal, from_a) - radius > motion.travel(duration) + band.tolerance) return {};
    ++evaluations;
    const double u = dot(p.along, from_a), rate = dot(p.along, motion.velocity), curvature = dot(p.along, motion.acceleration);
    Splits splits;
    splits.add_roots(u, rate, curvature, duration);
    splits.add_roots(u - p.length, rate, curvature, duration);
    splits.finish(duration);
    const auto beside = [&](double t) {
        const double at = dot(p.along, motion.at(t) - p.a);
        return at >= 0 && at <= p.length;
    };
    return over_stretches(splits, motion, duration, radius, beside,
                          [&](const Motion& stretch, double lasts) { return sweep_line(p, stretch, lasts, radius, band); });
}

}  // namespace

std::vector<SweepPiece> prepare_pieces(const Field& field) {
    std::vector<SweepPiece> pieces;
    pieces.reserve(field.pieces.size());
    for (const BoundaryPiece& boundary : field.pieces) pieces.push_back(prepared(boundary));
    for (const Solid& solid : field.solids) {
        const auto first = pieces.begin() + solid.first_piece, last = first + solid.piece_count;
        for (auto piece = first; piece != last; ++piece) {
            if (piece->is_full_circle()) { piece->corner_a = piece->corner_b = false; continue; }
            int successors = 0;
            for (auto next = first; next != last; ++next)
                if (next->a == piece->b) ++successors;
            if (successors != 1) continue;  // a loose end, or several outlines meet in one point
            const auto next = std::find_if(first, last, [&](const SweepPiece& q) { return q.a == piece->b; });
            const Vec2 in = direction_at(*piece, piece->b), out = direction_at(*next, next->a);
            const bool turns_back = dot(in, out) < 0 && std::abs(cross(in, out)) < smooth_join;
            piece->corner_b = false;
            next->corner_a = turns_back || cross(in, out) > smooth_join;
        }
    }
    return pieces;
}

/// As foot_on_piece() of piece.h, but by the unit vectors that are ready here, without a division by a length; games are recorded with the
/// bits of this one.
Foot nearest_on(const SweepPiece& p, const Vec2& point) {
    if (!p.is_arc()) {
        const Vec2 from_a = point - p.a;
        const double along = dot(p.along, from_a);
        if (along >= 0 && along <= p.length) {
            const double height = dot(p.normal, point - p.centre);
            return {std::abs(height), height < 0 ? Vec2(-p.normal) : p.normal, 0, infinity, height >= 0};
        }
    } else {
        const Vec2 x = point - p.centre;
        const double far = length(x);
        if (far > 0 && in_sweep(p, x)) {
            const bool beyond = far > p.radius;
            return {std::abs(far - p.radius), x * ((beyond ? 1 : -1) / far), p.turn < 0 && !beyond ? p.radius : 0,
                    beyond ? p.radius : infinity, beyond == (p.turn > 0)};
        }
    }
    const Vec2 from_a = point - p.a, from_b = point - p.b;
    const double to_a = length(from_a), to_b = length(from_b), distance = std::min(to_a, to_b);
    const bool at_a = to_a <= to_b;
    const Vec2 normal = distance > 0 ? Vec2((at_a ? from_a : from_b) / distance) : Vec2(0, 1);
    return {distance, normal, 0, 0, at_a ? p.corner_a : p.corner_b};
}

double distance_to(const SweepPiece& p, const Vec2& point) {
    if (p.is_arc()) return distance_to_piece(p, point);
    const Vec2 from_a = point - p.a;
    const double u = dot(p.along, from_a), beyond = u - std::clamp(u, 0.0, p.length), height = dot(p.normal, from_a);
    return std::sqrt(beyond * beyond + height * height);
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
