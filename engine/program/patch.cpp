// The hierarchy over the pieces is built anew rather than refitted: that costs microseconds (bench_program), and a
// refitted tree would visit entries in another order than a compiled one.
#include "engine/program/patch.h"

#include <algorithm>
#include <set>

#include "engine/core/at.h"
#include "engine/program/compile_item.h"
#include "engine/program/field.h"

namespace pinfield {
namespace {

class Patcher {
public:
    Patcher(const Program& before, const Scene& scene)
        : context_(scene, before.layers), program_(std::make_shared<Program>(before)) {}

    bool record_changed(NodeId record) {
        const Scene& scene = context_.scene;
        program_->materials = compile_materials(scene);
        program_->physics = compile_physics(scene);
        program_->name = scene.table().get<std::string>("name");
        program_->size = scene.table().get<Vec2>("size");
        if (record == scene.table().id) {
            const int domain = solid_of(record);
            if (domain >= 0 && !put(domain, compile_default_domain(context_, at(program_->fixed.solids, domain).layers)))
                return false;
        }
        return true;
    }

    /// A scene node, with all that belongs to it.
    bool node_changed(NodeId scene_node) {
        std::vector<Item> items;
        collect_items(context_.scene, scene_node, items);
        return std::all_of(items.begin(), items.end(), [&](const Item& item) {
            return item.is_part ? part_changed(item) : put(solid_of(item.node), compile_static(item));
        });
    }

    ProgramPtr finished() {
        if (has_errors(context_.problems)) return nullptr;
        if (index_fixed_) index(program_->fixed);
        return program_;
    }

private:
    
    int solid_of(NodeId origin) const {
        const auto& solids = program_->fixed.solids;
        const auto found =
            std::find_if(solids.begin(), solids.end(), [&](const Solid& s) { return s.origin == origin; });
        return found == solids.end() ? -1 : static_cast<int>(found - solids.begin());
    }

    Field compile_static(const Item& item) {
        return compile_solid(context_, item, world_from_local(context_.scene, item.node));
    }

    /// False when the edit made a solid come or go: then indices change, and compile() must count them again.
    bool put(int solid, Field fragment) {
        if ((solid < 0) != fragment.solids.empty()) return false;
        if (solid < 0) return true;
        fragment.solids[0].part = at(program_->fixed.solids, solid).part;
        replace_solid(program_->fixed, solid, fragment);
        index_fixed_ = true;
        return true;
    }

    bool part_changed(const Item& item) {
        const auto found = std::find_if(program_->parts.begin(), program_->parts.end(),
                                        [&](const Part& p) { return p.origin == item.node; });
        if (found == program_->parts.end()) return false;
        Part& part = *found;
        Part fresh = compile_part(context_, item);
        fresh.solid = part.solid;
        fresh.mover = part.mover;
        fresh.sensor = part.sensor;
        part = std::move(fresh);
        if (part.mover >= 0) {
            at(program_->movers, part.mover) =
                compile_mover(context_, item, static_cast<int>(found - program_->parts.begin()));
            return true;
        }
        Field fragment = compile_solid(context_, item, part.world_from_part);
        if (item.role != Role::sensor) return put(part.solid, std::move(fragment));
        if ((part.sensor < 0) != fragment.solids.empty()) return false;
        if (part.sensor < 0) return true;
        index(fragment);
        at(program_->sensors, part.sensor).field = std::move(fragment);
        return true;
    }

    CompileContext context_;
    std::shared_ptr<Program> program_;
    bool index_fixed_ = false;
};

}  // namespace

ProgramPtr patch(const Program& before, const Scene& scene, std::span<const FieldChange> changes) {
    std::set<NodeId> records, scene_nodes;
    for (const FieldChange& change : changes) {
        const Node* node = scene.find(change.node);
        if (!node) return nullptr;
        const Affects affects = at(node->type->fields, change.field).meta.affects;
        if (affects == Affects::structure) return nullptr;
        if (affects == Affects::nothing) continue;
        if (node->type->meta.kind == NodeKind::record) records.insert(change.node);
        else scene_nodes.insert(scene_node_of(scene, change.node));
    }
    Patcher patcher(before, scene);
    for (const NodeId record : records)
        if (!patcher.record_changed(record)) return nullptr;
    for (const NodeId node : scene_nodes)
        if (!patcher.node_changed(node)) return nullptr;
    return patcher.finished();
}

}  // namespace pinfield
