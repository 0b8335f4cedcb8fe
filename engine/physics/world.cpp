#include "engine/physics/world.h"

#include <algorithm>

#include "engine/core/at.h"
#include "engine/physics/contact.h"
#include "engine/physics/start.h"
#include "engine/physics/state.h"
#include "engine/program/evaluate.h"
#include "engine/program/parts.h"
#include "engine/program/pose.h"
#include "engine/scene/parts/spawn.h"

namespace pinfield {

struct World::State : WorldState {};

namespace {

std::vector<SweptField> swept_movers(const Program& program) {
    std::vector<SweptField> swept;
    for (const Mover& mover : program.movers) swept.emplace_back(mover.field);
    return swept;
}

void take_physics(WorldState& w) {
    w.physics = w.program().physics;
    if (w.options.integrator) w.physics.integrator = *w.options.integrator;
    if (w.options.step) w.physics.step = *w.options.step;
    w.band.tolerance = w.physics.tolerance;
}

void fresh_movers(WorldState& w) {
    w.movers.clear();
    for (std::size_t m = 0; m < w.program().movers.size(); ++m) w.movers.push_back(mover_at_rest(w.program(), static_cast<int>(m)));
}

std::vector<double> places(const WorldState& w) {
    std::vector<double> q;
    for (const MoverState& s : w.movers) q.push_back(s.q);
    return q;
}

/// A ball that overlaps something is moved out over the next ticks.
void check_embedded(WorldState& w, std::size_t i) {
    const double r = w.physics.ball_radius;
    const Gap gap = gap_at(w.program(), places(w), w.balls[i].position, w.balls[i].layer, 2 * r);
    w.memories[i].embedded = gap.distance < r;
}

void place_ball(WorldState& w, std::size_t i, const Vec2& position, const Vec2& velocity) {
    Ball& ball = w.balls[i];
    if (w.in_play(i)) wake(w, i);  // what rests on it
    ball.position = position;
    ball.velocity = velocity;
    ball.spin = ball.free_path = 0;
    ball.state = BallState::rolling;
    w.memories[i] = {};
    w.memories[i].still_place = position;
    check_embedded(w, i);
}

/// Does another ball stand where this one starts?
bool start_is_taken(const WorldState& w, std::size_t i) {
    const double touch = 2 * w.physics.ball_radius + w.band.target();
    for (std::size_t j = 0; w.options.balls_collide && j < w.balls.size(); ++j)
        if (j != i && w.in_play(j) && share_layer(w.balls[i], w.balls[j]) && length(w.balls[j].position - w.balls[i].start_position) < touch) return true;
    return false;
}

/// What a ball has to wait for before it can start: `start`, or another ball.
struct Wait {
    Start start;
    bool by_ball = false;
    explicit operator bool() const { return by_ball || start.hindrance != Hindrance::none; }
};

Wait wait_of(const WorldState& w, std::size_t i) {
    const Ball& ball = w.balls[i];
    Wait wait{start_at(w.program(), places(w), ball.start_position, ball.layer), start_is_taken(w, i)};
    if (wait) return wait;
    for (std::size_t m = 0; m < w.movers.size(); ++m) {  // one that moves is to be clear of it
        if (stands(w, static_cast<int>(m))) continue;
        const Mover& mover = w.program().movers[m];
        const Vec2 seen = pose_of(mover, w.movers[m].q).place_from_world(ball.start_position);
        const double touch = w.physics.ball_radius + w.band.target();
        if (nearest(mover.field, seen, ball.layer, touch).distance < touch) wait.start = {Hindrance::mover, {}, 0, static_cast<int>(m)};
    }
    return wait;
}

std::size_t index_of(const WorldState& w, BallId id) {
    const auto found = std::find_if(w.balls.begin(), w.balls.end(), [&](const Ball& b) { return b.id == id; });
    return static_cast<std::size_t>(found - w.balls.begin());
}

/// What an input will be once the edges that wait are applied.
bool will_be_pressed(const WorldState& w, int input) {
    bool pressed = at(w.pressed, input) != 0;
    for (const InputEdge& edge : w.edges)
        if (edge.input == input) pressed = edge.pressed;
    return pressed;
}

/// Inputs and the edges that wait are known by name from one program to the next; those of inputs that are gone go.
void keep_inputs(WorldState& w, const Program& before) {
    const std::vector<std::string>& inputs = w.program().inputs;
    const auto now = [&](int input) {
        const auto found = std::find(inputs.begin(), inputs.end(), at(before.inputs, input));
        return found == inputs.end() ? -1 : static_cast<int>(found - inputs.begin());
    };
    std::vector<std::uint8_t> pressed(inputs.size(), 0);
    for (int k = 0; k < static_cast<int>(before.inputs.size()); ++k)
        if (const int input = now(k); input >= 0) at(pressed, input) = at(w.pressed, k);
    w.pressed = std::move(pressed);
    for (InputEdge& edge : w.edges) edge.input = now(edge.input);
    std::erase_if(w.edges, [](const InputEdge& edge) { return edge.input < 0; });
}

Vec2 start_velocity_of(const Part& spawn) {
    const Point<double> velocity = spawn.as<parts::Spawn>().velocity;
    return spawn.world_from_part.direction({velocity.x, velocity.y});
}

/// Balls start where their spawns are now; one whose spawn is gone starts where it last was.
void follow_spawns(WorldState& w, const Program& before) {
    const std::vector<Part>& parts = w.program().parts;
    for (Ball& ball : w.balls) {
        if (ball.spawn < 0) continue;
        const NodeId origin = at(before.parts, ball.spawn).origin;
        const auto spawn = std::find_if(parts.begin(), parts.end(),
                                        [&](const Part& part) { return part.origin == origin && part.is<parts::Spawn>(); });
        ball.spawn = spawn == parts.end() ? -1 : static_cast<int>(spawn - parts.begin());
        if (ball.spawn < 0) continue;
        ball.start_position = spawn->world_from_part.offset;
        ball.start_velocity = start_velocity_of(*spawn);
    }
}

/// Balls stay on their layers, which are known by name; one whose layers are gone is on the ground.
void keep_layers(WorldState& w, const Program& before) {
    const std::vector<std::string>& layers = w.program().layers;
    for (Ball& ball : w.balls) {
        LayerMask kept = 0;
        for (std::size_t k = 0; k < before.layers.size(); ++k) {
            if ((ball.layer & (LayerMask{1} << k)) == 0) continue;
            const auto now = std::find(layers.begin(), layers.end(), before.layers[k]) - layers.begin();
            if (to_index(static_cast<int>(now)) < layers.size()) kept |= LayerMask{1} << now;
        }
        ball.layer = kept ? kept : ground_layer;
    }
}

/// Keeps the motion of a mover whose part is still there, within its new end-stops.
void keep_motion(MoverState& now, const MoverState& before) {
    now.q = std::clamp(before.q, now.q_min, now.q_max);
    now.rate = now.q == before.q ? before.rate : 0.0;
    now.driven = before.driven;
    now.drive_time = before.drive_time;
    now.launch_rate = before.launch_rate;
    now.rung = before.rung;
}

}  // namespace

PreparedProgram::PreparedProgram(ProgramPtr from)
    : program(std::move(from)), fixed(program->fixed), movers(swept_movers(*program)) {}

void try_put_back(WorldState& w, std::size_t i) {
    Ball& ball = w.balls[i];
    if (ball.spawn >= 0) ball.layer = at(w.program().parts, ball.spawn).layers;
    const Wait wait = wait_of(w, i);
    const bool tells = wait && (wait.by_ball || wait.start.hindrance != Hindrance::mover);
    if (tells && w.memories[i].waiting && !w.memories[i].held_back) {  // in a tick, where events are told
        w.events.push_back({w.tick, w.start_time(), EventKind::held_back, ball.id, wait.start.node, ball.start_position, {0, 0}, 0});
        w.memories[i].held_back = true;
    }
    w.memories[i].waiting = static_cast<bool>(wait);
    if (!w.memories[i].waiting) place_ball(w, i, ball.start_position, ball.start_velocity);
}

World::World(ProgramPtr program, WorldOptions options) : state_(std::make_unique<State>()) {
    state_->options = options;
    state_->prepared = std::make_shared<const PreparedProgram>(std::move(program));
    state_->pressed.assign(state_->program().inputs.size(), false);
    take_physics(*state_);
    fresh_movers(*state_);
}

World::~World() = default;
World::World(const World& other) : state_(std::make_unique<State>(*other.state_)) {}
World& World::operator=(const World& other) {
    state_ = std::make_unique<State>(*other.state_);
    return *this;
}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

void World::step() { run_tick(*state_); }

bool World::set_input(int input, double value) {
    State& w = *state_;
    const bool pressed = value > 0;
    if (input < 0 || input >= static_cast<int>(w.pressed.size()) || will_be_pressed(w, input) == pressed) return false;
    w.edges.push_back({input, pressed});
    return true;
}

BallId World::add_ball(const Vec2& position, const Vec2& velocity, double spin) {
    Ball ball;
    ball.id = BallId{state_->next_ball++};
    ball.position = ball.start_position = position;
    ball.velocity = ball.start_velocity = velocity;
    ball.spin = spin;
    state_->balls.push_back(ball);
    state_->memories.emplace_back();
    check_embedded(*state_, state_->balls.size() - 1);
    return ball.id;
}

void World::add_spawned_balls() {
    for (std::size_t k = 0; k < program().parts.size(); ++k) {
        const Part& part = program().parts[k];
        if (!part.is<parts::Spawn>()) continue;
        add_ball(part.world_from_part.offset, start_velocity_of(part));
        const std::size_t i = state_->balls.size() - 1;
        state_->balls[i].spawn = static_cast<int>(k);
        state_->balls[i].layer = part.layers;
        check_embedded(*state_, i);
        if (!wait_of(*state_, i)) continue;
        state_->balls[i].state = BallState::drained;
        state_->memories[i] = {};
        state_->memories[i].waiting = true;
    }
}

void World::put_back(BallId id) {
    const std::size_t i = index_of(*state_, id);
    if (i < state_->balls.size()) try_put_back(*state_, i);
}

void World::set_ball(BallId id, const Vec2& position, const Vec2& velocity) {
    const std::size_t i = index_of(*state_, id);
    if (i >= state_->balls.size()) return;
    place_ball(*state_, i, position, velocity);
}

void World::set_program(ProgramPtr program) {
    State& w = *state_;
    const auto before = w.prepared;  // keeps the old program alive while its movers are matched
    const std::vector<MoverState> movers = w.movers;
    w.prepared = std::make_shared<const PreparedProgram>(std::move(program));
    w.near.clear();    // its entries are those of the old field
    w.events.clear();  // their indices are those of the old program
    w.open_touches.clear();
    take_physics(w);
    fresh_movers(w);
    const auto origin = [](const Program& p, std::size_t m) { return at(p.parts, p.movers[m].part).origin; };
    for (std::size_t m = 0; m < w.movers.size(); ++m)
        for (std::size_t k = 0; k < movers.size(); ++k)
            if (origin(w.program(), m) == origin(*before->program, k) && w.program().movers[m].slides == before->program->movers[k].slides)
                keep_motion(w.movers[m], movers[k]);
    keep_inputs(w, *before->program);
    keep_layers(w, *before->program);
    follow_spawns(w, *before->program);
    for (std::size_t i = 0; i < w.balls.size(); ++i) {
        Ball& ball = w.balls[i];
        ball.free_path = 0;
        if (ball.state == BallState::resting || ball.state == BallState::jammed) ball.state = BallState::rolling;
        w.memories[i].slide_tick = -2;
        if (w.in_play(i)) check_embedded(w, i);
    }
}

const Program& World::program() const { return *state_->prepared->program; }
const ProgramPtr& World::shared_program() const { return state_->prepared->program; }
std::int64_t World::tick() const { return state_->tick; }
double World::step_length() const { return state_->physics.step; }
bool World::balls_collide() const { return state_->options.balls_collide; }
double World::time() const { return state_->start_time(); }
std::span<const Ball> World::balls() const { return state_->balls; }
std::span<const MoverState> World::movers() const { return state_->movers; }
std::span<const Event> World::events() const { return state_->events; }
std::span<const BallTouch> World::touches() const { return state_->open_touches; }
const WorldStats& World::stats() const { return state_->stats; }
void World::record_paths(bool on) { state_->recording = on; }
std::span<const PathSegment> World::paths() const { return state_->paths; }
std::span<const MoverSegment> World::mover_paths() const { return state_->mover_paths; }

const Ball* World::find(BallId id) const {
    const std::size_t i = index_of(*state_, id);
    return i < state_->balls.size() ? &state_->balls[i] : nullptr;
}

double World::energy(const Ball& ball) const {
    const PhysicsRecord& p = state_->physics;
    return p.ball_mass * (0.5 * twice_kinetic(p, ball, ball.velocity) - dot(p.gravity, ball.position));
}

double World::energy() const {
    double sum = 0;
    for (const Ball& ball : state_->balls)
        if (ball.state != BallState::drained && ball.state != BallState::quarantined) sum += energy(ball);
    return sum;
}

std::uint64_t World::state_hash() const { return hash_of(*state_); }

Gap gap_at(const Program& program, std::span<const double> q, const Vec2& p, LayerMask layers, double reach) {
    Gap gap;
    const auto take = [&](const Field& field, const Nearest& n, int mover, const Pose& pose) {
        if (n.solid < 0 || n.distance >= gap.distance) return;
        const NodeId node = at(field.solids, n.solid).origin;
        gap = {n.distance, mover < 0 ? n.gradient : pose.to_world(n.gradient), node, mover};
    };
    take(program.fixed, nearest(program.fixed, p, layers, reach), -1, {});
    for (std::size_t m = 0; m < program.movers.size(); ++m) {
        const Pose pose = pose_of(program.movers[m], q[m]);
        const Field& field = program.movers[m].field;
        take(field, nearest(field, pose.place_from_world(p), layers, reach), static_cast<int>(m), pose);
    }
    if (gap.distance > reach) gap.distance = reach;
    return gap;
}

Gap gap_at(const World& world, const Vec2& p, LayerMask layers) {
    std::vector<double> q;
    for (const MoverState& s : world.movers()) q.push_back(s.q);
    return gap_at(world.program(), q, p, layers);
}

}  // namespace pinfield
