#include "editor/structure_tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "editor/edit_tools.h"
#include "engine/core/at.h"
#include "engine/core/trig.h"
#include "engine/io/fragment.h"
#include "engine/io/structure_patch.h"
#include "engine/scene/elsewhere.h"
#include "engine/scene/validate.h"
#include "engine/sdf/kernels.h"

namespace pinfield::editor {
namespace {


std::string counted(std::size_t count, const std::string& one) { return count == 1 ? one : fmt::format("{} nodes", count); }
std::string label_of(const Scene& scene, std::string_view verb, std::span<const NodeId> nodes) {
    return fmt::format("{} {}", verb, counted(nodes.size(), nodes.empty() ? "nothing" : scene.path(nodes.front())));
}

/// Writes the plan as one step.
Outcome commit(Document& document, const EditPlan& plan, const std::string& label, std::vector<NodeId> nodes) {
    if (plan.refusal()) return {{}, {}, plan.refusal()};
    if (auto why = document.edit(plan.edits(), label)) return {{}, {}, std::move(why)};
    std::erase_if(nodes, [&](NodeId id) { return !document.scene().find(id); });
    return {std::move(nodes), label, {}};
}

/// A number that a file may hold: no digits that only rounding put there.
double tidy(double x) { return std::round(x * 1e9) / 1e9 + 0.0; }

bool set_if_new(EditPlan& plan, NodeId id, std::string_view key, const Value& value) {
    const Node& node = *plan.scene().find(id);
    const int field = *node.type->find_field(key);
    if (identical(at(node.fields, field).value, value)) return true;
    return plan.add(SetField{id, field, value, true});
}

/// Gives a node the place in its parent's frame that this similarity says.
void place(EditPlan& plan, NodeId id, const Similarity& parent_from_local) {
    const Similarity now = pinfield::parent_from_local(*plan.scene().find(id));
    if (length(parent_from_local.offset - now.offset) > 1e-12)
        set_if_new(plan, id, "at", Vec2(tidy(parent_from_local.offset.x()), tidy(parent_from_local.offset.y())));
    if (std::fabs(parent_from_local.scale - now.scale) > 1e-12) set_if_new(plan, id, "scale", tidy(parent_from_local.scale));
    const bool turned = std::fabs(parent_from_local.cosine - now.cosine) + std::fabs(parent_from_local.sine - now.sine) > 1e-12;
    if (!turned && parent_from_local.mirrored == now.mirrored) return;
    set_if_new(plan, id, "flip", std::string(parent_from_local.mirrored ? "y" : "none"));
    set_if_new(plan, id, "turn", tidy(degrees(arc_tangent(parent_from_local.sine, parent_from_local.cosine))));
}

Similarity world_of(const Scene& scene, NodeId node) { return node ? world_from_local(scene, node) : Similarity{}; }

std::set<std::string, std::less<>> names_of(const Scene& scene) {
    std::set<std::string, std::less<>> out;
    for (const NodeId id : scene.all())
        if (const Node& node = *scene.find(id); !node.is_record() && !node.name.empty()) out.insert(node.name);
    for (const InputBinding& input : scene.inputs) out.insert(input.name);
    for (const Param& param : scene.params) out.insert(param.name);
    return out;
}

/// pop -> pop_2, pop_2 -> pop_3: the first that is free.
std::string free_name(const std::set<std::string, std::less<>>& taken, const std::string& name) {
    if (!taken.count(name)) return name;
    std::size_t digits = name.size();
    while (digits > 0 && name[digits - 1] >= '0' && name[digits - 1] <= '9') --digits;
    const bool numbered = digits > 0 && digits < name.size() && name[digits - 1] == '_' && name.size() - digits < 6;
    const std::string stem = numbered ? name.substr(0, digits) : name + "_";
    for (int number = numbered ? std::stoi(name.substr(digits)) + 1 : 2;; ++number)
        if (std::string next = fmt::format("{}{}", stem, number); !taken.count(next)) return next;
}

std::vector<Vec2> regular_polygon(int corners) {
    std::vector<Vec2> out;
    for (int i = 0; i < corners; ++i) {
        const double turn = 360.0 * i / corners - 90;
        out.emplace_back(std::round(30 * cosine_degrees(turn)) / 1000, std::round(30 * sine_degrees(turn)) / 1000);
    }
    return out;
}

/// Puts a node into the scene; an id that is taken gets a number behind it.
void insert_fragment(const Reading& table, EditPlan& plan, const Spot& spot, const Fragment& fragment, std::vector<NodeId>& inserted) {
    std::set<std::string, std::less<>> taken = names_of(plan.scene());
    const auto new_id = [&](const std::string& name) { return name.empty() ? name : *taken.insert(free_name(taken, name)).first; };
    const Result<Fragment> fresh = with_ids(fragment, new_id, table);
    if (!fresh) return plan.refuse(fresh.error().message);
    Subtree nodes = plan.scene().with_new_ids(fresh->nodes);
    inserted.push_back(nodes.front().id);
    plan.add(Insert{spot.parent, spot.index, std::move(nodes), fresh->text});
}

/// A copy whose place is an expression stays where that says, as does a row of copies.
void move_if_it_may(EditPlan& plan, NodeId id, const Vec2& world_delta) {
    const SetField move = moved(plan.scene(), id, plan.scene().find(id)->get<Vec2>("at"), world_delta, square_grid(default_grid));
    if (!why_invalid(plan.scene(), move)) plan.add(move);
}

}  // namespace

bool EditPlan::add(Edit edit) {
    if (refusal_) return false;
    refusal_ = why_invalid(scene_, edit);
    if (refusal_) return false;
    pinfield::apply(scene_, edit);
    edits_.push_back(std::move(edit));
    return true;
}

std::vector<NodeId> outermost(const Scene& scene, std::span<const NodeId> nodes) {
    const std::set<NodeId> chosen(nodes.begin(), nodes.end());
    std::vector<NodeId> out;
    for (const NodeId id : scene.all()) {
        if (!chosen.count(id) || scene.find(id)->is_record()) continue;
        bool inside = false;
        for (NodeId above = scene.find(id)->parent; above; above = scene.find(above)->parent) inside = inside || chosen.count(above);
        if (!inside) out.push_back(id);
    }
    return out;
}

Spot spot_after(const Scene& scene, std::span<const NodeId> nodes) {
    const std::vector<NodeId> chosen = outermost(scene, nodes);
    if (chosen.empty()) return {{}, static_cast<int>(scene.roots().size())};
    const NodeId parent = scene.find(chosen.back())->parent;
    return {parent, std::max(scene.index_of(chosen.back()) + 1, included_children(scene, parent))};
}

Outcome remove_nodes(Document& document, std::span<const NodeId> nodes) {
    const Scene& scene = document.scene();
    std::vector<NodeId> chosen = outermost(scene, nodes);
    for (const NodeId id : nodes)
        if (scene.find(id) && scene.find(id)->is_record() && !scene.find(id)->name.empty()) chosen.push_back(id);
    if (chosen.empty()) return {{}, {}, "nothing that can be deleted is selected"};
    const std::string label = label_of(scene, "Delete", chosen);
    EditPlan plan(scene);
    for (const NodeId id : chosen) plan.add(Remove{id});
    return commit(document, plan, label, {});
}

Outcome duplicate_nodes(Document& document, std::span<const NodeId> nodes, const Vec2& world_delta) {
    const std::vector<NodeId> chosen = outermost(document.scene(), nodes);
    if (chosen.empty()) return {{}, {}, "nothing that can be duplicated is selected"};
    EditPlan plan(document.scene());
    std::vector<NodeId> copies;
    for (const NodeId id : chosen) {
        const Result<std::string> text = text_of_node(document.reading(), id);
        if (!text) return {{}, {}, text.error().message};
        const Spot spot{plan.scene().find(id)->parent, plan.scene().index_of(id) + 1};
        insert_fragment(document.reading(), plan, spot, {plan.scene().copy(id), *text}, copies);
        if (plan.refusal()) break;
        if (length(world_delta) > 0) move_if_it_may(plan, copies.back(), world_delta);
    }
    return commit(document, plan, label_of(document.scene(), "Duplicate", chosen), copies);
}

Result<std::string> copied_text(const Document& document, std::span<const NodeId> nodes) {
    std::string out;
    for (const NodeId id : outermost(document.scene(), nodes)) {
        const Result<std::string> text = text_of_node(document.reading(), id);
        if (!text) return text;
        for (const char c : *text)
            if (c != '\r') out += c;
        out += '\n';
    }
    if (out.empty()) return failure("nothing that can be copied is selected");
    return out;
}

Outcome paste_text(Document& document, const std::string& text, const Spot& spot, const std::optional<Vec2>& centre) {
    const Result<std::vector<Fragment>> fragments = read_fragments(text, document.reading());
    if (!fragments) return {{}, {}, fmt::format("The text cannot be pasted: {}", fragments.error().message)};
    EditPlan plan(document.scene());
    std::vector<NodeId> pasted;
    for (std::size_t i = 0; i < fragments->size() && !plan.refusal(); ++i)
        insert_fragment(document.reading(), plan, {spot.parent, spot.index + static_cast<int>(i)}, (*fragments)[i], pasted);
    if (plan.refusal()) return {{}, {}, plan.refusal()};
    if (centre) {
        Vec2 middle(0, 0);
        for (const NodeId id : pasted) middle += world_from_local(plan.scene(), id).offset / static_cast<double>(pasted.size());
        for (const NodeId id : pasted) move_if_it_may(plan, id, *centre - middle);
    }
    return commit(document, plan, fmt::format("Paste {}", counted(pasted.size(), plan.scene().path(pasted.front()))), pasted);
}

Subtree new_nodes(const std::shared_ptr<const Catalog>& catalog, const NodeType& type) {
    Scene workshop(catalog);
    const NodeId root = workshop.add(type).id;
    for (int i = 0; i < type.meta.children.min; ++i) workshop.add(*workshop.catalog().find(i % 2 == 0 ? "circle" : "box"), root);
    Node& node = *workshop.find(root);
    for (std::size_t i = 0; i < node.fields.size(); ++i) {
        const FieldType& field = type.fields[i];
        FieldSlot& slot = node.fields[i];
        if (field.meta.required) slot.is_explicit = true;
        // As few corners of a regular polygon as the node's contracts take.
        for (int corners = 3; field.meta.required && field.kind == FieldKind::points && corners < 9; ++corners) {
            slot.value = regular_polygon(corners);
            if (!broken_contract(node)) break;
        }
    }
    return workshop.copy(root);
}

Outcome insert_new(Document& document, const NodeType& type, const Spot& spot, const Vec2& world) {
    EditPlan plan(document.scene());
    Subtree nodes = plan.scene().with_new_ids(new_nodes(document.scene().shared_catalog(), type));
    const NodeId id = nodes.front().id;
    const Vec2 local = world_of(document.scene(), spot.parent).inverse() * world;
    at(nodes.front().fields, *type.find_field("at")) = {Vec2(std::round(local.x() * 1e3) / 1e3, std::round(local.y() * 1e3) / 1e3), true, {}};
    plan.add(Insert{spot.parent, spot.index, std::move(nodes)});
    return commit(document, plan, fmt::format("Add {}", type.key()), {id});
}

Outcome new_material(Document& document) {
    const Scene& scene = document.scene();
    const auto is_taken = [&](const std::string& name) {
        return std::any_of(scene.materials().begin(), scene.materials().end(), [&](NodeId id) { return scene.find(id)->name == name; });
    };
    std::string name = "material";
    for (int i = 2; is_taken(name); ++i) name = fmt::format("material_{}", i);
    Scene workshop(scene.shared_catalog());
    const NodeId made = workshop.add_material(name).id;
    EditPlan plan(scene);
    Subtree nodes = plan.scene().with_new_ids(workshop.copy(made));
    const NodeId id = nodes.front().id;
    plan.add(Insert{{}, static_cast<int>(scene.materials().size()), std::move(nodes)});
    return commit(document, plan, fmt::format("Add {}", name), {id});
}

Outcome wrap_nodes(Document& document, std::span<const NodeId> nodes, const NodeType& type) {
    const std::vector<NodeId> chosen = outermost(document.scene(), nodes);
    if (chosen.empty()) return {{}, {}, "nothing that can be wrapped is selected"};
    EditPlan plan(document.scene());
    const NodeId parent = plan.scene().find(chosen.front())->parent;
    for (std::size_t i = 1; i < chosen.size(); ++i) {
        const Similarity world = world_of(plan.scene(), chosen[i]);
        const NodeId own_parent = plan.scene().find(chosen[i])->parent;
        const int index = plan.scene().index_of(chosen[i - 1]) + 1;
        if (own_parent == parent && plan.scene().index_of(chosen[i]) == index) continue;
        const bool from_before = own_parent == parent && plan.scene().index_of(chosen[i]) < index;
        if (!plan.add(Move{chosen[i], parent, from_before ? index - 1 : index})) break;
        if (own_parent != parent) place(plan, chosen[i], world_of(plan.scene(), parent).inverse() * world);
    }
    Scene workshop(document.scene().shared_catalog());
    const NodeId wrapper = workshop.add(type).id;
    Node node = plan.scene().with_new_ids(workshop.copy(wrapper)).front();
    const NodeId id = node.id;
    const bool shows_copies = type.kernels && type.kernels->images;
    if (shows_copies) {
        const Vec2 middle = 0.5 * plan.scene().table().get<Vec2>("size"), local = world_of(plan.scene(), parent).inverse() * middle;
        at(node.fields, *type.find_field("at")) = {Vec2(std::round(local.x() * 1e3) / 1e3, std::round(local.y() * 1e3) / 1e3), true, {}};
    }
    const Similarity children_from_parent = parent_from_local(node).inverse();
    plan.add(Wrap{parent, plan.scene().index_of(chosen.front()), static_cast<int>(chosen.size()), std::move(node)});
    for (const NodeId child : chosen)
        if (shows_copies) place(plan, child, children_from_parent * parent_from_local(*plan.scene().find(child)));
    return commit(document, plan, fmt::format("{} in {}", label_of(document.scene(), "Put", chosen), type.key()), {id});
}

Outcome unwrap_nodes(Document& document, std::span<const NodeId> nodes) {
    const std::vector<NodeId> chosen = outermost(document.scene(), nodes);
    if (chosen.empty()) return {{}, {}, "nothing that can be unwrapped is selected"};
    EditPlan plan(document.scene());
    std::vector<NodeId> freed;
    for (const NodeId id : chosen) {
        const Node wrapper = *plan.scene().find(id);
        const Similarity outer = parent_from_local(wrapper);
        for (const NodeId child : wrapper.children) {
            place(plan, child, outer * parent_from_local(*plan.scene().find(child)));
            for (const std::string_view key : {"material", "layer"}) {
                const int field = *wrapper.type->find_field(key);
                const Value& own = plan.scene().find(child)->value(key);
                const FieldType& type = at(wrapper.type->fields, field);
                if (!identical(at(wrapper.fields, field).value, type.initial) && identical(own, type.initial))
                    set_if_new(plan, child, key, at(wrapper.fields, field).value);
            }
            freed.push_back(child);
        }
        plan.add(Unwrap{id});
    }
    return commit(document, plan, label_of(document.scene(), "Unwrap", chosen), freed);
}

Outcome move_nodes(Document& document, std::span<const NodeId> nodes, const Spot& spot, bool keep_world) {
    const std::vector<NodeId> chosen = outermost(document.scene(), nodes);
    if (chosen.empty()) return {{}, {}, "nothing that can be moved is selected"};
    EditPlan plan(document.scene());
    int index = spot.index;
    for (const NodeId id : chosen) {
        const Similarity world = world_of(plan.scene(), id);
        const NodeId own_parent = plan.scene().find(id)->parent;
        if (own_parent == spot.parent && plan.scene().index_of(id) < index) --index;
        if (!plan.add(Move{id, spot.parent, index})) break;
        ++index;
        if (keep_world && own_parent != spot.parent) place(plan, id, world_of(plan.scene(), spot.parent).inverse() * world);
    }
    return commit(document, plan, label_of(document.scene(), "Move", chosen), chosen);
}

Outcome rename_node(Document& document, NodeId id, const std::string& name) {
    const Node* node = document.scene().find(id);
    if (!node) return {{}, {}, "the node no longer exists"};
    if (name == node->name) return {{id}, {}, {}};
    EditPlan plan(document.scene());
    plan.add(Rename{id, node->name, name, !name.empty()});
    const std::string label = fmt::format("Rename {} to {}", document.scene().path(id), name.empty() ? "nothing" : name);
    return commit(document, plan, label, {id});
}

Outcome change_type(Document& document, NodeId id, const NodeType& type) {
    if (!document.scene().find(id)) return {{}, {}, "the node no longer exists"};
    EditPlan plan(document.scene());
    plan.add(retyped(document.scene(), id, type));
    return commit(document, plan, fmt::format("Change {} to {}", document.scene().path(id), type.key()), {id});
}

std::vector<const NodeType*> types_of(const Catalog& catalog, NodeKind kind) {
    std::vector<const NodeType*> out;
    for (const NodeType& type : catalog.types())
        if (type.meta.kind == kind) out.push_back(&type);
    std::sort(out.begin(), out.end(), [](const NodeType* a, const NodeType* b) { return a->key() < b->key(); });
    return out;
}

std::vector<const NodeType*> types_for(const Scene& scene, const Catalog& catalog, NodeId id) {
    const Node* node = scene.find(id);
    if (!node || node->is_record()) return {};
    std::vector<const NodeType*> out = types_of(catalog, node->type->meta.kind);
    std::erase_if(out, [&](const NodeType* type) { return type == node->type || why_invalid(scene, Edit(retyped(scene, id, *type))); });
    return out;
}

}  // namespace pinfield::editor
