// Edits of the scene as values: each can be judged, applied, and taken back bit for bit.
#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/scene/scene.h"

namespace pinfield {

/// Sets one field of one node (or record) to a value; `is_explicit` says whether the author's text is to say it.
struct SetField {
    NodeId node;
    int field = 0;  ///< index into the node type's fields
    Value value;
    bool is_explicit = true;
};

/// Puts a node with everything in it (or a material) among the children of `parent` (none: the top level) as child `index`.
struct Insert {
    NodeId parent;
    int index = 0;
    Subtree nodes;       ///< with ids that are free: Scene::with_new_ids()
    std::string text{};  ///< the node as its author wrote it, an item of a list; empty: it is written as its neighbours are
};

/// Takes a node out with everything in it (or a material).
struct Remove {
    NodeId node;
};

/// Puts a node elsewhere among or under other nodes. Its own values stay: where it is in the world goes with its parents.
struct Move {
    NodeId node, parent;
    int index = 0;  ///< among the children of `parent`, the node itself not counted
};

/// Puts `count` neighbours, from child `first` of `parent` on, into a new node in their place.
struct Wrap {
    NodeId parent;
    int first = 0, count = 1;
    Node wrapper;  ///< with an id that is free; it has no children yet
};

/// Puts the children of a node into its place.
struct Unwrap {
    NodeId node;
};

/// Makes a node one of another type; it keeps its place, its children and its id. Its fields are those given.
struct Retype {
    NodeId node;
    const NodeType* type = nullptr;
    std::vector<FieldSlot> fields;
};

/// Gives a node, a material or an input another name, and everything that refers to it as well.
struct Rename {
    NodeId node;             ///< none: the input
    std::string from, to;    ///< an id may become empty where nothing refers to it
    bool is_explicit = true; ///< of an id: whether the text is to say it
};

/// Binds keys to a new input, which becomes input `index`; takes one out, that nothing refers to; binds it to other keys.
struct InsertInput {
    InputBinding input;
    int index = 0;
};
struct RemoveInput {
    int index = 0;
};
struct SetKeys {
    int index = 0;
    std::vector<std::string> keys;
};

/// Puts a test among the table's own, as test `index`; takes one out; gives it another name, or none.
struct InsertTest {
    TableTest test;
    int index = 0;
    std::string text{};  ///< the test as its author wrote it: {name: ...}; empty: it is written as all are
};
struct RemoveTest {
    int index = 0;
};
struct RenameTest {
    int index = 0;
    std::string name;
};

using Edit = std::variant<SetField, Insert, Remove, Move, Wrap, Unwrap, Retype, Rename, InsertInput, RemoveInput, SetKeys, InsertTest,
                          RemoveTest, RenameTest>;

/// Why an edit cannot be applied (range, kind, contract, a name that is taken or that there is none of, a place that is not allowed), or
/// nothing: what validate() would say of the scene with it.
std::optional<std::string> why_invalid(const Scene& scene, const SetField& edit);
std::optional<std::string> why_invalid(const Scene& scene, const Edit& edit);

/// Applies an edit that why_invalid() lets pass and returns the edit that undoes it, bit for bit.
SetField apply(Scene& scene, const SetField& edit);
Edit apply(Scene& scene, const Edit& edit);

/// A name, or each of several, that is `from`, as `to`.
Value renamed(Value value, const std::string& from, const std::string& to);

/// The edit that makes a node one of `type`: fields that both have keep their values where the new type takes them.
Retype retyped(const Scene& scene, NodeId node, const NodeType& type);

}  // namespace pinfield
