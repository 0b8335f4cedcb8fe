#include "engine/program/compile.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/core/error_codes.h"
#include "engine/program/compile_item.h"
#include "engine/program/field.h"
#include "engine/scene/validate.h"

namespace pinfield {
namespace {

constexpr std::size_t most_layers = 32;

/// Returns the index of the solid, or -1 when the node has no shape.
int add_static_solid(CompileContext& context, const Item& item, int part, Program& program) {
    Field solid = compile_solid(context, item, world_from_local(context.scene, item.node));
    for (Solid& s : solid.solids) s.part = part;
    append(program.fixed, solid);
    return solid.solids.empty() ? -1 : static_cast<int>(program.fixed.solids.size()) - 1;
}

void add_part(CompileContext& context, const Item& item, Program& program) {
    const int index_of_part = static_cast<int>(program.parts.size());
    program.parts.push_back(compile_part(context, item));
    Part& part = program.parts.back();
    switch (item.role) {
        case Role::solid:
        case Role::domain: part.solid = add_static_solid(context, item, index_of_part, program); break;
        case Role::mover:
            part.mover = static_cast<int>(program.movers.size());
            program.movers.push_back(compile_mover(context, item, index_of_part));
            break;
        case Role::sensor: {
            Field field = compile_solid(context, item, part.world_from_part);
            if (field.solids.empty()) break;
            part.sensor = static_cast<int>(program.sensors.size());
            index(field);
            program.sensors.push_back({std::move(field), index_of_part});
            break;
        }
        case Role::group: break;
    }
}

/// Layers without a domain of their own get the table's box.
void add_missing_domain(CompileContext& context, const std::vector<Item>& items, Program& program) {
    LayerMask bounded = 0;
    for (const Item& item : items)
        if (item.role == Role::domain) bounded |= layers_of(context, item.node);
    const LayerMask all = static_cast<LayerMask>((std::uint64_t{1} << context.layers.size()) - 1);
    if (bounded != all) append(program.fixed, compile_default_domain(context, all & ~bounded));
}

/// Where the first node stands that names this layer.
Place place_of_layer(const Scene& scene, const std::vector<Item>& items, const std::string& layer) {
    for (const Item& item : items)
        for (const Node* node = scene.find(item.node); node; node = node->parent ? scene.find(node->parent) : nullptr) {
            const auto layers = node->get<std::vector<std::string>>("layer");
            if (std::find(layers.begin(), layers.end(), layer) != layers.end()) return node->where;
        }
    return scene.table().where;
}

}  // namespace

tl::expected<ProgramPtr, Diagnostics> compile(const Scene& scene) {
    if (Diagnostics findings = validate(scene); has_errors(findings)) return tl::unexpected(std::move(findings));
    std::vector<Item> items;
    for (const NodeId root : scene.roots()) collect_items(scene, root, items);
    CompileContext context(scene, layer_names(scene, items, most_layers + 1));
    if (context.layers.size() > most_layers) {
        context.problems.push_back(diagnose(Code::out_of_range, place_of_layer(scene, items, context.layers.back()),
                                            fmt::format("{} is one layer more than the {} that are possible", context.layers.back(), most_layers),
                                            fmt::format("{} is one of them, named or not", ground_layer_name)));
        return tl::unexpected(context.problems);
    }
    context.paths = scene.paths();
    auto program = std::make_shared<Program>();
    program->catalog = scene.shared_catalog();
    program->layers = context.layers;
    program->materials = compile_materials(scene);
    program->physics = compile_physics(scene);
    program->name = scene.table().get<std::string>("name");
    program->size = scene.table().get<Vec2>("size");
    for (const InputBinding& input : scene.inputs) program->inputs.push_back(input.name);
    for (const Item& item : items) {
        if (item.is_part)
            add_part(context, item, *program);
        else
            add_static_solid(context, item, -1, *program);
    }
    add_missing_domain(context, items, *program);
    if (has_errors(context.problems)) return tl::unexpected(context.problems);
    index(program->fixed);
    return ProgramPtr(std::move(program));
}

}  // namespace pinfield
