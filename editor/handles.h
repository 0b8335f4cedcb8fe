// What a hand can take hold of on a node itself: the places and velocities that its description names, and its outline wherever one of its
// numbers moves it. Found from the description and the node's own distance, never from its type. No window, no ImGui.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "editor/document.h"
#include "editor/lone_node.h"

namespace pinfield::editor {

/// place: a point, or one of a list of points. gap: between two points of a list, where a new one does not change the shape. velocity: an
/// arrow as long as the way of a tenth of a second. outline: a number that moves the outline.
enum class HandleKind : unsigned char { place, gap, velocity, outline };

struct Handle {
    HandleKind kind = HandleKind::place;
    int field = 0;
    int component = 0;  ///< of the field's numbers: the only one of an outline's, else the first of two
    Vec2 at{0, 0};      ///< in the node's frame
    Vec2 normal{0, 0};  ///< of an outline: out of the solid, unit
    double speed = 0;   ///< of an outline: how far it moves along the normal for 1 of the field's unit
};

inline constexpr double seconds_of_velocity = 0.1;  ///< an arrow of 1 m/s is 0.1 m long

std::vector<Handle> handles_of(const Scene& scene, NodeId node);

/// A handle being dragged: begin, update any number of times, end or cancel, as NodeDrag.
class HandleDrag {
public:
    bool active() const { return static_cast<bool>(node_); }
    NodeId node() const { return node_; }
    const Handle& handle() const { return handle_; }
    /// From the handle to where the hand took hold of it, in the node's frame.
    const Vec2& hold() const { return hold_; }
    /// `p`: where the hand took hold, in the node's frame. A gap becomes the point that is put there.
    bool begin(const Document& document, NodeId node, const Handle& handle, const Vec2& p);
    /// The place follows the hand; the number becomes that at which the outline goes through the hand, as near as the field and the node's
    /// contract allow. `grid`: of places along the node's axes, metres. 0: none, and then numbers too take any value; exact_grid: the
    /// place, or the number, is just that which the hand is at.
    std::optional<std::string> update(Document& document, const Vec2& p, const Vec2& grid);
    std::optional<std::string> end(Document& document);
    void cancel(Document& document);
    /// What keeps the number from following the hand ("inner <= outer must hold"), or nothing.
    const std::optional<std::string>& stopped_by() const { return stopped_by_; }

private:
    Value moved_places(const Vec2& hand, const Vec2& grid) const;
    Value number_through(const Vec2& hand, double share);

    NodeId node_;
    Handle handle_;
    Vec2 hold_{0, 0};  ///< from the handle to the hand
    Value before_;
    std::optional<LoneNode> alone_;
    std::optional<std::string> stopped_by_;
};

/// The value without one of its points, or nothing where the node needs it.
std::optional<SetField> without_point(const Scene& scene, NodeId node, int field, int component);

}  // namespace pinfield::editor
