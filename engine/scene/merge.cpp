#include "engine/scene/merge.h"

#include <algorithm>
#include <set>
#include <utility>

#include "engine/core/at.h"
#include "engine/scene/edit.h"
#include "engine/scene/match.h"
#include "engine/scene/order.h"

namespace pinfield {
namespace {

using About = MergeConflict::About;
using Nodes = std::vector<NodeId>;

bool same_slot(const FieldSlot& a, const FieldSlot& b) { return a.is_explicit == b.is_explicit && identical(a.value, b.value); }

const FieldSlot* slot_of(const Node& node, std::string_view key) {
    const auto field = node.type->find_field(key);
    return field ? &at(node.fields, *field) : nullptr;
}

/// -1, 0, 1: an order of values without meaning, but the same on both sides.
int compared(const Value& a, const Value& b) {
    const auto sign = [](const auto& x, const auto& y) { return x < y ? -1 : y < x ? 1 : 0; };
    if (a.index() != b.index()) return sign(a.index(), b.index());
    const auto numbers = [](const Value& v) {
        std::vector<double> out;
        if (const auto* pair = std::get_if<Vec2>(&v)) out = {pair->x(), pair->y()};
        if (const auto* points = std::get_if<std::vector<Vec2>>(&v))
            for (const Vec2& p : *points) out.insert(out.end(), {p.x(), p.y()});
        return out;
    };
    if (std::holds_alternative<Vec2>(a) || std::holds_alternative<std::vector<Vec2>>(a)) return sign(numbers(a), numbers(b));
    return std::visit(
        [&](const auto& x) -> int {
            using T = std::decay_t<decltype(x)>;
            if constexpr (std::is_same_v<T, Vec2> || std::is_same_v<T, std::vector<Vec2>>)
                return 0;
            else
                return sign(x, std::get<T>(b));
        },
        a);
}

int compared(const Scene& a, const Node& x, const Scene& b, const Node& y) {
    if (x.name != y.name) return x.name < y.name ? -1 : 1;
    if (x.type->key() != y.type->key()) return x.type->key() < y.type->key() ? -1 : 1;
    for (std::size_t i = 0; i < x.fields.size(); ++i)
        if (const int sign = compared(x.fields[i].value, y.fields[i].value); sign != 0) return sign;
    if (x.children.size() != y.children.size()) return x.children.size() < y.children.size() ? -1 : 1;
    for (std::size_t i = 0; i < x.children.size(); ++i)
        if (const int sign = compared(a, *a.find(x.children[i]), b, *b.find(y.children[i])); sign != 0) return sign;
    return 0;
}

class Merging {
public:
    Merging(const Scene& base, const Scene& mine, const Scene& theirs, const Choices& choices)
        : base_(base), mine_(mine), theirs_(theirs), choices_(choices) {}

    MergedScene run() && {
        follow_names(mine_, theirs_);
        follow_names(theirs_, mine_);
        const std::set<NodeId> all = ids();
        judge_removals(Whose::mine);
        judge_removals(Whose::theirs);
        for (const NodeId id : all)
            if (is_present(id)) parents_[id] = parent_of(id);
        mend_parents();
        Scene out = theirs_;
        for (const Nodes& old : {Nodes(out.roots()), Nodes(out.materials())})
            for (const NodeId id : old) out.take(id);
        for (const NodeId record : {out.table().id, out.physics().id}) out.find(record)->fields = merged(record).fields;
        for (const bool records : {true, false}) {
            int index = 0;
            for (const NodeId id : order(NodeId{}, records)) out.put(subtree(id), {}, index++);
        }
        merge_lists(out);
        return {std::move(out), std::move(conflicts_)};
    }

private:
    bool takes_mine(const MergeConflict& conflict) {
        if (std::find(conflicts_.begin(), conflicts_.end(), conflict) == conflicts_.end()) conflicts_.push_back(conflict);
        const auto chosen = choices_.find(conflict);
        return chosen != choices_.end() && chosen->second == Whose::mine;
    }
    const Scene& side(Whose s) const { return s == Whose::mine ? mine_ : theirs_; }

    std::set<NodeId> ids() const {
        std::set<NodeId> out;
        for (const Scene* scene : {&base_, &mine_, &theirs_})
            for (const NodeId id : scene->all())
                if (id != base_.table().id && id != base_.physics().id) out.insert(id);
        return out;
    }

    /// A name that one side alone has changed is the new one on the other side and before, too, with all that refers to it.
    void follow_names(const Scene& renaming, Scene& other) {
        for (const NodeId id : base_.all()) {
            const Node *old = base_.find(id), *young = renaming.find(id), *there = other.find(id);
            if (!young || !there || young->name == old->name || there->name != old->name) continue;
            const FieldSlot* said = slot_of(*young, "id");
            rename_in_both({id, old->name, young->name, !said || said->is_explicit}, other);
        }
        if (renaming.inputs.size() != base_.inputs.size()) return;
        const auto knows = [](const Scene& scene, const std::string& name) {
            return std::any_of(scene.inputs.begin(), scene.inputs.end(), [&](const InputBinding& input) { return input.name == name; });
        };
        for (std::size_t i = 0; i < base_.inputs.size(); ++i)
            if (const std::string from = base_.inputs[i].name, to = renaming.inputs[i].name; !knows(renaming, from) && !knows(base_, to))
                rename_in_both({{}, from, to}, other);
    }

    void rename_in_both(const Rename& edit, Scene& other) {
        if (why_invalid(base_, Edit(edit)) || why_invalid(other, Edit(edit))) return;
        pinfield::apply(base_, Edit(edit));
        pinfield::apply(other, Edit(edit));
    }

    // What is there.

    bool is_changed(const Scene& scene, NodeId id) const {
        const Node &before = *base_.find(id), &now = *scene.find(id);
        return now.type->key() != before.type->key() || now.name != before.name || now.parent != before.parent ||
               !std::equal(now.fields.begin(), now.fields.end(), before.fields.begin(), before.fields.end(), same_slot);
    }

    /// Nodes that one side took out together, the outermost first.
    Nodes taken_out_with(NodeId outermost, const Scene& without) const {
        Nodes out, open{outermost};
        while (!open.empty()) {
            out.push_back(open.back());
            open.pop_back();
            for (const NodeId child : base_.find(out.back())->children)
                if (!without.find(child)) open.push_back(child);
        }
        return out;
    }

    bool puts_into(const Scene& scene, const Nodes& nodes) const {
        const auto all = scene.all();
        return std::any_of(all.begin(), all.end(), [&](NodeId id) {
            const NodeId parent = scene.find(id)->parent;
            const bool within = parent && std::find(nodes.begin(), nodes.end(), parent) != nodes.end();
            return within && (!base_.find(id) || base_.find(id)->parent != parent);
        });
    }

    void judge_removals(Whose remover) {
        const Scene &without = side(remover), &with = side(remover == Whose::mine ? Whose::theirs : Whose::mine);
        for (const NodeId id : base_.all()) {
            const NodeId parent = base_.find(id)->parent;
            if (without.find(id) || (parent && !without.find(parent))) continue;
            const Nodes nodes = taken_out_with(id, without);
            const bool touched = puts_into(with, nodes) || std::any_of(nodes.begin(), nodes.end(), [&](NodeId node) {
                                     return with.find(node) && is_changed(with, node);
                                 });
            if (!touched) continue;
            const bool taken_out = takes_mine({About::presence, id, {}}) == (remover == Whose::mine);
            if (!taken_out) kept_.insert(nodes.begin(), nodes.end());
        }
    }

    bool is_present(NodeId id) const {
        const bool here = mine_.find(id), there = theirs_.find(id);
        return !base_.find(id) || (here && there) || ((here || there) && kept_.contains(id));
    }

    // Where it is.

    NodeId parent_of(NodeId id) {
        const Node *before = base_.find(id), *here = mine_.find(id), *there = theirs_.find(id);
        if (!here || !there) return (here ? here : there)->parent;
        if (here->parent == there->parent || (before && here->parent == before->parent)) return there->parent;
        if (before && there->parent == before->parent) return here->parent;
        return takes_mine({About::place, id, {}}) ? here->parent : there->parent;
    }

    /// What would lie in a node that is gone stays where the other side has it; nodes that the sides put into each other follow one side.
    void mend_parents() {
        for (auto& [id, parent] : parents_) {
            if (!parent || parents_.contains(parent)) continue;
            for (const Scene* scene : {&mine_, &theirs_})
                if (const Node* node = scene->find(id); node && (!node->parent || parents_.contains(node->parent))) parent = node->parent;
        }
        for (const auto& [first, unused] : parents_) {
            Nodes way{first};
            while (way.size() <= parents_.size() && parents_.contains(parents_.at(way.back()))) way.push_back(parents_.at(way.back()));
            if (way.size() <= parents_.size()) continue;
            const std::set<NodeId> circle(way.begin(), way.end());
            const bool mine = takes_mine({About::place, *circle.begin(), {}});
            for (const NodeId id : circle)
                if (const Node* node = side(mine ? Whose::mine : Whose::theirs).find(id)) parents_[id] = node->parent;
        }
    }

    /// The present ones of a list, as one side has them.
    Nodes present(const Scene& scene, NodeId parent, bool records) const {
        if (parent && !scene.find(parent)) return {};
        Nodes out;
        for (const NodeId id : records ? scene.materials() : scene.children_of(parent))
            if (const auto known = parents_.find(id); known != parents_.end() && known->second == parent) out.push_back(id);
        return out;
    }

    Nodes order(NodeId parent, bool records) {
        const Nodes before = present(base_, parent, records), here = present(mine_, parent, records),
                    there = present(theirs_, parent, records);
        Nodes out = merged_order(
            before, here, there, [&](NodeId a, NodeId b) { return compared(mine_, *mine_.find(a), theirs_, *theirs_.find(b)) < 0; },
            [&](NodeId id) {
                return takes_mine({About::place, id, {}});
            });
        for (const auto& [id, where] : parents_) {  // the few that neither side has here
            const Node& node = *(mine_.find(id) ? mine_ : theirs_).find(id);
            if (where == parent && node.is_record() == records && std::find(out.begin(), out.end(), id) == out.end()) out.push_back(id);
        }
        return out;
    }

    // What it says.

    /// Are there fields that one side changed and the type of the other has not?
    bool loses_changes(const Node& before, const Node& now, const NodeType& type) const {
        for (std::size_t i = 0; i < now.fields.size(); ++i) {
            const FieldSlot* old = slot_of(before, now.type->fields[i].key);
            if (!type.find_field(now.type->fields[i].key) && (!old || !same_slot(*old, now.fields[i]))) return true;
        }
        return false;
    }

    const NodeType* merged_type(const Node* before, const Node& here, const Node& there) {
        if (here.type->key() == there.type->key()) return there.type;
        const bool i_kept = before && before->type->key() == here.type->key(),
                   they_kept = before && before->type->key() == there.type->key();
        if (i_kept && !loses_changes(*before, here, *there.type)) return there.type;
        if (they_kept && !loses_changes(*before, there, *here.type)) return here.type;
        return takes_mine({About::type, here.id, {}}) ? here.type : there.type;
    }

    FieldSlot merged_slot(NodeId id, const FieldType& field, const FieldSlot* before, const FieldSlot* here, const FieldSlot* there) {
        if (!here && !there) return {field.initial, false, {}};
        if (!here || !there) return here ? *here : *there;
        if (same_slot(*here, *there) || (before && same_slot(*before, *here))) return *there;
        if (before && same_slot(*before, *there)) return *here;
        return takes_mine({About::value, id, std::string(field.key)}) ? *here : *there;
    }

    Node merged(NodeId id) {
        const Node *before = base_.find(id), *here = mine_.find(id), *there = theirs_.find(id);
        Node out = there ? *there : *here;
        if (here && there) {
            out.type = merged_type(before, *here, *there);
            out.fields.clear();
            for (const FieldType& field : out.type->fields)
                out.fields.push_back(merged_slot(id, field, before ? slot_of(*before, field.key) : nullptr, slot_of(*here, field.key),
                                                 slot_of(*there, field.key)));
            const bool theirs_counts = here->name == there->name || (before && here->name == before->name);
            const bool mine_counts = !theirs_counts && before && there->name == before->name;
            if (!out.is_record())
                out.name = std::get<std::string>(slot_of(out, "id")->value);
            else if (mine_counts || (!theirs_counts && takes_mine({About::value, id, "name"})))
                out.name = here->name;
        }
        for (FieldSlot& slot : out.fields) slot.where = {};
        out.where = out.key = {};
        return out;
    }

    Subtree subtree(NodeId id) {
        Subtree out{merged(id)};
        out.front().children = order(id, false);
        for (const NodeId child : Nodes(out.front().children)) {
            Subtree inner = subtree(child);
            inner.front().parent = id;
            std::move(inner.begin(), inner.end(), std::back_inserter(out));
        }
        return out;
    }

    // Lists of what has a name and no id.

    /// Each by its name, and the second of that name and so on by a number, too.
    template <class Item>
    static std::vector<std::string> keys_of(const std::vector<Item>& items) {
        std::vector<std::string> out;
        for (const Item& item : items) {
            const auto same = std::count_if(items.data(), &item, [&](const Item& other) { return other.name == item.name; });
            out.push_back(same == 0 ? item.name : item.name + " (" + std::to_string(same + 1) + ")");
        }
        return out;
    }

    template <class Item, class Same>
    std::vector<Item> merged_list(About about, const std::vector<Item>& before, const std::vector<Item>& here,
                                  const std::vector<Item>& there, Same same) {
        using Keys = std::vector<std::string>;
        Keys base_keys = keys_of(before), my_keys = keys_of(here), their_keys = keys_of(there);
        const auto find = [](const Keys& keys, const std::vector<Item>& items, const std::string& key) {
            const auto found = std::find(keys.begin(), keys.end(), key);
            return found == keys.end() ? nullptr : &items[static_cast<std::size_t>(found - keys.begin())];
        };
        std::map<std::string, const Item*> chosen;
        std::set<std::string> all(my_keys.begin(), my_keys.end());
        all.insert(their_keys.begin(), their_keys.end());
        for (const std::string& key : all) {
            const Item *old = find(base_keys, before, key), *mine = find(my_keys, here, key), *theirs = find(their_keys, there, key);
            const bool i_kept = old && mine && same(*old, *mine), they_kept = old && theirs && same(*old, *theirs);
            const Item* taken = nullptr;
            if (mine && theirs && same(*mine, *theirs))
                taken = theirs;
            else if (i_kept || (!old && !mine))
                taken = theirs;
            else if (they_kept || (!old && !theirs))
                taken = mine;
            else
                taken = takes_mine({about, {}, key}) ? mine : theirs;
            if (taken) chosen.emplace(key, taken);
        }
        for (Keys* keys : {&base_keys, &my_keys, &their_keys})
            std::erase_if(*keys, [&](const std::string& key) { return !chosen.contains(key); });
        std::vector<Item> out;
        for (const std::string& key : merged_order(base_keys, my_keys, their_keys, std::less<>(), [](const std::string&) { return false; }))
            out.push_back(*chosen.at(key));
        return out;
    }

    void merge_lists(Scene& out) {
        out.inputs = merged_list(About::input, base_.inputs, mine_.inputs, theirs_.inputs, same_input);
        out.tests = merged_list(About::test, base_.tests, mine_.tests, theirs_.tests, same_test);
    }

    Scene base_, mine_, theirs_;
    const Choices& choices_;
    std::vector<MergeConflict> conflicts_;
    std::set<NodeId> kept_;             ///< taken out by one side, and yet there
    std::map<NodeId, NodeId> parents_;  ///< of what is there
};

}  // namespace

MergedScene merge(const Scene& base, const Scene& mine, const Scene& theirs, const Choices& choices) {
    return Merging(base, mine, theirs, choices).run();
}

void share_ids(const Scene& base, const Scene& mine, Scene& theirs) {
    std::map<NodeId, NodeId> ids = match(base, theirs);
    const std::map<NodeId, NodeId> also_mine = match(mine, theirs);
    std::set<NodeId> taken;
    for (const auto& [id, known] : ids) taken.insert(known);
    // Behind which node of the base, by its id there, a new one stands: none at the front.
    const auto behind = [&](const Scene& scene, NodeId id, const auto& id_of) {
        NodeId last;
        for (const NodeId other : scene.siblings(id)) {
            if (other == id) break;
            if (const NodeId known = id_of(other); base.find(known)) last = known;
        }
        return last;
    };
    const auto own_id = [](NodeId id) { return id; };
    const auto shared_id = [&](NodeId id) { return ids.contains(id) ? ids.at(id) : NodeId{}; };
    for (const NodeId id : theirs.all()) {  // parents come before their children
        const auto twin = also_mine.find(id);
        if (ids.contains(id) || twin == also_mine.end() || base.find(twin->second) || taken.contains(twin->second)) continue;
        const Node &a = *mine.find(twin->second), &b = *theirs.find(id);
        const bool same_name = !a.name.empty() && a.name == b.name;
        const bool same_place =
            !b.parent == !a.parent && shared_id(b.parent) == a.parent && behind(mine, a.id, own_id) == behind(theirs, id, shared_id);
        if (same_name || (same_place && same_node(mine, a, theirs, b))) ids.emplace(id, a.id);
    }
    theirs.take_ids(ids, mine);
}

}  // namespace pinfield
