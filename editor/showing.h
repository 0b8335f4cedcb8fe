// A node where it is seen: one of the copies that mirrors and repetitions show of it, or what a warp makes of it. No window, no ImGui.
#pragma once
#include <optional>
#include <vector>

#include "editor/app_state.h"

namespace pinfield::editor {

/// Which of them. The default is the node itself, or what is nearest to it.
struct Copy {
    std::vector<int> images{};   ///< of each mirror and repetition on the way down to the node
    std::optional<Vec2> near{};  ///< a place of the world by which it was found: folds and endless repetitions show a place many times
};

/// How places of one copy and of the node's frame belong together, as the table runs now.
class Showing {
public:
    Showing(const AppState& state, NodeId node, const Copy& copy);

    Vec2 local_from_world(const Vec2& world) const;
    /// Where a place of the node is seen; nothing where no warp brings it to light near by.
    std::optional<Vec2> world_from_local(const Vec2& local) const;
    /// Whether it is seen as it is, but for moving, turning, scaling and mirroring.
    bool is_similar() const;

private:
    /// Inwards, in the field's frame.
    struct Step {
        Similarity inner_from_outer{};
        const Op* warp = nullptr;
        Vec2 near{0, 0};  ///< the place by which the copy was found, before this step
    };
    Vec2 warped(const Op& op, const Vec2& p, Vec2& along_x, Vec2& along_y) const;
    bool find_way(const Scene& scene, int op, NodeId node, const std::vector<int>& images, std::size_t used);
    std::optional<Vec2> unwarped(const Step& step, const Vec2& inner) const;

    ProgramPtr program_;
    const Field* field_ = nullptr;
    Similarity field_from_world_, local_from_inner_;
    std::vector<Step> steps_;
};

/// The copy of a node at a place of the world, within `slack` metres; nothing where none is.
std::optional<Copy> copy_at(const AppState& state, NodeId node, const Vec2& world, double slack);

}  // namespace pinfield::editor
