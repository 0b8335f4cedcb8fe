#include "engine/cli/recorders.h"

#include <fmt/format.h>

#include "engine/cli/json.h"
#include "engine/cli/table.h"

namespace pinfield::cli {

Recorder::Recorder(const Scene& scene, const std::string& trace_path, const std::string& events_path) : scene_(scene) {
    if (!trace_path.empty()) trace_.emplace(trace_path);
    if (!events_path.empty()) events_.emplace(events_path);
    if (trace_) trace_->write("tick,ball,x,y,vx,vy,spin\n");
}

void Recorder::after_tick(const World& world) {
    trace(world);
    if (!events_) return;
    for (const Event& event : world.events()) log(event);
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

void Recorder::log(const Event& event) {
    JsonObject line;
    line.add("tick", event.tick).add("time", event.time);
    if (event.ball)
        line.add("ball", event.ball.value);
    else
        line.add_raw("ball", "null");
    line.add("kind", name(event.kind));
    if (event.node)
        line.add("node", name_of(scene_, event.node));
    else
        line.add_raw("node", "null");
    line.add("x", event.position.x()).add("y", event.position.y());
    line.add("nx", event.normal.x()).add("ny", event.normal.y()).add("speed", event.speed);
    events_->write(line.text() + "\n");
}

}  // namespace pinfield::cli
