// The running table: plays a document's scene, takes its edits live. No window, no ImGui.
#pragma once
#include <map>
#include <optional>
#include <string>

#include "editor/document.h"
#include "engine/physics/world.h"

namespace pinfield::editor {

/// Speeds of slow motion: every n-th frame's worth of ticks; 1 is real time.
inline constexpr int slowest = 64;

class Session {
public:
    explicit Session(const Document& document);

    bool playing() const { return playing_; }
    void play(bool on) { playing_ = on; }
    /// One tick, then pause.
    void single_step();
    /// Back to the start: balls at their spawns, counters at zero.
    void reset();
    int slow_motion() const { return slow_motion_; }  ///< 1, 2, 4 ... slowest
    void set_slow_motion(int divisor);

    /// Takes what changed in the document into the running table: a patch where one will do, else a new program; when the scene
    /// does not compile the last good program keeps running and problem() says why.
    void follow(Document& document);
    const Diagnostics& problems() const { return problems_; }

    /// Runs `ticks` ticks (divided by slow motion) when playing. Counts hits, puts drained balls back after a second.
    void advance(int ticks);
    void press(const std::string& input, bool down);

    const World& world() const { return *world_; }
    World& world() { return *world_; }
    const Program& program() const { return world_->program(); }
    /// Bumper hits since the last reset, in all and by scene node.
    int hits() const { return hits_; }
    int hits_of(NodeId node) const;
    int drained() const { return drained_; }

private:
    std::optional<World> world_;
    Diagnostics problems_;
    bool playing_ = true;
    int slow_motion_ = 1, owed_ticks_ = 0;
    int hits_ = 0, drained_ = 0;
    std::map<NodeId, int> hits_by_node_;
    std::map<BallId, std::int64_t> back_at_tick_;
};

}  // namespace pinfield::editor
