// What of a World persists from one tick to the next: all that its future depends on, beside its program and the inputs to come.
// Hashes see every value of it, snapshots copy it; whatever else a World holds is scratch or report (state.h).
#pragma once
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "engine/physics/ball.h"
#include "engine/physics/world.h"

namespace pinfield {

/// A surface that a ball can touch.
struct SurfaceRef {
    int mover = -1;  ///< -1: the static field
    int solid = -1, piece = -1;
    bool operator==(const SurfaceRef&) const = default;
};

/// What is known of a ball beside its motion.
struct BallMemory {
    SurfaceRef slide;             ///< on which it last stopped bouncing
    std::int64_t slide_tick = -2; ///< when
    bool embedded = false;        ///< an edit put it into a solid, and it is being moved out
    bool waiting = false;         ///< to be put back as soon as it can start where it does
    bool held_back = false;       ///< by something that stays there or another ball, and that was told
    int quiet_ticks = 0;          ///< for how long it has hardly moved, in a pile
    Vec2 still_place{0, 0};       ///< about which it has been ...
    int still_ticks = 0;          ///< ... for so long
    bool stuck = false;           ///< that was too long, and it was told
};

/// An input that changes at the start of the next tick.
struct InputEdge {
    int input = 0;
    bool pressed = false;
};

struct PersistentState {
    WorldOptions options;  ///< the seed among them; a draw depends on seed, tick and ball alone
    std::int64_t tick = 0;
    std::uint32_t next_ball = 1;
    std::vector<Ball> balls;
    std::vector<BallMemory> memories;  ///< one a ball
    std::vector<BallTouch> open_touches;    ///< in order of their balls' ids
    std::vector<MoverState> movers;
    std::vector<std::uint8_t> pressed;  ///< one an input of the program, 0 or 1
    std::vector<InputEdge> edges;       ///< in the order in which they came
};

/// A fingerprint of every value.
std::uint64_t hash_of(const PersistentState& state);

/// How many members each struct has. A member that is added or removed does not compile until its number here follows, and then
/// it is hashed.
template <class T> inline constexpr int member_count = 0;
template <> inline constexpr int member_count<PersistentState> = 9;
template <> inline constexpr int member_count<WorldOptions> = 6;
template <> inline constexpr int member_count<Ball> = 10;
template <> inline constexpr int member_count<BallMemory> = 9;
template <> inline constexpr int member_count<SurfaceRef> = 3;
template <> inline constexpr int member_count<MoverState> = 10;
template <> inline constexpr int member_count<BallTouch> = 14;
template <> inline constexpr int member_count<InputEdge> = 2;

/// Calls f with each member of a struct, in order.
template <class T, class F>
void each_member(T& value, F&& f) {
    constexpr int count = member_count<std::remove_const_t<T>>;
    const auto all = [&f](auto&... members) { (f(members), ...); };
    if constexpr (count == 2) {
        auto& [a, b] = value;
        all(a, b);
    } else if constexpr (count == 3) {
        auto& [a, b, c] = value;
        all(a, b, c);
    } else if constexpr (count == 4) {
        auto& [a, b, c, d] = value;
        all(a, b, c, d);
    } else if constexpr (count == 6) {
        auto& [a, b, c, d, e, g] = value;
        all(a, b, c, d, e, g);
    } else if constexpr (count == 9) {
        auto& [a, b, c, d, e, g, h, i, j] = value;
        all(a, b, c, d, e, g, h, i, j);
    } else if constexpr (count == 10) {
        auto& [a, b, c, d, e, g, h, i, j, k] = value;
        all(a, b, c, d, e, g, h, i, j, k);
    } else {
        static_assert(count == 14, "bind this many members here");
        auto& [a, b, c, d, e, g, h, i, j, k, l, m, n, o] = value;
        all(a, b, c, d, e, g, h, i, j, k, l, m, n, o);
    }
}

/// Calls visit(v) with everything of which `value` consists, however deep: with numbers, bools and choices, and with lists and
/// optional values before what is in them.
template <class T, class Visit>
void each_value(T& value, Visit&& visit) {
    using Plain = std::remove_const_t<T>;
    if constexpr (std::is_arithmetic_v<Plain> || std::is_enum_v<Plain>) {
        visit(value);
    } else if constexpr (std::is_same_v<Plain, Vec2>) {
        visit(value.x());
        visit(value.y());
    } else if constexpr (std::is_same_v<Plain, BallId> || std::is_same_v<Plain, NodeId>) {
        visit(value.value);
    } else if constexpr (requires { value.has_value(); }) {
        visit(value);
        if (value) each_value(*value, visit);
    } else if constexpr (requires { value.size(); }) {
        visit(value);
        for (auto& element : value) each_value(element, visit);
    } else {
        each_member(value, [&](auto& member) { each_value(member, visit); });
    }
}

}  // namespace pinfield
