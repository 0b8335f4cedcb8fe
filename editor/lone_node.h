// A node by itself, at the origin of an empty table: where its outline runs, and what its numbers do to it. Formulas are asked, never
// types. No window, no ImGui.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "engine/program/program.h"
#include "engine/scene/scene.h"

namespace pinfield::editor {

/// What a node is solid at, in its own frame; of a mover, where it stands at rest and at the other end of its way.
class LoneShape {
public:
    /// Signed distance as the formula says it, or a bound of it; its sign is right.
    double distance(const Vec2& p) const;
    /// Along which the distance grows, unit; zero where it does not change.
    Vec2 normal(const Vec2& p) const;
    /// Where pieces of its outline meet, as far as it is known as pieces: corners among them.
    std::vector<Vec2> joints() const;
    /// Of the solid; may be infinite.
    Box2 bounds() const;

private:
    friend class LoneNode;
    struct Stand {
        const Field* field = nullptr;
        int solid = 0;
        Similarity field_from_node;
    };

    ProgramPtr program_;
    std::vector<Stand> stands_;
};

class LoneNode {
public:
    /// With everything in it. The node must be one of the scene's nodes, and no record.
    LoneNode(const Scene& scene, NodeId node);

    const Node& node() const { return *scene_.find(root_); }
    /// Nothing where the node does not compile or is solid nowhere.
    std::optional<LoneShape> shape() const { return compiled(scene_); }
    /// With one field at another value; nothing also where that value is not allowed.
    std::optional<LoneShape> shape_with(int field, const Value& value) const;
    /// Why a field cannot take a value, or nothing.
    std::optional<std::string> why_not(int field, const Value& value) const;

private:
    std::optional<LoneShape> compiled(const Scene& scene) const;

    Scene scene_;
    NodeId root_;
};

}  // namespace pinfield::editor
