// Turning and scaling what is selected, about a point. No window, no ImGui.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "editor/document.h"

namespace pinfield::editor {

enum class TransformKind : unsigned char { turn, scale };

/// What a selection turns and grows about: the place of a single node, else the middle of the places of all.
Vec2 pivot_of(const Scene& scene, std::span<const NodeId> nodes);

/// Nodes being turned or scaled: begin, update any number of times, end or cancel, as NodeDrag.
class TransformDrag {
public:
    bool active() const { return !held_.empty(); }
    TransformKind kind() const { return kind_; }
    const Vec2& pivot() const { return pivot_; }
    /// How far it has come: degrees counter-clockwise, or a factor.
    double amount() const { return amount_; }
    /// Leaves out records and locked nodes. False, and nothing begins, when that is all, or when the hand is on the pivot.
    bool begin(const Document& document, std::span<const NodeId> nodes, TransformKind kind, const Vec2& pivot, const Vec2& world);
    /// `step`: degrees, or of the factor; 0: as the hand goes. Why the nodes did not follow, or nothing.
    std::optional<std::string> update(Document& document, const Vec2& world, double step);
    std::optional<std::string> end(Document& document);
    void cancel(Document& document);

private:
    struct Held {
        NodeId node;
        Vec2 at;
        double turn, scale;
        Similarity parent_from_world;
    };

    std::vector<SetField> edits_for(const Scene& scene, const Held& held) const;

    std::vector<Held> held_;
    TransformKind kind_ = TransformKind::turn;
    Vec2 pivot_{0, 0}, hand_before_{1, 0};
    double amount_ = 0, reached_ = 0;
};

}  // namespace pinfield::editor
