#include "editor/session.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/core/at.h"
#include "engine/program/compile.h"
#include "engine/program/patch.h"
#include "engine/program/pose.h"
#include "engine/program/distance_quality.h"
#include "engine/scene/parts/bumper.h"
#include "engine/scene/parts/spawn.h"

namespace pinfield::editor {
namespace {

constexpr double seconds_until_back = 1;

/// For a table that does not compile when it is opened: its size and nothing on it.
ProgramPtr empty_program(const Scene& scene) {
    Scene empty(scene.shared_catalog());
    for (std::size_t i = 0; i < scene.table().fields.size(); ++i) empty.table().fields[i].value = scene.table().fields[i].value;
    if (auto program = compile(empty)) return *program;
    return std::make_shared<const Program>();
}

/// Notes for every op below a bumper's solid whose bumper it is: events name the leaf that was hit.
void note_bumper(const Field& field, const Solid& solid, NodeId bumper, std::map<NodeId, NodeId>& bumper_of) {
    bumper_of[bumper] = bumper;
    std::vector<int> open{solid.root};
    while (!open.empty()) {
        const Op& op = at(field.ops, open.back());
        open.pop_back();
        bumper_of[op.origin] = bumper;
        for (int i = 0; i < op.child_count; ++i) open.push_back(at(field.links, op.first_link + i));
    }
}

std::map<NodeId, NodeId> bumpers_of(const Program& program) {
    std::map<NodeId, NodeId> bumper_of;
    for (const Solid& solid : program.fixed.solids) {
        if (solid.part < 0) continue;
        const Part& part = at(program.parts, solid.part);
        if (part.is<parts::Bumper>()) note_bumper(program.fixed, solid, part.origin, bumper_of);
    }
    return bumper_of;
}

const Part* spawn_part(const Program& program, NodeId node) {
    const auto is_it = [&](const Part& part) { return part.origin == node && part.is<parts::Spawn>(); };
    const auto found = std::find_if(program.parts.begin(), program.parts.end(), is_it);
    return found == program.parts.end() ? nullptr : &*found;
}

}  // namespace

Session::Session(const Document& document) {
    auto program = compile(document.scene());
    if (!program) {
        problems_ = program.error();
        stale_ = true;
    }
    start(program ? *program : empty_program(document.scene()));
    if (program) problems_ = warnings_of(**program, document.scene());
}

void Session::start(ProgramPtr program) {
    bumper_of_ = bumpers_of(*program);
    world_.emplace(std::move(program));
    world_->add_spawned_balls();
    owed_ticks_ = hits_ = drained_ = 0;
    hits_by_node_.clear();
    back_at_tick_.clear();
    spawn_of_.clear();
    std::size_t next = 0;  // one ball per spawn, in the order of the parts
    for (const Part& part : this->program().parts)
        if (part.is<parts::Spawn>() && next < world_->balls().size()) spawn_of_[world_->balls()[next++].id] = part.origin;
    for (const std::string& input : std::set<std::string>(held_)) press(input, true);
}

void Session::reset() { start(world_->shared_program()); }

void Session::single_step() {
    playing_ = false;
    step();
}

void Session::set_slow_motion(int divisor) {
    slow_motion_ = std::clamp(divisor, 1, slowest);
    owed_ticks_ = 0;
}

void Session::follow(Document& document) {
    const std::vector<SceneChange> changes = document.take_changes();
    if (changes.empty()) return;
    std::vector<FieldChange> fields;
    for (const SceneChange& change : changes)
        if (!change.everything) fields.push_back({change.node, change.field});
    if (fields.size() == changes.size() && !stale_) {
        if (ProgramPtr patched = patch(program(), document.scene(), fields)) return adopt(std::move(patched), document.scene());
    }
    auto compiled = compile(document.scene());
    stale_ = !compiled;
    if (compiled) adopt(*compiled, document.scene());
    else problems_ = compiled.error();
}

void Session::adopt(ProgramPtr program, const Scene& scene) {
    problems_ = warnings_of(*program, scene);
    const bool same_inputs = program->inputs == this->program().inputs;
    if (!same_inputs)
        for (std::size_t i = 0; i < this->program().inputs.size(); ++i) world_->set_input(static_cast<int>(i), 0);
    bumper_of_ = bumpers_of(*program);
    world_->set_program(std::move(program));
    if (!same_inputs)
        for (const std::string& input : std::set<std::string>(held_)) press(input, true);
}

void Session::press(const std::string& input, bool down) {
    if (down) held_.insert(input);
    else held_.erase(input);
    const std::vector<std::string>& inputs = program().inputs;
    const auto found = std::find(inputs.begin(), inputs.end(), input);
    if (found != inputs.end()) world_->set_input(static_cast<int>(found - inputs.begin()), down ? 1 : 0);
}

void Session::release_all() {
    for (const std::string& input : std::set<std::string>(held_)) press(input, false);
}

void Session::advance(int ticks) {
    if (!playing_) return;
    owed_ticks_ += ticks;
    const int due = owed_ticks_ / slow_motion_;
    owed_ticks_ -= due * slow_motion_;
    for (int i = 0; i < due; ++i) step();
}

void Session::step() {
    put_balls_back();
    world_->step();
    count_events();
}

/// A hit is a ball on a bumper in a tick, whether the bumper kicked or the ball came too slowly: both may be told of one impact.
void Session::count_events() {
    std::set<std::pair<BallId, NodeId>> counted;
    for (const Event& event : world_->events()) {
        if (event.kind == EventKind::drain) {
            ++drained_;
            back_at_tick_[event.ball] = world_->tick() + std::llround(seconds_until_back / world_->step_length());
        }
        if (event.kind != EventKind::hit && event.kind != EventKind::kick) continue;
        const auto bumper = bumper_of_.find(event.node);
        if (bumper == bumper_of_.end() || !counted.insert({event.ball, bumper->second}).second) continue;
        ++hits_;
        ++hits_by_node_[bumper->second];
    }
}

void Session::put_balls_back() {
    for (auto it = back_at_tick_.begin(); it != back_at_tick_.end();) {
        if (it->second > world_->tick()) {
            ++it;
            continue;
        }
        const BallId ball = it->first;
        it = back_at_tick_.erase(it);
        if (!world_->find(ball)) continue;
        world_->put_back(ball);
        // The spawn may have been moved since the ball first started there.
        const auto spawn = spawn_of_.find(ball);
        const Part* part = spawn == spawn_of_.end() ? nullptr : spawn_part(program(), spawn->second);
        if (!part) continue;
        const Point<double> velocity = part->as<parts::Spawn>().velocity;
        world_->set_ball(ball, part->world_from_part.offset, part->world_from_part.direction({velocity.x, velocity.y}));
    }
}

int Session::hits_of(NodeId node) const {
    const auto found = hits_by_node_.find(node);
    return found == hits_by_node_.end() ? 0 : found->second;
}

Similarity Session::world_from_mover(int mover) const {
    return pinfield::world_from_mover(at(program().movers, mover), at(world_->movers(), mover).q);
}

}  // namespace pinfield::editor
