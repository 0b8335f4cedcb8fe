#include "engine/game/game.h"

#include <algorithm>
#include <cmath>

#include "engine/core/at.h"
#include "engine/core/hash.h"
#include "engine/physics/free_place.h"
#include "engine/scene/parts/bumper.h"

namespace pinfield {

NodeParents parents_of(const Scene& scene) {
    NodeParents parents;
    for (const NodeId id : scene.all())
        if (const NodeId parent = scene.find(id)->parent) parents[id] = parent;
    return parents;
}

Game::Game(World world, NodeParents parents, GameOptions options)
    : world_(std::move(world)), parents_(std::move(parents)), options_(options) {}

void Game::step() {
    put_balls_back();
    world_.step();
    count_events();
}

void Game::set_input(int input, double value) {
    if (world_.set_input(input, value)) input_log_.push_back({world_.tick(), input, value});
}

void Game::set_program(ProgramPtr program, NodeParents parents) {
    set_program(std::move(program));
    parents_ = std::move(parents);
}

std::vector<NodeId> Game::free_balls(double reach) {
    std::vector<NodeId> left;
    const std::vector<Ball> balls(world_.balls().begin(), world_.balls().end());
    for (const Ball& ball : balls) {
        if (overlap_of(world_, ball) == 0) continue;
        const Gap gap = gap_at(world_, ball.position, ball.layer);
        left.push_back(gap.node);
        const std::optional<Vec2> place = free_place(world_, ball, reach);
        if (!place) {
            world_.put_back(ball.id);
            continue;
        }
        // Not faster than it was, and not back into what it came out of.
        const Vec2 out = *place - ball.position, n = out / std::max(length(out), 1e-12);
        world_.set_ball(ball.id, *place, ball.velocity - std::min(0.0, dot(ball.velocity, n)) * n);
    }
    return left;
}

void Game::put_balls_back() {
    for (const Return& due : returns_)
        if (due.tick <= world_.tick()) world_.put_back(due.ball);
    std::erase_if(returns_, [&](const Return& due) { return due.tick <= world_.tick(); });
}

void Game::expect_back(BallId ball) {
    if (!options_.launched_come_back && world_.find(ball)->spawn < 0) return;
    returns_.push_back({world_.tick() + std::llround(options_.seconds_until_back / world_.step_length()), ball});
}

void Game::count_events() {
    touched_.clear();
    for (const Event& event : world_.events()) {
        ++at(events_, event.kind);
        if (event.kind == EventKind::drain) expect_back(event.ball);
        if (event.kind != EventKind::hit && event.kind != EventKind::drain) continue;
        bool is_bumper = event.part >= 0 && at(world_.program().parts, event.part).is<parts::Bumper>();
        for (NodeId node = event.node; node; is_bumper = false) {
            touched_.push_back({event.ball, node, is_bumper});
            const auto parent = parents_.find(node);
            node = parent == parents_.end() ? NodeId{} : parent->second;
        }
    }
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    for (const Touched& touched : touched_) {
        ++hits_[touched.node];
        bumper_hits_ += touched.is_bumper;
    }
}

std::int64_t Game::hits_of(NodeId node) const {
    const auto found = hits_.find(node);
    return found == hits_.end() ? 0 : found->second;
}

std::uint64_t Game::state_hash() const {
    Hash64 hash;
    hash.feed(world_.state_hash()).feed(returns_.size());
    for (const Return& due : returns_) hash.feed(due.tick).feed(due.ball.value);
    for (const std::int64_t count : events_) hash.feed(count);
    for (const auto& [node, count] : hits_) hash.feed(node.value).feed(count);
    return hash.feed(bumper_hits_).value();
}

}  // namespace pinfield
