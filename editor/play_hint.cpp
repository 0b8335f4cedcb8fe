#include "editor/play_hint.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/core/at.h"

namespace pinfield::editor {
namespace {

constexpr double still = 0.02;  // m/s: what lies on a rod that is drawn back moves with it

/// The first key of the first input that moves the part; empty: there is none.
std::string key_of(const AppState& state, const Part& part) {
    if (part.inputs.empty()) return {};
    const std::string& input = at(state.session.program().inputs, part.inputs.front());
    const auto& bindings = state.document.scene().inputs;
    const auto found = std::find_if(bindings.begin(), bindings.end(), [&](const InputBinding& b) { return b.name == input; });
    return found == bindings.end() || found->keys.empty() ? std::string() : found->keys.front();
}

}  // namespace

std::optional<PlayHint> play_hint(const AppState& state) {
    if (!plays(state)) return {};
    const Program& program = state.session.program();
    const World& world = state.session.world();
    const double r = program.physics.ball_radius;
    for (const Ball& ball : world.balls()) {
        if (!is_on_table(ball) || length(ball.velocity) > still) continue;
        const Gap gap = gap_at(world, ball.position, ball.layer);
        if (gap.mover < 0 || gap.distance > 1.1 * r || !at(program.movers, gap.mover).slides) continue;
        const std::string key = key_of(state, at(program.parts, at(program.movers, gap.mover).part));
        if (!key.empty()) return PlayHint{fmt::format("Hold {} to shoot", key), ball.position};
    }
    return {};
}

}  // namespace pinfield::editor
