#include "engine/scene/edits_between.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "engine/core/at.h"
#include "engine/scene/order.h"

namespace pinfield {
namespace {

using Nodes = std::vector<NodeId>;

/// Goes through all that differs, again and again: what cannot be done yet waits until something else is.
class Way {
public:
    Way(const Scene& from, const Scene& to, const TextOfNode& text_of) : now_(from), to_(to), text_of_(text_of) {}

    Result<std::vector<Edit>> run() && {
        std::size_t before = 0;
        do {
            before = edits_.size();
            refusal_.clear();
            names();
            inputs();
            for (const NodeId id : to_.roots()) wrap(id);
            materials();
            children({}, to_.roots());
            for (const NodeId id : to_.all())
                if (now_.find(id) && !to_.find(id)->is_record()) children(id, to_.find(id)->children);
            leave();
            values();
            tests();
            if (is_there()) return std::move(edits_);
        } while (edits_.size() > before);
        return failure(refusal_.empty() ? "the tables differ in more than edits can say" : refusal_);
    }

private:
    bool take(Edit edit) {
        if (auto why = why_invalid(now_, edit)) {
            if (refusal_.empty()) refusal_ = std::move(*why);
            return false;
        }
        pinfield::apply(now_, edit);
        edits_.push_back(std::move(edit));
        return true;
    }

    bool is_there() const {
        return same_nodes(now_, now_.roots(), to_, to_.roots()) && same_nodes(now_, now_.materials(), to_, to_.materials()) &&
               same_node(now_, now_.table(), to_, to_.table()) && same_node(now_, now_.physics(), to_, to_.physics()) &&
               std::equal(now_.inputs.begin(), now_.inputs.end(), to_.inputs.begin(), to_.inputs.end(), same_input) &&
               std::equal(now_.tests.begin(), now_.tests.end(), to_.tests.begin(), to_.tests.end(), same_test);
    }

    void names() {
        for (const NodeId id : to_.all()) {
            const Node *wanted = to_.find(id), *node = now_.find(id);
            if (!node || node->name == wanted->name) continue;
            const auto field = wanted->type->find_field("id");
            take(Rename{id, node->name, wanted->name, !field || at(wanted->fields, *field).is_explicit});
        }
    }

    /// A new node around some that are there begins with them, the innermost first.
    void wrap(NodeId id) {
        const Node& node = *to_.find(id);
        for (const NodeId child : node.children) wrap(child);
        if (now_.find(id)) return;
        const auto first = std::find_if(node.children.begin(), node.children.end(), [&](NodeId child) { return now_.find(child); });
        if (first == node.children.end()) return;
        const NodeId parent = now_.find(*first)->parent;
        const Nodes& among = now_.children_of(parent);
        const int begin = now_.index_of(*first);
        const auto is_child = [&](NodeId other) {
            return std::find(node.children.begin(), node.children.end(), other) != node.children.end();
        };
        int count = 1;
        while (begin + count < static_cast<int>(among.size()) && is_child(at(among, begin + count))) ++count;
        Node wrapper = node;
        wrapper.children.clear();
        take(Wrap{parent, begin, count, std::move(wrapper)});
    }

    bool insert(NodeId id, NodeId parent, int index) {
        Insert edit{parent, index, to_.copy(id), {}};
        for (const Node& node : edit.nodes)
            if (now_.find(node.id)) return false;  // it is wrapped around them, or they move later
        if (text_of_ && !edit.nodes.front().is_record()) edit.text = text_of_(id);
        return take(std::move(edit));
    }

    void materials() {
        int next = 0;
        for (const NodeId id : to_.materials()) {
            if (now_.find(id))
                next = now_.index_of(id) + 1;
            else if (insert(id, {}, next))
                ++next;
        }
    }

    /// Those that are to be moved, or put in, go behind the one they are to follow; the others stay.
    void children(NodeId parent, const Nodes& wanted) {
        const std::set<NodeId> stay = unmoved(now_.children_of(parent), wanted);
        NodeId last;
        for (const NodeId id : wanted) {
            const bool stays = stay.contains(id);
            const int index = last ? now_.index_of(last) + 1 : 0;
            const Node* node = now_.find(id);
            bool placed = stays;
            if (!node) {
                placed = insert(id, parent, index);
            } else if (!stays) {
                const bool from_before = node->parent == parent && now_.index_of(id) < index;
                placed = take(Move{id, parent, from_before ? index - 1 : index});
            }
            if (placed) last = id;
        }
    }

    bool holds_some_that_stay(NodeId id) const {
        const Subtree nodes = now_.copy(id);
        return std::any_of(nodes.begin(), nodes.end(), [&](const Node& node) { return to_.find(node.id); });
    }

    void leave() {
        for (const NodeId id : now_.all()) {
            if (!now_.find(id) || to_.find(id)) continue;
            if (holds_some_that_stay(id))
                take(Unwrap{id});
            else
                take(Remove{id});
        }
    }

    void values() {
        for (const NodeId id : to_.all()) {
            const Node* node = now_.find(id);
            if (!node) continue;
            const Node& wanted = *to_.find(id);
            if (node->type->key() != wanted.type->key()) retype(*node, wanted);
            node = now_.find(id);
            if (node->type->key() != wanted.type->key()) continue;
            for (std::size_t i = 0; i < wanted.fields.size(); ++i) {
                const FieldSlot &slot = wanted.fields[i], &old = now_.find(id)->fields[i];
                if (old.is_explicit != slot.is_explicit || !identical(old.value, slot.value))
                    take(SetField{id, static_cast<int>(i), slot.value, slot.is_explicit});
            }
        }
    }

    /// What both types say keeps its value for now.
    void retype(const Node& node, const Node& wanted) {
        Retype edit{node.id, wanted.type, wanted.fields};
        for (std::size_t i = 0; i < edit.fields.size(); ++i) {
            const auto same = node.type->find_field(wanted.type->fields[i].key);
            if (same && at(node.fields, *same).is_explicit && edit.fields[i].is_explicit) edit.fields[i] = at(node.fields, *same);
        }
        take(std::move(edit));
    }

    void inputs() {
        const auto place = [](const std::vector<InputBinding>& list, const std::string& name) {
            const auto found = std::find_if(list.begin(), list.end(), [&](const InputBinding& input) { return input.name == name; });
            return found == list.end() ? -1 : static_cast<int>(found - list.begin());
        };
        int next = 0;
        for (const InputBinding& wanted : to_.inputs) {
            const int here = place(now_.inputs, wanted.name);
            if (here < 0 && take(InsertInput{wanted, next})) ++next;
            if (here >= 0 && !same_input(at(now_.inputs, here), wanted)) take(SetKeys{here, wanted.keys});
            if (here >= 0) next = here + 1;
        }
        for (int i = static_cast<int>(now_.inputs.size()); i-- > 0;)
            if (place(to_.inputs, at(now_.inputs, i).name) < 0) take(RemoveInput{i});
    }

    void tests() {
        const auto in = [](const std::vector<TableTest>& list, std::size_t begin, const TableTest& test) {
            return std::any_of(list.begin() + static_cast<std::ptrdiff_t>(std::min(begin, list.size())), list.end(),
                               [&](const TableTest& other) { return same_test(other, test); });
        };
        for (std::size_t i = 0; i < to_.tests.size(); ++i) {
            const TableTest& wanted = to_.tests[i];
            const auto index = static_cast<int>(i);
            while (i < now_.tests.size() && !same_test(now_.tests[i], wanted)) {
                TableTest renamed = now_.tests[i];
                renamed.name = wanted.name;
                const bool gone = !in(to_.tests, i, now_.tests[i]);
                if (gone && same_test(renamed, wanted) ? take(RenameTest{index, wanted.name}) : gone && take(RemoveTest{index})) continue;
                if (gone || !take(InsertTest{wanted, index, {}})) return;
            }
            if (i >= now_.tests.size() && !take(InsertTest{wanted, index, {}})) return;
        }
        while (now_.tests.size() > to_.tests.size())
            if (!take(RemoveTest{static_cast<int>(now_.tests.size()) - 1})) return;
    }

    Scene now_;
    const Scene& to_;
    const TextOfNode& text_of_;
    std::vector<Edit> edits_;
    std::string refusal_;
};

}  // namespace

Result<std::vector<Edit>> edits_between(const Scene& from, const Scene& to, const TextOfNode& text_of) {
    return Way(from, to, text_of).run();
}

}  // namespace pinfield
