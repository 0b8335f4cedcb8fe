// The hierarchy over the pieces is built anew rather than refitted: that costs microseconds (bench_program), and a
// refitted tree would visit entries in another order than a compiled one.
#include "engine/program/patch.h"

#include <algorithm>

#include "engine/program/cook.h"
#include "engine/program/field.h"

namespace pinfield {
namespace {

class Patcher {
public:
    Patcher(const Program& before, const Scene& scene)
        : kitchen_(scene, before.layers), program_(std::make_shared<Program>(before)) {}

    ProgramPtr record_changed(NodeId record) {
        const Scene& scene = kitchen_.scene;
        program_->materials = cook_materials(scene);
        program_->physics = cook_physics(scene);
        program_->name = scene.table().get<std::string>("name");
        program_->size = scene.table().get<Vec2>("size");
        if (record == scene.table().id) {
            const int domain = solid_of(record);
            if (domain >= 0 && !put(domain, cook_default_domain(kitchen_, program_->fixed.solids[at(domain)].layers)))
                return nullptr;
        }
        return finished();
    }

    ProgramPtr node_changed(NodeId node) {
        std::vector<Item> items;
        collect_items(kitchen_.scene, scene_node_of(kitchen_.scene, node), items);
        for (const Item& item : items)
            if (!(item.is_part ? part_changed(item) : put(solid_of(item.node), cook_static(item)))) return nullptr;
        return finished();
    }

    ProgramPtr unchanged() { return program_; }

private:
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    int solid_of(NodeId origin) const {
        const auto& solids = program_->fixed.solids;
        const auto found =
            std::find_if(solids.begin(), solids.end(), [&](const Solid& s) { return s.origin == origin; });
        return found == solids.end() ? -1 : static_cast<int>(found - solids.begin());
    }

    Field cook_static(const Item& item) {
        return cook_solid(kitchen_, item, world_from_local(kitchen_.scene, item.node));
    }

    /// False when the edit made a solid come or go: then indices change, and compile() must count them again.
    bool put(int solid, Field fragment) {
        if ((solid < 0) != fragment.solids.empty()) return false;
        if (solid < 0) return true;
        fragment.solids[0].part = program_->fixed.solids[at(solid)].part;
        replace_solid(program_->fixed, solid, fragment);
        index_fixed_ = true;
        return true;
    }

    bool part_changed(const Item& item) {
        const auto found = std::find_if(program_->parts.begin(), program_->parts.end(),
                                        [&](const Part& p) { return p.origin == item.node; });
        if (found == program_->parts.end()) return false;
        Part& part = *found;
        Part fresh = cook_part(kitchen_, item);
        fresh.solid = part.solid;
        fresh.mover = part.mover;
        fresh.sensor = part.sensor;
        part = std::move(fresh);
        if (part.mover >= 0) {
            program_->movers[at(part.mover)] =
                cook_mover(kitchen_, item, static_cast<int>(found - program_->parts.begin()));
            return true;
        }
        Field fragment = cook_solid(kitchen_, item, part.world_from_part);
        if (item.role != Role::sensor) return put(part.solid, std::move(fragment));
        if ((part.sensor < 0) != fragment.solids.empty()) return false;
        if (part.sensor < 0) return true;
        index(fragment);
        program_->sensors[at(part.sensor)].field = std::move(fragment);
        return true;
    }

    ProgramPtr finished() {
        if (has_errors(kitchen_.problems)) return nullptr;
        if (index_fixed_) index(program_->fixed);
        return program_;
    }

    Kitchen kitchen_;
    std::shared_ptr<Program> program_;
    bool index_fixed_ = false;
};

}  // namespace

ProgramPtr patch(const Program& before, const Scene& scene, NodeId id, int field) {
    const Node* node = scene.find(id);
    if (!node) return nullptr;
    const FieldType& changed = node->type->fields[static_cast<std::size_t>(field)];
    if (node->type->meta.kind == NodeKind::record) return Patcher(before, scene).record_changed(id);
    if (changed.key == "id" || changed.key == "layer")
        return nullptr;  // names and layers are counted over the whole table
    if (changed.key == "note" || changed.key == "locked") return Patcher(before, scene).unchanged();
    return Patcher(before, scene).node_changed(id);
}

}  // namespace pinfield
