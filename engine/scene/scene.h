// The typed tree that tools work on: nodes with stable ids, their values, and where each value stands in the author's text.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/id.h"
#include "engine/core/source_text.h"
#include "engine/reflect/catalog.h"
#include "engine/reflect/value.h"
#include "engine/scene/authored.h"

namespace pinfield {

/// A number or word of a field that its author wrote as an expression, or as a name after $: which of the value's (a point has two), and how.
struct WrittenPart {
    int index = 0;
    std::string text;
    bool operator==(const WrittenPart&) const = default;
};
using WrittenParts = std::vector<WrittenPart>;

/// A field's value and, when the author wrote it, where that value stands.
struct FieldSlot {
    Value value;
    bool is_explicit = false;
    Place where{};
    std::shared_ptr<const WrittenParts> written{};  ///< null, as almost always: all of it stands in the text as it is

    /// Are the same parts written as the same expressions?
    bool is_written_as(const FieldSlot& other) const {
        return written == other.written || (written && other.written && *written == *other.written);
    }
};

/// One node of the scene, or one record (table, physics, a material): same shape, so that every tool handles both alike.
struct Node {
    NodeId id;
    const NodeType* type = nullptr;
    std::string name;               ///< the author's id, or a material's name; may be empty
    std::vector<FieldSlot> fields;  ///< parallel to type->fields
    std::vector<NodeId> children;
    NodeId parent;                  ///< none at the top level
    Place where{};                  ///< the whole node: from its key to the end of its last value
    Place key{};                    ///< its type's word (or a material's name) in the text
    std::shared_ptr<const Origin> origin{};          ///< null: lines of its own make it
    std::shared_ptr<const Generator> generator{};    ///< null: the children are the author's own

    bool is_record() const { return type->meta.kind == NodeKind::record; }
    const Value& value(std::string_view key_of_field) const;
    /// Does the field mean anything beside the values of the others (FieldMeta::only_with) and the children (PartTraits::only_customary)?
    bool has_use_for(std::size_t field) const;
    template <class T>
    const T& get(std::string_view key_of_field) const { return std::get<T>(value(key_of_field)); }
};

/// A node with everything in it, outside any scene: in preorder, so that its root comes first. What refers to a node within is its id.
using Subtree = std::vector<Node>;

/// A named input and the keys of a keyboard that press it (GLFW's names without prefix: Z, Slash, LeftShift, Space).
struct InputBinding {
    std::string name;
    std::vector<std::string> keys;
    Place where{};
};

/// An entry of `tests:`.
struct TableTest {
    struct Launch {
        Vec2 at{0, 0}, velocity{0, 0};
        Place where{};
    };
    /// A hand at an input: it presses at the first time, lets go at the second, and so on; seconds, rising.
    struct Hand {
        std::string input;
        std::vector<double> times;
        Place where{};
    };
    struct Expectation {
        std::string quantity;    ///< `escaped`, `drained` or `<id>.hits`
        std::string comparison;  ///< == != < <= > >=
        double value = 0;
        std::string text;        ///< as the author wrote it
        Place where{};
    };
    std::string name;
    std::vector<Launch> launches;
    std::vector<Hand> inputs;
    double run = 1;  ///< seconds
    std::vector<Expectation> expectations;
    Place where{};
};

/// The name that every table's ground layer goes by.
inline constexpr std::string_view ground_layer_name = "ground";

class Scene {
public:
    /// An empty table with default records. The catalog must outlive the scene.
    explicit Scene(std::shared_ptr<const Catalog> catalog);

    const Catalog& catalog() const { return *catalog_; }
    const std::shared_ptr<const Catalog>& shared_catalog() const { return catalog_; }

    /// Adds a node of this type with default values under `parent` (none: the top level) and returns it.
    Node& add(const NodeType& type, NodeId parent = {});
    Node& add_material(const std::string& name);

    /// A scene node or a material, with everything in it: copied, or taken out of the scene.
    Subtree copy(NodeId id) const;
    Subtree take(NodeId id);
    /// Puts a subtree among the children of `parent` (none: the top level, or the materials) so that it becomes child `index`. Its ids
    /// must be free.
    void put(Subtree nodes, NodeId parent, int index);
    /// The subtree with ids that no node of this scene has had.
    Subtree with_new_ids(Subtree nodes) const;
    /// The nodes that one stands among, itself included: its parent's children, the top level, or the materials.
    const std::vector<NodeId>& siblings(NodeId id) const;
    /// Where a node stands among its siblings.
    int index_of(NodeId id) const;
    /// The children of a node, or, for none, the top level.
    const std::vector<NodeId>& children_of(NodeId parent) const { return parent ? find(parent)->children : roots_; }
    /// Is `node` the node `ancestor`, or in it? One that is not there is in nothing: a program may still hold it.
    bool is_within(NodeId node, NodeId ancestor) const;

    const Node* find(NodeId id) const;
    Node* find(NodeId id);
    /// By the author's id, else by path: `type[index]/type[index]`, index among siblings of that type from 0.
    const Node* find(std::string_view id_or_path) const;
    /// The author's id, or the path.
    std::string path(NodeId id) const;
    /// path() of all ids in use, in one walk: a path costs its siblings, and a table may have thousands side by side.
    std::map<NodeId, std::string> paths() const;

    const Node& table() const { return *find(table_); }
    const Node& physics() const { return *find(physics_); }
    Node& table() { return *find(table_); }
    Node& physics() { return *find(physics_); }
    const std::vector<NodeId>& roots() const { return roots_; }
    const std::vector<NodeId>& materials() const { return materials_; }
    /// All ids in use: records, materials, then scene nodes in file order (preorder).
    std::vector<NodeId> all() const;
    /// Name of a node's material: its own, else the nearest ancestor's that names one, else "default". It may not be defined.
    std::string material_name(NodeId id) const;

    /// Names of the layers a node is on: its own, else the nearest ancestor's that names some, else the ground.
    std::vector<std::string> layers(NodeId id) const;

    Sources sources;  ///< the texts that places in the scene refer to; none when it was not read from a text
    std::vector<std::string> includes;  ///< files whose contents are here, as the table names them; empty: all is the table's own
    std::vector<Param> params;
    std::string templates;  ///< the entries of the table's own section, as lines; empty: there are none
    std::vector<InputBinding> inputs;
    std::vector<TableTest> tests;

    /// Gives nodes of this freshly read scene the ids they had in `before`: matched by author's id, else by path.
    void keep_ids_of(const Scene& before);
    /// The same where both scenes have the same nodes in the same order.
    void take_ids_of(const Scene& twin) { take_ids(twin.all(), twin); }
    /// Gives the nodes the ids that all() gave for this scene earlier. `later`: a scene whose ids are not given out again.
    void take_ids(const std::vector<NodeId>& ids, const Scene& later);
    /// Gives each node the id that `ids` has for it; those it has none for get ids that neither scene has had.
    void take_ids(const std::map<NodeId, NodeId>& ids, const Scene& later);

private:
    Node& insert(const NodeType& type, NodeId parent);
    std::vector<NodeId>& list_for(const NodeType& type, NodeId parent);
    void rename(const std::map<NodeId, NodeId>& new_ids);

    std::shared_ptr<const Catalog> catalog_;
    std::map<NodeId, Node> nodes_;
    std::vector<NodeId> roots_, materials_;
    NodeId table_, physics_;
    std::uint32_t next_id_ = 1;
};

/// Same type, name, values bit for bit and children of the same sort; places in the text and ids do not count.
bool same_node(const Scene& a, const Node& x, const Scene& b, const Node& y);
bool same_nodes(const Scene& a, const std::vector<NodeId>& x, const Scene& b, const std::vector<NodeId>& y);

bool same_input(const InputBinding& a, const InputBinding& b);
bool same_test(const TableTest& a, const TableTest& b);

/// local frame -> parent's frame, from the common fields at, turn, scale and flip.
Similarity parent_from_local(const Node& node);
/// Product of parent_from_local up to the root.
Similarity world_from_local(const Scene& scene, NodeId id);

}  // namespace pinfield
