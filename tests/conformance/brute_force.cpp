#include "tests/conformance/brute_force.h"

#include <algorithm>
#include <cmath>

namespace pinfield::conformance {
namespace {

const double full_turn = 2 * std::acos(-1.0);

/// Counter-clockwise angle from u to v, in [0, 2 pi).
double turn_between(const Vec2& u, const Vec2& v) {
    const double angle = std::atan2(cross(u, v), dot(u, v));
    return angle < 0 ? angle + full_turn : angle;
}

struct Sweep {
    double start, turn;  // radians, counter-clockwise
};

Sweep sweep_of(const sdf::Piece& arc) {
    const Vec2 first = (arc.turn > 0 ? arc.a : arc.b) - arc.centre, last = (arc.turn > 0 ? arc.b : arc.a) - arc.centre;
    const double start = std::atan2(first.y(), first.x());
    if (arc.a == arc.b) return {start, arc.reflex ? full_turn : 0.0};
    double turn = turn_between(first, last);
    // An arc of nearly nothing or nearly all: the flag tells which.
    if (arc.reflex && turn < 0.1) turn += full_turn;
    if (!arc.reflex && turn > full_turn - 0.1) turn -= full_turn;
    return {start, turn};
}

bool crosses_ray(const Vec2& p, const Vec2& a, const Vec2& b) {
    if ((a.y() <= p.y()) == (b.y() <= p.y())) return false;
    return a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()) > p.x();
}

}  // namespace

double distance_to_piece(const Vec2& p, const sdf::Piece& piece) {
    const double ends = std::min(length(p - piece.a), length(p - piece.b));
    if (!piece.is_arc()) {
        const Vec2 along = piece.b - piece.a;
        const double l = length(along);
        if (l == 0) return ends;
        const double t = dot(Vec2(p - piece.a), along) / l;
        return 0 < t && t < l ? std::fabs(cross(along, Vec2(p - piece.a))) / l : ends;
    }
    const Vec2 from_centre = p - piece.centre;
    const Sweep sweep = sweep_of(piece);
    const Vec2 first(std::cos(sweep.start), std::sin(sweep.start));
    if (sweep.turn >= full_turn || turn_between(first, from_centre) <= sweep.turn)
        return std::min(ends, std::fabs(length(from_centre) - piece.radius));
    return ends;
}

double distance_to_outline(const Vec2& p, const sdf::Outline& pieces) {
    double best = infinity;
    for (const sdf::Piece& piece : pieces) best = std::min(best, distance_to_piece(p, piece));
    return best;
}

double distance_to_loop(const Vec2& p, const Loop& loop) {
    std::size_t nearest = 0;
    double best = infinity;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const double d = (p - loop[i]).squaredNorm();
        if (d < best) best = d, nearest = i;
    }
    const Vec2& middle = loop[nearest];
    const Vec2 &before = loop[(nearest + loop.size() - 1) % loop.size()], &after = loop[(nearest + 1) % loop.size()];
    const Vec2 slope = 0.5 * (after - before), bend = 0.5 * (after + before) - middle;
    const auto distance_at = [&](double t) { return length(Vec2(middle + t * slope + t * t * bend - p)); };
    double lo = -1, hi = 1;
    for (int i = 0; i < 60; ++i) {
        const double u = lo + (hi - lo) * 0.382, v = lo + (hi - lo) * 0.618;
        (distance_at(u) < distance_at(v) ? hi : lo) = distance_at(u) < distance_at(v) ? v : u;
    }
    return std::min(std::sqrt(best), distance_at(0.5 * (lo + hi)));
}

std::vector<Vec2> points_along(const sdf::Piece& piece, int count) {
    std::vector<Vec2> out;
    if (!piece.is_arc()) {
        for (int i = 0; i < count; ++i) out.emplace_back(piece.a + i / (count - 1.0) * (piece.b - piece.a));
        out.back() = piece.b;  // chains must close to the bit
        return out;
    }
    const Sweep sweep = sweep_of(piece);
    for (int i = 0; i < count; ++i) {
        const double angle = sweep.start + sweep.turn * i / (count - 1.0);
        out.emplace_back(piece.centre + piece.radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    out.front() = piece.turn > 0 ? piece.a : piece.b;
    out.back() = piece.turn > 0 ? piece.b : piece.a;
    return out;
}

std::vector<Loop> chords_of(const sdf::Outline& pieces) {
    std::vector<Loop> out;
    for (const sdf::Piece& piece : pieces) out.push_back(points_along(piece, piece.is_arc() ? 101 : 2));
    return out;
}

bool is_inside(const Vec2& p, const std::vector<Loop>& chains, bool closed) {
    bool inside = false;
    for (const Loop& chain : chains) {
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) inside ^= crosses_ray(p, chain[i], chain[i + 1]);
        if (closed) inside ^= crosses_ray(p, chain.back(), chain.front());
    }
    return inside;
}

}  // namespace pinfield::conformance
