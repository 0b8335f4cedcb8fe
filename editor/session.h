// The running table: plays a document's scene, takes its edits live. No window, no ImGui.
#pragma once
#include <map>
#include <optional>
#include <set>
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
    /// does not compile the last good program keeps running and problems() says why. Else problems() are doubts about what runs.
    void follow(Document& document);
    const Diagnostics& problems() const { return problems_; }

    /// Runs `ticks` ticks (divided by slow motion) when playing. Counts hits, puts drained balls back after a second.
    void advance(int ticks);
    /// An input of the table by its name; one the table does not have is ignored.
    void press(const std::string& input, bool down);
    void release_all();

    const World& world() const { return *world_; }
    World& world() { return *world_; }
    const Program& program() const { return world_->program(); }
    /// Where the i-th mover is now: its Field's frame -> world.
    Similarity world_from_mover(int mover) const;
    /// Bumper hits since the last reset, in all and by scene node.
    int hits() const { return hits_; }
    int hits_of(NodeId node) const;
    int drained() const { return drained_; }

private:
    void start(ProgramPtr program);
    void adopt(ProgramPtr program, const Scene& scene);
    void step();
    void count_events();
    void put_balls_back();

    std::optional<World> world_;
    Diagnostics problems_;
    bool stale_ = false;  ///< the running program is not that of the scene: only a full compile can mend it
    bool playing_ = true;
    int slow_motion_ = 1, owed_ticks_ = 0;
    int hits_ = 0, drained_ = 0;
    std::map<NodeId, NodeId> bumper_of_;  ///< scene node whose surface it is -> the bumper it belongs to
    std::map<NodeId, int> hits_by_node_;
    std::map<BallId, NodeId> spawn_of_;
    std::map<BallId, std::int64_t> back_at_tick_;
    std::set<std::string> held_;
};

}  // namespace pinfield::editor
