#include "engine/scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/core/at.h"
#include "engine/core/trig.h"
#include "engine/scene/part_traits.h"

namespace pinfield {
namespace {

/// Position among the siblings of the same type.
int index_among(const Scene& scene, const std::vector<NodeId>& siblings, const Node& node) {
    int index = 0;
    for (const NodeId id : siblings) {
        if (id == node.id) break;
        if (scene.find(id)->type == node.type) ++index;
    }
    return index;
}

}  // namespace

const Value& Node::value(std::string_view key_of_field) const {
    const std::optional<int> index = type->find_field(key_of_field);
    assert(index && "the node type has no field of this key");
    return at(fields, *index).value;
}

bool Node::has_use_for(std::size_t field) const {
    const OnlyWith& with = type->fields[field].meta.only_with;
    if (!children.empty() && type->part) {
        const std::vector<std::string_view>& customary = type->part->only_customary;
        if (std::find(customary.begin(), customary.end(), type->fields[field].key) != customary.end()) return false;
    }
    return with.field.empty() || get<std::string>(with.field) == with.choice;
}

Scene::Scene(std::shared_ptr<const Catalog> catalog) : catalog_(std::move(catalog)) {
    table_ = insert(*catalog_->find("table"), {}).id;
    physics_ = insert(*catalog_->find("physics"), {}).id;
}

Node& Scene::insert(const NodeType& type, NodeId parent) {
    Node node;
    node.id = NodeId{next_id_++};
    node.type = &type;
    node.parent = parent;
    node.fields.reserve(type.fields.size());
    for (const FieldType& field : type.fields) node.fields.push_back({field.initial, false, {}});
    return nodes_[node.id] = std::move(node);
}

Node& Scene::add(const NodeType& type, NodeId parent) {
    Node& node = insert(type, parent);
    (parent ? find(parent)->children : roots_).push_back(node.id);
    return node;
}

Node& Scene::add_material(const std::string& name) {
    Node& node = insert(*catalog_->find("material"), {});
    node.name = name;
    materials_.push_back(node.id);
    return node;
}

std::vector<NodeId>& Scene::list_for(const NodeType& type, NodeId parent) {
    if (type.meta.kind == NodeKind::record) return materials_;
    return parent ? find(parent)->children : roots_;
}

const std::vector<NodeId>& Scene::siblings(NodeId id) const {
    const Node& node = *find(id);
    return node.is_record() ? materials_ : children_of(node.parent);
}

int Scene::index_of(NodeId id) const {
    const std::vector<NodeId>& list = siblings(id);
    return static_cast<int>(std::find(list.begin(), list.end(), id) - list.begin());
}

bool Scene::is_within(NodeId node, NodeId ancestor) const {
    for (const Node* at = find(node); at; at = find(at->parent))
        if (at->id == ancestor) return true;
    return false;
}

Subtree Scene::copy(NodeId id) const {
    Subtree out;
    std::vector<NodeId> open{id};
    while (!open.empty()) {
        out.push_back(*find(open.back()));
        open.pop_back();
        const std::vector<NodeId>& children = out.back().children;
        open.insert(open.end(), children.rbegin(), children.rend());
    }
    return out;
}

Subtree Scene::take(NodeId id) {
    Subtree out = copy(id);
    std::vector<NodeId>& list = list_for(*out.front().type, out.front().parent);
    list.erase(std::find(list.begin(), list.end(), id));
    for (const Node& node : out) nodes_.erase(node.id);
    return out;
}

void Scene::put(Subtree nodes, NodeId parent, int index) {
    nodes.front().parent = parent;
    std::vector<NodeId>& list = list_for(*nodes.front().type, parent);
    assert(index >= 0 && index <= static_cast<int>(list.size()));
    list.insert(list.begin() + index, nodes.front().id);
    for (Node& node : nodes) {
        next_id_ = std::max(next_id_, node.id.value + 1);
        [[maybe_unused]] const bool is_new = nodes_.emplace(node.id, std::move(node)).second;
        assert(is_new && "put() takes ids that are free");
    }
}

Subtree Scene::with_new_ids(Subtree nodes) const {
    std::map<NodeId, NodeId> new_ids{{NodeId{}, NodeId{}}};
    std::uint32_t next = next_id_;
    for (const Node& node : nodes) new_ids[node.id] = NodeId{next++};
    for (Node& node : nodes) {
        node.id = new_ids[node.id];
        const auto parent = new_ids.find(node.parent);
        node.parent = parent == new_ids.end() ? NodeId{} : parent->second;
        for (NodeId& child : node.children) child = new_ids[child];
    }
    return nodes;
}

const Node* Scene::find(NodeId id) const {
    const auto it = nodes_.find(id);
    return it == nodes_.end() ? nullptr : &it->second;
}
Node* Scene::find(NodeId id) { return const_cast<Node*>(std::as_const(*this).find(id)); }

const Node* Scene::find(std::string_view id_or_path) const {
    for (const NodeId id : all()) {
        const Node& node = *find(id);
        if (!node.is_record() && !node.name.empty() && node.name == id_or_path) return &node;
    }
    for (const auto& [id, path] : paths())
        if (path == id_or_path) return find(id);
    return nullptr;
}

std::string Scene::path(NodeId id) const {
    const Node& node = *find(id);
    if (node.is_record())
        return node.name.empty() ? std::string(node.type->key()) : "materials/" + node.name;
    if (!node.name.empty()) return node.name;
    const std::vector<NodeId>& siblings = node.parent ? find(node.parent)->children : roots_;
    std::string own = fmt::format("{}[{}]", node.type->key(), index_among(*this, siblings, node));
    return node.parent ? path(node.parent) + "/" + own : own;
}

std::map<NodeId, std::string> Scene::paths() const {
    std::map<NodeId, std::string> out;
    std::map<std::pair<NodeId, const NodeType*>, int> counts;  // of siblings so far, per parent
    for (const NodeId id : all()) {                            // parents come before their children
        const Node& node = *find(id);
        const bool record = node.is_record();
        const int index = record ? 0 : counts[{node.parent, node.type}]++;
        if (record || !node.name.empty()) {
            out.emplace(id, path(id));
            continue;
        }
        const std::string above = node.parent ? out.at(node.parent) + "/" : "";
        out.emplace(id, fmt::format("{}{}[{}]", above, node.type->key(), index));
    }
    return out;
}

std::vector<NodeId> Scene::all() const {
    std::vector<NodeId> out{table_, physics_};
    out.insert(out.end(), materials_.begin(), materials_.end());
    std::vector<NodeId> stack(roots_.rbegin(), roots_.rend());
    while (!stack.empty()) {
        const NodeId id = stack.back();
        stack.pop_back();
        out.push_back(id);
        const std::vector<NodeId>& children = find(id)->children;
        stack.insert(stack.end(), children.rbegin(), children.rend());
    }
    return out;
}

std::string Scene::material_name(NodeId id) const {
    for (const Node* node = find(id); node; node = node->parent ? find(node->parent) : nullptr)
        if (const auto& own = node->get<std::string>("material"); !own.empty()) return own;
    return "default";
}

std::vector<std::string> Scene::layers(NodeId id) const {
    for (const Node* node = find(id); node; node = node->parent ? find(node->parent) : nullptr)
        if (const auto& own = node->get<std::vector<std::string>>("layer"); !own.empty()) return own;
    return {std::string(ground_layer_name)};
}

void Scene::keep_ids_of(const Scene& before) {
    std::map<std::string, NodeId> old_ids;
    const std::map<NodeId, std::string> old_paths = before.paths(), new_paths = paths();
    for (const NodeId id : before.all()) old_ids.emplace(old_paths.at(id), id);
    std::map<NodeId, NodeId> known;
    for (const NodeId id : all()) {
        const auto match = old_ids.find(new_paths.at(id));
        if (match != old_ids.end() && before.find(match->second)->type->key() == find(id)->type->key()) known[id] = match->second;
    }
    take_ids(known, before);
}

void Scene::take_ids(const std::map<NodeId, NodeId>& ids, const Scene& later) {
    std::map<NodeId, NodeId> renamed;
    std::uint32_t next = std::max(next_id_, later.next_id_);
    for (const NodeId id : all()) {
        const auto known = ids.find(id);
        renamed[id] = known == ids.end() ? NodeId{next++} : known->second;
    }
    next_id_ = next;
    rename(renamed);
}

void Scene::take_ids(const std::vector<NodeId>& ids, const Scene& later) {
    const std::vector<NodeId> mine = all();
    assert(mine.size() == ids.size() && "take_ids() is for scenes of the same nodes");
    std::map<NodeId, NodeId> renamed;
    for (std::size_t i = 0; i < mine.size(); ++i) renamed[mine[i]] = ids[i];
    next_id_ = later.next_id_;
    for (const NodeId id : ids) next_id_ = std::max(next_id_, id.value + 1);
    rename(renamed);
}

void Scene::rename(const std::map<NodeId, NodeId>& new_ids) {
    const auto rename = [&](NodeId& id) { if (id) id = new_ids.at(id); };
    std::map<NodeId, Node> nodes;
    for (auto& [id, node] : nodes_) {
        rename(node.id);
        rename(node.parent);
        for (NodeId& child : node.children) rename(child);
        const NodeId key = node.id;
        nodes[key] = std::move(node);
    }
    nodes_ = std::move(nodes);
    for (NodeId& id : roots_) rename(id);
    for (NodeId& id : materials_) rename(id);
    rename(table_);
    rename(physics_);
}

bool same_node(const Scene& a, const Node& x, const Scene& b, const Node& y) {
    if (!x.generator != !y.generator || !x.origin != !y.origin) return false;
    if (x.type->key() != y.type->key() || x.name != y.name || x.fields.size() != y.fields.size() ||
        x.children.size() != y.children.size())
        return false;
    for (std::size_t i = 0; i < x.fields.size(); ++i)
        if (x.fields[i].is_explicit != y.fields[i].is_explicit || !identical(x.fields[i].value, y.fields[i].value) ||
            !x.fields[i].is_written_as(y.fields[i]))
            return false;
    for (std::size_t i = 0; i < x.children.size(); ++i)
        if (!same_node(a, *a.find(x.children[i]), b, *b.find(y.children[i]))) return false;
    return true;
}

bool same_nodes(const Scene& a, const std::vector<NodeId>& x, const Scene& b, const std::vector<NodeId>& y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                      [&](NodeId i, NodeId j) { return same_node(a, *a.find(i), b, *b.find(j)); });
}

bool same_param(const Param& a, const Param& b) {
    const auto same = [](const WrittenQuantity& x, const WrittenQuantity& y) { return x.text == y.text && identical(Value(x.value), Value(y.value)); };
    const auto both = [&](const std::optional<WrittenQuantity>& x, const std::optional<WrittenQuantity>& y) {
        return x.has_value() == y.has_value() && (!x || same(*x, *y));
    };
    return a.name == b.name && same(a.value, b.value) && both(a.min, b.min) && both(a.max, b.max) && both(a.step, b.step) &&
           a.label == b.label && a.unit == b.unit;
}

bool same_input(const InputBinding& a, const InputBinding& b) { return a.name == b.name && a.keys == b.keys; }

bool same_test(const TableTest& a, const TableTest& b) {
    return a.name == b.name && a.run == b.run &&
           std::equal(a.launches.begin(), a.launches.end(), b.launches.begin(), b.launches.end(),
                      [](const auto& x, const auto& y) { return x.at == y.at && x.velocity == y.velocity; }) &&
           std::equal(a.inputs.begin(), a.inputs.end(), b.inputs.begin(), b.inputs.end(),
                      [](const auto& x, const auto& y) { return x.input == y.input && x.times == y.times; }) &&
           std::equal(a.expectations.begin(), a.expectations.end(), b.expectations.begin(), b.expectations.end(),
                      [](const auto& x, const auto& y) {
                          return x.quantity == y.quantity && x.comparison == y.comparison && x.value == y.value;
                      });
}

Similarity parent_from_local(const Node& node) {
    const double turn = node.get<double>("turn");
    Similarity out{cosine_degrees(turn), sine_degrees(turn), node.get<double>("scale"), false, node.get<Vec2>("at")};
    const auto& flip = node.get<std::string>("flip");
    if (flip != "none") out.mirrored = true;
    if (flip == "x") {  // negating x is negating y and half a turn
        out.cosine = -out.cosine;
        out.sine = -out.sine;
    }
    return out;
}

Similarity world_from_local(const Scene& scene, NodeId id) {
    const Node& node = *scene.find(id);
    const Similarity own = parent_from_local(node);
    return node.parent ? world_from_local(scene, node.parent) * own : own;
}

}  // namespace pinfield
