// Scene nodes one at a time into what a Program is made of. compile.cpp compiles all of them, patch.cpp those that an edit
// touched: both through these functions, so that a patched program cannot differ from a compiled one.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "engine/core/diagnostic.h"
#include "engine/program/program.h"
#include "engine/scene/part_traits.h"
#include "engine/scene/scene.h"

namespace pinfield {

/// What compiling a node needs to know of the table around it.
struct CompileContext {
    CompileContext(const Scene& of, std::vector<std::string> named_layers);

    const Scene& scene;
    std::vector<std::string> layers;       ///< as Program::layers
    std::map<std::string, int> materials;  ///< by name, where in Program::materials
    std::map<NodeId, std::string> paths;   ///< of all nodes, when all are to be compiled: one path alone costs all its siblings
    Diagnostics problems;
};

/// A scene node that stands for itself in the Program: not a group, but what a group holds.
struct Item {
    NodeId node;
    Role role = Role::solid;
    bool is_part = false;
};

/// The items at and below a scene node, in file order.
void collect_items(const Scene& scene, NodeId node, std::vector<Item>& out);
/// The group or item that a node belongs to: itself, or the nearest ancestor that is a scene node.
NodeId scene_node_of(const Scene& scene, NodeId node);

/// The ground and the layers that items name, in their order, of which no more than `most` are looked for.
std::vector<std::string> layer_names(const Scene& scene, const std::vector<Item>& items, std::size_t most);
/// Own layers, else those of the nearest group that names some, else the ground.
LayerMask layers_of(const CompileContext& context, NodeId node);

/// A solid, in the frame given, as a Field with that one solid (not indexed); no solid when the node has no shape.
Field compile_solid(CompileContext& context, const Item& item, const Similarity& field_from_node);
/// The domain of a table that says none: a box of the table's size.
Field compile_default_domain(CompileContext& context, LayerMask layers);
Mover compile_mover(CompileContext& context, const Item& item, int part);
/// Without the indices of its solid, mover or sensor.
Part compile_part(CompileContext& context, const Item& item);

/// materials[0] is the one named `default`, or the defaults; the others follow in file order.
std::vector<MaterialRecord> compile_materials(const Scene& scene);
PhysicsRecord compile_physics(const Scene& scene);

}  // namespace pinfield
