// The running table: plays a document's scene, takes its edits live. No window, no ImGui.
#pragma once
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editor/document.h"
#include "engine/game/game.h"

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
    /// What the balls were in that the last edit had put into something solid; they were moved out.
    const std::vector<NodeId>& left() const { return left_; }

    /// Runs `ticks` ticks (divided by slow motion) when playing.
    void advance(int ticks);
    /// An input of the table by its name; one the table does not have is ignored.
    void press(const std::string& input, bool down);
    void release_all();

    const Game& game() const { return *game_; }
    const World& world() const { return game_->world(); }
    const Program& program() const { return world().program(); }
    /// Where the i-th mover is now: its Field's frame -> world.
    Similarity world_from_mover(int mover) const;
    /// Bumper hits since the last reset.
    std::int64_t hits() const { return game_->bumper_hits(); }
    /// Hits of a node and of everything in it since then, bumper or not.
    std::int64_t hits_of(NodeId node) const { return game_->hits_of(node); }
    std::int64_t drained() const { return game_->drained(); }

private:
    void start(ProgramPtr program, NodeParents parents);
    void judge(const Scene& scene);  ///< the program that runs from now on
    void press_held();

    std::optional<Game> game_;
    Diagnostics problems_;
    std::vector<NodeId> left_;
    bool stale_ = false;  ///< the running program is not that of the scene: only a full compile can mend it
    bool playing_ = true;
    int slow_motion_ = 1, owed_ticks_ = 0;
    std::set<std::string> held_;
};

}  // namespace pinfield::editor
