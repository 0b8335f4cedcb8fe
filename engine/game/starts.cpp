#include "engine/game/starts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/error_codes.h"
#include "engine/core/numbers.h"
#include "engine/physics/free_place.h"
#include "engine/physics/start.h"
#include "engine/program/distance_quality.h"
#include "engine/scene/parts/spawn.h"

namespace pinfield {
namespace {

/// Three digits are as much as one reads; what is less than a micrometre counts as none.
std::string millimetres(double metres) { return fmt::format("{:.3g} mm", 1e3 * metres); }

std::string name_of(const Scene& scene, NodeId node) {
    return scene.find(node) && node != scene.table().id ? scene.path(node) : "the table's edge";
}

bool is_free(const Program& program, const Vec2& p, LayerMask layers) { return start_at(program, p, layers).hindrance == Hindrance::none; }

/// The free place as a person would write it: in whole millimetres where one beside it is free, too.
Vec2 tidy(const Program& program, const Vec2& place, LayerMask layers) {
    Vec2 best = place;
    double least = infinity;
    const Vec2 first(std::floor(1e3 * place.x()), std::floor(1e3 * place.y()));
    for (int dx = -1; dx <= 2; ++dx)
        for (int dy = -1; dy <= 2; ++dy) {
            const Vec2 p = (first + Vec2(dx, dy)) / 1e3;
            const double away = length(p - place);
            if (away < least && is_free(program, p, layers)) least = away, best = p;
        }
    return best;
}

/// From where to look for room: on the table, however far away the start is.
std::optional<Vec2> room_near(const Program& program, const Vec2& at, LayerMask layers) {
    const Vec2 from(std::clamp(at.x(), 0.0, program.size.x()), std::clamp(at.y(), 0.0, program.size.y()));
    if (is_free(program, from, layers)) return from;
    const std::optional<Vec2> place = free_start(program, from, layers, length(program.size));
    if (!place) return {};
    return tidy(program, *place, layers);
}

std::string hint_of(const std::optional<Vec2>& room) {
    return room ? fmt::format("the nearest place on the table with room for a ball is [{}, {}]", to_text(room->x()), to_text(room->y())) : "";
}

}  // namespace

std::optional<Diagnostic> impossible_start(const Program& program, const Scene& scene, const Vec2& at, LayerMask layers, Place where) {
    const Start start = start_at(program, at, layers);
    if (start.hindrance == Hindrance::none) return {};
    const std::optional<Vec2> room = room_near(program, at, layers);
    if (!room)
        return diagnose(Code::ball_too_large, where,
                        fmt::format("a ball of radius {} fits nowhere on the table", millimetres(program.physics.ball_radius)),
                        "physics.ball_radius says how large balls are");
    const std::string node = name_of(scene, start.node);
    switch (start.hindrance) {
        case Hindrance::outside:
            return diagnose(Code::start_outside, where,
                            fmt::format("a ball cannot start here: it would be outside of {}, where no ball may be", node), hint_of(room));
        case Hindrance::drain:
            return diagnose(Code::start_in_drain, where, fmt::format("a ball cannot start here: it would be in {} at once", node), hint_of(room));
        default:
            return diagnose(Code::start_in_solid, where,
                            fmt::format("a ball cannot start here: it would be {} deep in {}", millimetres(start.depth), node), hint_of(room));
    }
}

Diagnostics doubts_of(const Program& program, const Scene& scene) {
    Diagnostics out = warnings_of(program, scene);
    bool too_large = false;  // said once
    const auto take = [&](const Vec2& at, LayerMask layers, Place where) {
        std::optional<Diagnostic> found = impossible_start(program, scene, at, layers, where);
        if (!found) return;
        const bool again = found->code == entry(Code::ball_too_large).code && std::exchange(too_large, true);
        if (!again) out.push_back(std::move(*found));
    };
    for (const Part& part : program.parts) {
        const Node* node = scene.find(part.origin);
        if (part.is<parts::Spawn>() && node) take(part.world_from_part.offset, part.layers, node->key);
    }
    for (const TableTest& test : scene.tests)
        for (const TableTest::Launch& launch : test.launches) take(launch.at, ground_layer, launch.where);
    return out;
}

}  // namespace pinfield
