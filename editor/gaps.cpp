#include "editor/gaps.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "editor/edit_tools.h"
#include "editor/pick.h"
#include "engine/core/at.h"
#include "engine/core/trig.h"
#include "engine/program/evaluate.h"

namespace pinfield::editor {
namespace {

constexpr double on_surface = 1e-8;  ///< metres
constexpr double still = 1e-7;       ///< metres: a foot that moves by less has settled
constexpr double no_gap = 1e-6;      ///< metres: what is nearer touches

/// A solid where it stands.
struct Body {
    const Field* field = nullptr;
    int solid = 0;
    Similarity world_from_field, field_from_world;
    Box2 bounds;  ///< world
    const Solid& of() const { return at(field->solids, solid); }
};

struct Seen {
    double distance = infinity;
    Vec2 away{0, 0};  ///< unit, world
    NodeId node;
};

Seen seen_from(const Body& body, const Vec2& world) {
    const Nearest found = nearest_of_solid(*body.field, body.solid, body.field_from_world * world);
    const double norm = length(found.gradient);
    const Vec2 away = norm > 0 ? body.world_from_field.direction(found.gradient / norm) : Vec2(0, 0);
    return {found.distance, away, body.of().origin};
}

/// Of several, the one that is nearest.
Seen seen_from(std::span<const Body> bodies, const Vec2& world) {
    Seen best;
    for (const Body& body : bodies) {
        if (body.bounds.distance(world) >= best.distance) continue;
        const Seen seen = seen_from(body, world);
        if (seen.distance < best.distance) best = seen;
    }
    return best;
}

/// The way to a surface, by as many steps as a distance that is only a bound needs; nothing where it is not reached.
template <class Distance>
std::optional<Vec2> foot_from(Vec2 p, Distance distance) {
    for (int i = 0; i < 12; ++i) {
        const Seen seen = distance(p);
        if (!std::isfinite(seen.distance)) return {};
        if (std::fabs(seen.distance) <= on_surface) return p;
        p -= seen.distance * seen.away;
    }
    return {};
}

void add_bodies(const Field& field, const Similarity& world_from_field, std::vector<Body>& out) {
    for (std::size_t i = 0; i < field.solids.size(); ++i) {
        const Solid& solid = field.solids[i];
        const Box2 bounds = solid.bounds.is_finite() ? world_from_field * solid.bounds : Box2{{-infinity, -infinity}, {infinity, infinity}};
        out.push_back({&field, static_cast<int>(i), world_from_field, world_from_field.inverse(),
                       solid.is_domain ? Box2{{-infinity, -infinity}, {infinity, infinity}} : bounds});
    }
}

std::vector<Body> all_bodies(const AppState& state) {
    const Program& program = state.session.program();
    std::vector<Body> out;
    add_bodies(program.fixed, {}, out);
    for (std::size_t i = 0; i < program.movers.size(); ++i)
        add_bodies(program.movers[i].field, state.session.world_from_mover(static_cast<int>(i)), out);
    return out;
}

/// Places on a body's surface about `step` apart, in a box of the world.
std::vector<Vec2> surface_places(const Body& body, const Box2& window, double step) {
    constexpr int directions = 48, most_of_a_piece = 400;
    std::vector<Vec2> places;
    const auto add = [&](const Vec2& in_field) {
        const Vec2 world = body.world_from_field * in_field;
        if (window.contains(world)) places.push_back(world);
    };
    const Solid& solid = body.of();
    for (int i = 0; i < solid.piece_count; ++i) {
        const sdf::Piece& piece = at(body.field->pieces, solid.first_piece + i).piece;
        add(piece.a);
        if (piece.is_arc()) {
            for (int k = 0; k < directions; ++k) {
                const double angle = 2 * pi * k / directions;
                const Vec2 direction(cosine(angle), sine(angle));
                if (sdf::in_sweep(piece, direction)) add(piece.centre + piece.radius * direction);
            }
            continue;
        }
        const int count = std::min(most_of_a_piece, static_cast<int>(length(piece.b - piece.a) / step));
        for (int k = 1; k <= count; ++k) add(piece.a + (static_cast<double>(k) / (count + 1)) * (piece.b - piece.a));
    }
    if (solid.piece_count > 0 || !window.is_finite()) return places;
    for (double x = window.lo.x(); x <= window.hi.x(); x += step)
        for (double y = window.lo.y(); y <= window.hi.y(); y += step) {
            if (std::fabs(seen_from(body, {x, y}).distance) > step) continue;
            if (const auto foot = foot_from(Vec2(x, y), [&](const Vec2& p) { return seen_from(body, p); })) places.push_back(*foot);
        }
    return places;
}

/// From surface to surface and back, to where neither foot moves: the two places that are nearest to each other thereabouts. Between round
/// solids that nearly touch each round goes a fixed share of the way only, so that Aitken's guess of where it leads is tried as well.
std::optional<NarrowGap> settled(Vec2 a, std::span<const Body> mine, std::span<const Body> others) {
    constexpr int most_rounds = 60;
    const auto on_mine = [&](const Vec2& from) { return foot_from(from, [&](const Vec2& p) { return seen_from(mine, p); }); };
    const auto on_others = [&](const Vec2& from) { return foot_from(from, [&](const Vec2& p) { return seen_from(others, p); }); };
    double step_before = 0;
    for (int i = 0; i < most_rounds; ++i) {
        const auto b = on_others(a);
        const auto next = b ? on_mine(*b) : std::nullopt;
        if (!next) return {};
        const double width = length(*next - *b), step = length(*next - a);
        if (width <= no_gap) return {};
        if (step <= still) return NarrowGap{width, *next, *b, seen_from(others, *b).node};
        const double share = step_before > step ? step / step_before : 0;
        const auto guess = share > 0 ? on_mine(*next + share / (1 - share) * (*next - a)) : std::nullopt;
        const bool better = guess && seen_from(others, *guess).distance < seen_from(others, *next).distance;
        step_before = better ? 0 : step;
        a = better ? *guess : *next;
    }
    return {};
}

/// Places of the moved surface from which to look, the nearest to the others first: not too many, and none beside another.
std::vector<Vec2> starts(std::span<const Body> mine, std::span<const Body> others, const Box2& window, double diameter) {
    constexpr std::size_t most = 16;
    const double step = 0.2 * diameter;
    std::vector<std::pair<double, Vec2>> near;
    for (const Body& body : mine)
        for (const Vec2& place : surface_places(body, window, step)) {
            const double distance = seen_from(others, place).distance;
            if (distance > 0 && distance < diameter + step) near.emplace_back(distance, place);
        }
    std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Vec2> out;
    for (const auto& [distance, place] : near) {
        if (out.size() == most) break;
        const bool beside =
            std::any_of(out.begin(), out.end(), [&, here = place](const Vec2& other) { return length(other - here) < 2 * step; });
        if (!beside) out.push_back(place);
    }
    return out;
}

/// Nothing else stands in the gap, and it is a gap: its middle lies outside of both.
bool is_open(const NarrowGap& gap, std::span<const Body> mine, std::span<const Body> others) {
    const Vec2 middle = 0.5 * (gap.a + gap.b);
    return seen_from(mine, middle).distance > 0.4 * gap.width && seen_from(others, middle).distance > 0.4 * gap.width;
}

/// The solids of the nodes, which are taken out of `others`; and of a child, the solid it is part of.
std::vector<Body> take_moved(const Scene& scene, const std::vector<NodeId>& moved, std::vector<Body>& others) {
    const auto belongs = [&](const Body& body) {
        const NodeId origin = body.of().origin;
        return std::any_of(moved.begin(), moved.end(),
                           [&](NodeId node) { return origin == node || scene.is_within(origin, node) || scene.is_within(node, origin); });
    };
    const auto first_mine = std::stable_partition(others.begin(), others.end(), [&](const Body& body) { return !belongs(body); });
    std::vector<Body> mine(first_mine, others.end());
    others.erase(first_mine, others.end());
    return mine;
}

}  // namespace

std::optional<NarrowGap> narrowest_gap(const AppState& state, const std::vector<NodeId>& moved, double diameter) {
    std::vector<Body> others = all_bodies(state);
    const std::vector<Body> mine = take_moved(state.document.scene(), moved, others);
    Box2 window;
    for (const NodeId node : moved) window = window.merged(bounds_of(state, node));
    if (mine.empty() || window.is_empty() || !window.is_finite()) return {};
    window = window.grown(1e-6);
    LayerMask layers = 0;
    for (const Body& body : mine) layers |= body.of().layers;
    const Box2 near = window.grown(diameter);
    std::erase_if(others, [&](const Body& body) { return !(body.of().layers & layers) || !body.bounds.overlaps(near); });

    std::optional<NarrowGap> best;
    for (const Vec2& start : starts(mine, others, window, diameter)) {
        const auto gap = settled(start, mine, others);
        if (gap && gap->width < (best ? best->width : diameter) && is_open(*gap, mine, others)) best = gap;
    }
    return best;
}

std::vector<FreeStretch> free_stretches(const World& world, const Vec2& from, const Vec2& to) {
    constexpr double least_step = 2e-5;  // metres: thinner walls are stepped over
    const double whole = length(to - from);
    std::vector<FreeStretch> out;
    if (!(whole > 0)) return out;
    const auto distance_at = [&](double along) { return gap_at(world, from + (along / whole) * (to - from)).distance; };
    const auto crossing = [&](double a, double b) {
        const bool inside = distance_at(a) <= 0;
        for (int i = 0; i < 40; ++i) {
            const double middle = 0.5 * (a + b);
            ((distance_at(middle) <= 0) == inside ? a : b) = middle;
        }
        return 0.5 * (a + b);
    };
    double along = 0, distance = distance_at(0);
    bool starts_free = distance > 0;
    if (starts_free) out.push_back({0, whole, false});
    // A hair inside counts as on the edge: the way may begin there.
    const bool begins_at_edge = std::fabs(distance) <= 1e-6;
    while (along < whole) {
        const double next = std::min(whole, along + std::max(least_step, 0.99 * std::fabs(distance)));
        const double there = distance_at(next);
        if ((there > 0) != (distance > 0)) {
            const double edge = crossing(along, next);
            if (there > 0)
                out.push_back({edge, whole, true});
            else
                out.back().end = edge;
            if (there <= 0) out.back().closed = out.back().begin > 0 || begins_at_edge;
        }
        along = next;
        distance = there;
    }
    if (!out.empty() && out.back().end == whole)
        out.back().closed = (out.back().begin > 0 || begins_at_edge) && std::fabs(distance) <= 1e-6;
    std::erase_if(out, [](const FreeStretch& stretch) { return stretch.length() < 2e-6; });
    return out;
}

Vec2 measured_place(const AppState& state, const Vec2& hand, double reach, double grid) {
    double nearest = reach;
    std::optional<Vec2> middle;
    for (const Box2& box : boxes_beside(state, {})) {
        const double distance = length(box.centre() - hand);
        if (distance > nearest) continue;
        nearest = distance;
        middle = box.centre();
    }
    if (middle) return *middle;
    const World& world = state.session.world();
    const Gap gap = gap_at(world, hand);
    if (std::fabs(gap.distance) <= reach) {
        const auto foot = foot_from(hand, [&](const Vec2& p) {
            const Gap seen = gap_at(world, p);
            const double norm = length(seen.gradient);
            return Seen{seen.distance, norm > 0 ? Vec2(seen.gradient / norm) : Vec2(0, 0), seen.node};
        });
        if (foot && length(*foot - hand) <= 2 * reach) return *foot;
    }
    return {on_grid(hand.x(), grid), on_grid(hand.y(), grid)};
}

}  // namespace pinfield::editor
