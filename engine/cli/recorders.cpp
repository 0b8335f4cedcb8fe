#include "engine/cli/recorders.h"

#include <fmt/format.h>

#include "engine/cli/json.h"
#include "engine/cli/table.h"
#include "engine/core/at.h"

namespace pinfield::cli {

Recorder::Recorder(const Scene& scene, const std::string& trace_path, const std::string& events_path) : scene_(scene) {
    if (!trace_path.empty()) trace_.emplace(trace_path);
    if (!events_path.empty()) events_.emplace(events_path);
    if (trace_) trace_->write("tick,ball,x,y,vx,vy,spin\n");
}

void Recorder::after_tick(const World& world) {
    trace(world);
    if (!events_) return;
    for (const Event& event : world.events()) log(event, world.program());
}

void Recorder::finish() {
    if (trace_) trace_->finish();
    if (events_) events_->finish();
}

void Recorder::trace(const World& world) {
    if (!trace_) return;
    for (const Ball& ball : world.balls())
        trace_->write(fmt::format("{},{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", world.tick(), ball.id.value, ball.position.x(),
                                  ball.position.y(), ball.velocity.x(), ball.velocity.y(), ball.spin));
}

void Recorder::log(const Event& event, const Program& program) {
    JsonObject line;
    const auto add_name = [&](std::string_view key, const std::string& name) {
        name.empty() ? line.add_raw(key, "null") : line.add(key, name);
    };
    line.add("tick", event.tick).add("time", event.time);
    if (event.ball)
        line.add("ball", event.ball.value);
    else
        line.add_raw("ball", "null");
    line.add("kind", name(event.kind));
    add_name("node", event.node ? name_of(scene_, event.node) : "");
    add_name("part", event.part >= 0 ? at(program.parts, event.part).name : "");
    add_name("material", event.material >= 0 ? at(program.materials, event.material).name : "");
    line.add("x", event.position.x()).add("y", event.position.y());
    line.add("nx", event.normal.x()).add("ny", event.normal.y()).add("speed", event.speed);
    if (event.other) line.add("other", event.other.value);
    if (event.kind == EventKind::leave) line.add("duration", event.duration);
    events_->write(line.text() + "\n");
}

}  // namespace pinfield::cli
