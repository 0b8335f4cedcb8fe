// What an author does to the structure of a table, as edits that make one undo step: add, delete, duplicate, cut and paste, wrap and
// unwrap, reorder, rename. No window, no ImGui.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "editor/document.h"

namespace pinfield::editor {

/// Edits that go on from one another: each is judged by the scene that those before it leave.
class EditPlan {
public:
    explicit EditPlan(Scene scene) : scene_(std::move(scene)) {}

    const Scene& scene() const { return scene_; }
    std::span<const Edit> edits() const { return edits_; }
    /// Why an edit could not be added, or nothing; after the first refusal none is.
    const std::optional<std::string>& refusal() const { return refusal_; }
    bool add(Edit edit);
    void refuse(std::string why) { if (!refusal_) refusal_ = std::move(why); }

private:
    Scene scene_;
    std::vector<Edit> edits_;
    std::optional<std::string> refusal_;
};

/// What came of it: the nodes to select and what was done ("Delete pop"), or why nothing was.
struct Outcome {
    std::vector<NodeId> nodes;
    std::string done;
    std::optional<std::string> refusal;
};

/// Of the nodes given those that are scene nodes and in no other of them, in the order of the file.
std::vector<NodeId> outermost(const Scene& scene, std::span<const NodeId> nodes);

/// A place among the children of a node, or of the top level.
struct Spot {
    NodeId parent;
    int index = 0;
};
/// Behind the last of these nodes, or at the end of the top level.
Spot spot_after(const Scene& scene, std::span<const NodeId> nodes);

Outcome remove_nodes(Document& document, std::span<const NodeId> nodes);
/// Copies beside the originals, moved by a world vector; ids get a number behind them.
Outcome duplicate_nodes(Document& document, std::span<const NodeId> nodes, const Vec2& world_delta);

/// The nodes' YAML, a list with its comments.
Result<std::string> copied_text(const Document& document, std::span<const NodeId> nodes);
/// The nodes of a YAML text. `centre`: where in the world the middle of their places goes; none: where the text says. An id that is taken
/// gets a number behind it.
Outcome paste_text(Document& document, const std::string& text, const Spot& spot, const std::optional<Vec2>& centre);
/// A node with default values and the fewest children that it takes, outside any scene.
Subtree new_nodes(const std::shared_ptr<const Catalog>& catalog, const NodeType& type);
/// Such a node at a place of the world.
Outcome insert_new(Document& document, const NodeType& type, const Spot& spot, const Vec2& world);

/// A material with default values under a name that is free.
Outcome new_material(Document& document);

/// Nodes with all in them into a new node of `type`, where the first of them is. Their places in the world stay. What shows
/// copies of them (mirror, repeat) stands in the middle of the table, so that the copies are on it.
Outcome wrap_nodes(Document& document, std::span<const NodeId> nodes, const NodeType& type);
/// The children of nodes into their place; what the node gave them (place, material, layer) becomes their own.
Outcome unwrap_nodes(Document& document, std::span<const NodeId> nodes);

/// Nodes to another place among or under others. `keep_world`: their places in the world stay, not their values.
Outcome move_nodes(Document& document, std::span<const NodeId> nodes, const Spot& spot, bool keep_world);

Outcome rename_node(Document& document, NodeId node, const std::string& name);
Outcome change_type(Document& document, NodeId node, const NodeType& type);

/// The types of a kind, by name; and those that a node can become with what it holds.
std::vector<const NodeType*> types_of(const Catalog& catalog, NodeKind kind);
std::vector<const NodeType*> types_for(const Scene& scene, const Catalog& catalog, NodeId node);

}  // namespace pinfield::editor
