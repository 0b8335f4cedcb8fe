// What a hand does to a node, as Edits: dragging it, typing a value. Each previews while it goes on and
// commits once at its end. No window, no ImGui.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "editor/document.h"

namespace pinfield::editor {

/// 0: no grid, but still whole hundredths of a millimetre, so that files stay readable.
inline constexpr double default_grid = 0.001;

/// The grid of what has snapped: in line with the other to a nanometre, and in few digits where that is.
inline constexpr double exact_grid = 1e-9;

/// Metres, along the world's axes.
inline Vec2 square_grid(double step) { return {step, step}; }

/// Is a scene node locked, or what it lies in?
bool is_locked(const Scene& scene, const Node& node);

/// The edit that moves a node by a world vector: its `at`, in the parent's frame, on the grid (of that frame; the finer of both where that is
/// turned). A coordinate that does not move keeps its bits. `at_before`: where the drag began.
SetField moved(const Scene& scene, NodeId node, const Vec2& at_before, const Vec2& world_delta, const Vec2& grid);

/// A node in the hand. `own_from_hand`: its motion in the world where the hand moves by a vector (a copy under a mirror goes the other way).
struct Held {
    NodeId node;
    Eigen::Matrix2d own_from_hand = Eigen::Matrix2d::Identity();
    Vec2 at_before{0, 0};  ///< set by NodeDrag
};

/// Nodes being dragged: begin, update any number of times, end or cancel.
class NodeDrag {
public:
    bool active() const { return !held_.empty(); }
    /// Leaves out what cannot be moved: records, locked nodes. False, and nothing begins, when that is all.
    bool begin(const Document& document, std::span<const Held> nodes, const Vec2& world);
    bool begin(const Document& document, NodeId node, const Vec2& world);
    /// Why the node did not follow, or nothing. `axis_lock` keeps the smaller of both components still.
    std::optional<std::string> update(Document& document, const Vec2& world, const Vec2& grid, bool axis_lock = false);
    /// One undo step; why it was refused, or nothing.
    std::optional<std::string> end(Document& document);
    void cancel(Document& document);
    const std::vector<Held>& held() const { return held_; }

private:
    std::vector<Held> held_;
    Vec2 world_before_{0, 0};
};

/// The multiple of `step` nearest to x, as the shortest decimal text of it reads; without a step, whole hundredths of a millimetre.
double on_grid(double x, double step);
/// `target`, or else what is nearest to it on the way there from `from`, which is allowed, in whole steps.
double nearest_allowed(const std::function<bool(double)>& allowed, double from, double target, double step);

/// How many numbers a value is made of (2 of a vec2, two per point of a list), and each of them.
int component_count(const Value& value);
double component(const Value& value, int index);
Value with_component(Value value, int index, double x);

/// What one step of a scrub is, in the field's own unit: the field's, or one that suits the value.
double scrub_step(const FieldType& field, double value);

/// A value in the format's own spelling ("30mm", "[0.26, 800mm]", "crimson"), or why it is none.
Result<Value> value_of(const FieldType& field, std::string_view text);
/// A field as the author wrote it, else as the format would: what an inspector shows for typing over.
std::string text_of(const Document& document, NodeId node, int field);
/// Sets a field from text as one undo step; why not, or nothing.
std::optional<std::string> set_from_text(Document& document, NodeId node, int field, std::string_view text);

/// Moves nodes by a world vector as one undo step; why not, or nothing. Nodes that lie in others of them go with those.
std::optional<std::string> move_by(Document& document, std::span<const NodeId> nodes, const Vec2& world_delta, double grid);

/// "Move pop", "Move 3 nodes", "Change radius of pop": what the history calls an edit.
std::string move_label(const Scene& scene, std::span<const NodeId> nodes);
std::string change_label(const Scene& scene, NodeId node, int field);

}  // namespace pinfield::editor
