#include "editor/session.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/core/at.h"
#include "engine/game/starts.h"
#include "engine/program/compile.h"
#include "engine/program/patch.h"
#include "engine/program/pose.h"

namespace pinfield::editor {
namespace {

/// For a table that does not compile when it is opened: its size and nothing on it.
ProgramPtr empty_program(const Scene& scene) {
    Scene empty(scene.shared_catalog());
    for (std::size_t i = 0; i < scene.table().fields.size(); ++i) empty.table().fields[i].value = scene.table().fields[i].value;
    if (auto program = compile(empty)) return *program;
    return std::make_shared<const Program>();
}

}  // namespace

Session::Session(const Document& document) {
    auto program = compile(document.scene());
    if (!program) {
        problems_ = program.error();
        stale_ = true;
    }
    start(program ? *program : empty_program(document.scene()), parents_of(document.scene()));
    if (program) problems_ = doubts_of(**program, document.scene());
}

void Session::start(ProgramPtr program, NodeParents parents) {
    World world(std::move(program));
    world.add_spawned_balls();
    game_.emplace(std::move(world), std::move(parents));
    owed_ticks_ = 0;
    press_held();
}

void Session::reset() { start(world().shared_program(), game_->parents()); }

void Session::single_step() {
    playing_ = false;
    game_->step();
}

void Session::set_slow_motion(int divisor) {
    slow_motion_ = std::clamp(divisor, 1, slowest);
    owed_ticks_ = 0;
}

void Session::follow(Document& document) {
    left_.clear();
    const std::vector<SceneChange> changes = document.take_changes();
    if (changes.empty()) return;
    std::vector<FieldChange> fields;
    for (const SceneChange& change : changes)
        if (!change.everything) fields.push_back({change.node, change.field});
    if (fields.size() == changes.size() && !stale_) {
        if (ProgramPtr patched = patch(program(), document.scene(), fields)) {
            game_->set_program(std::move(patched));
            return judge(document.scene());
        }
    }
    auto compiled = compile(document.scene());
    stale_ = !compiled;
    if (stale_) {
        problems_ = compiled.error();
        return;
    }
    game_->set_program(std::move(*compiled), parents_of(document.scene()));
    press_held();
    judge(document.scene());
}

void Session::judge(const Scene& scene) {
    problems_ = doubts_of(program(), scene);
    left_ = game_->free_balls();
}

/// Keys may be down since before the table had the inputs they are bound to.
void Session::press_held() {
    for (const std::string& input : std::set<std::string>(held_)) press(input, true);
}

void Session::press(const std::string& input, bool down) {
    if (down) held_.insert(input);
    else held_.erase(input);
    const std::vector<std::string>& inputs = program().inputs;
    const auto found = std::find(inputs.begin(), inputs.end(), input);
    if (found != inputs.end()) game_->set_input(static_cast<int>(found - inputs.begin()), down ? 1 : 0);
}

void Session::release_all() {
    for (const std::string& input : std::set<std::string>(held_)) press(input, false);
}

void Session::advance(int ticks) {
    if (!playing_) return;
    owed_ticks_ += ticks;
    const int due = owed_ticks_ / slow_motion_;
    owed_ticks_ -= due * slow_motion_;
    for (int i = 0; i < due; ++i) game_->step();
}

Similarity Session::world_from_mover(int mover) const {
    return pinfield::world_from_mover(at(program().movers, mover), at(world().movers(), mover).q);
}

}  // namespace pinfield::editor
