// What `simulate` writes while it runs: the balls' path as CSV, and what happened as JSON lines.
#pragma once
#include <optional>
#include <string>

#include "engine/cli/output.h"
#include "engine/game/simulation.h"
#include "engine/scene/scene.h"

namespace pinfield::cli {

class Recorder : public SimulationObserver {
public:
    /// Empty paths: nothing is written. Stops the command when a file cannot be made.
    Recorder(const Scene& scene, const std::string& trace_path, const std::string& events_path);
    /// The balls before the first tick.
    void start(const World& world) { trace(world); }
    void after_tick(const World& world) override;
    /// Closes the files; only now is all of it written.
    void finish();

private:
    void trace(const World& world);
    void log(const Event& event, const Program& program);

    const Scene& scene_;
    std::optional<Output> trace_, events_;
};

}  // namespace pinfield::cli
