#include "engine/scene/edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/core/at.h"
#include "engine/core/keys.h"
#include "engine/scene/elsewhere.h"
#include "engine/scene/validate.h"

namespace pinfield {
namespace {

using Reason = std::optional<std::string>;

bool is_id_field(const FieldType& field) { return field.common && field.meta.meaning == Meaning::id; }

Reason gone() { return "the node no longer exists"; }

/// The first expectation of the tests that counts the hits of something that goes by this name.
const TableTest::Expectation* expectation_of(const Scene& scene, const std::string& name) {
    for (const TableTest& test : scene.tests)
        for (const TableTest::Expectation& expectation : test.expectations)
            if (expectation.quantity == name + ".hits") return &expectation;
    return nullptr;
}

Reason why_still_needed(const Scene& scene, const Subtree& nodes) {
    for (const Node& node : nodes)
        if (!node.is_record() && !node.name.empty())
            if (const auto* expectation = expectation_of(scene, node.name))
                return fmt::format("a test of the table expects {}: take that out first", expectation->text);
    return {};
}

/// What a template or copies made has no lines of its own, and children that are made have no list that another could stand in.
Reason why_made(const Scene& scene, NodeId id) {
    const Node* node = scene.find(id);
    if (!node) return {};
    if (!node->origin) return why_elsewhere(scene, scene.path(id), node->key);
    return fmt::format("{} is made by {} ({}): change it there", scene.path(id), node->origin->what, line_in_table(scene, node->origin->where));
}
Reason why_closed(const Scene& scene, NodeId id) {
    if (auto why = why_made(scene, id)) return why;
    const Node* node = scene.find(id);
    if (!node || !node->generator) return {};
    return fmt::format("what is in {} is made by its {}: change it there", scene.path(id), node->generator->is_group ? "template" : "copies");
}

/// Where a node may be put: the parent exists, takes children, and has the place. `leaving`: how many of its children go away first.
Reason why_no_place(const Scene& scene, NodeId parent, int index, int leaving) {
    if (parent && !scene.find(parent)) return "the node to put it into no longer exists";
    if (parent && scene.find(parent)->type->meta.children.max == 0)
        return fmt::format("{} takes no children", scene.find(parent)->type->key());
    const int count = static_cast<int>(scene.children_of(parent).size()) - leaving;
    if (index < 0 || index > count) return "there is no such place among the children";
    return why_before_included(index, included_children(scene, parent));
}

/// A number that is written as an expression is changed where the expression stands: an edit would flatten it.
Reason why_fixed(const Scene& scene, const FieldType& field, const FieldSlot& slot) {
    const std::string line = slot.where ? fmt::format(" in {}", line_in_table(scene, slot.where)) : "";
    return fmt::format("{} is written as `{}`{}: change it in the text", field.key, slot.written->front().text, line);
}

// What stands against each edit before its outcome is looked at.

Reason why_impossible(const Scene& scene, const Insert& edit) {
    if (auto why = why_closed(scene, edit.parent)) return why;
    if (edit.nodes.empty()) return "there is nothing to insert";
    for (const Node& node : edit.nodes)
        if (!node.id || scene.find(node.id)) return "a node to insert is in the scene already";
    if (!edit.nodes.front().is_record()) return why_no_place(scene, edit.parent, edit.index, 0);
    if (edit.index < 0 || edit.index > static_cast<int>(scene.materials().size())) return "there is no such place among the materials";
    return why_before_included(edit.index, included_materials(scene));
}

Reason why_impossible(const Scene& scene, const Remove& edit) {
    const Node* node = scene.find(edit.node);
    if (!node) return gone();
    if (node->is_record() && node->name.empty()) return fmt::format("{} cannot be removed", node->type->key());
    if (auto why = why_made(scene, edit.node)) return why;
    return why_still_needed(scene, scene.copy(edit.node));
}

Reason why_impossible(const Scene& scene, const Move& edit) {
    const Node* node = scene.find(edit.node);
    if (!node || node->is_record()) return gone();
    if (auto why = why_made(scene, edit.node)) return why;
    if (auto why = why_closed(scene, edit.parent)) return why;
    if (edit.parent && scene.find(edit.parent) && scene.is_within(edit.parent, edit.node)) return "a node cannot be put into itself";
    return why_no_place(scene, edit.parent, edit.index, node->parent == edit.parent ? 1 : 0);
}

Reason why_impossible(const Scene& scene, const Wrap& edit) {
    if (edit.parent && !scene.find(edit.parent)) return gone();
    if (auto why = why_closed(scene, edit.parent)) return why;
    const int count = static_cast<int>(scene.children_of(edit.parent).size());
    if (edit.first < 0 || edit.count < 1 || edit.first + edit.count > count) return "there are no such children";
    if (edit.first < included_children(scene, edit.parent)) return why_made(scene, at(scene.children_of(edit.parent), edit.first));
    if (!edit.wrapper.id || scene.find(edit.wrapper.id)) return "the node to wrap them in is in the scene already";
    if (edit.wrapper.type->meta.children.max == 0) return fmt::format("{} takes no children", edit.wrapper.type->key());
    return {};
}

Reason why_impossible(const Scene& scene, const Unwrap& edit) {
    const Node* node = scene.find(edit.node);
    if (!node || node->is_record()) return gone();
    if (auto why = why_closed(scene, edit.node)) return why;
    if (node->children.empty()) return fmt::format("{} holds nothing", scene.path(edit.node));
    return why_still_needed(scene, {*node});
}

Reason why_impossible(const Scene& scene, const Retype& edit) {
    const Node* node = scene.find(edit.node);
    if (!node || node->is_record()) return gone();
    if (auto why = why_closed(scene, edit.node)) return why;
    if (edit.type->meta.kind == NodeKind::record || edit.fields.size() != edit.type->fields.size()) return "a node cannot become that";
    for (std::size_t i = 0; i < edit.fields.size(); ++i) {
        const FieldType& field = edit.type->fields[i];
        if (field.meta.required && !edit.fields[i].is_explicit) return fmt::format("{} needs {}", edit.type->key(), field.key);
        if (const auto why = why_invalid(field, edit.fields[i].value)) return fmt::format("{} {}", field.key, *why);
    }
    return {};
}

Reason why_impossible(const Scene& scene, const Rename& edit) {
    if (!edit.node) {
        const auto& inputs = scene.inputs;
        if (std::none_of(inputs.begin(), inputs.end(), [&](const InputBinding& input) { return input.name == edit.from; }))
            return fmt::format("no input is called {}", edit.from);
        for (const InputBinding& input : inputs)
            if (auto why = input.name == edit.from ? why_elsewhere(scene, input.name, input.where) : std::nullopt) return why;
    } else if (!scene.find(edit.node) || scene.find(edit.node)->name != edit.from) {
        return gone();
    }
    if (edit.from == edit.to) return {};
    if (edit.node) {
        if (auto why = why_made(scene, edit.node)) return why;
        if (scene.find(edit.node)->generator && (edit.from.empty() || edit.to.empty()))
            return fmt::format("what is in {} goes by its id: change it in the text", scene.path(edit.node));
    }
    const bool is_material = edit.node && scene.find(edit.node)->is_record();
    if (is_material || !edit.node) {
        if (auto why = why_named_elsewhere(scene, edit.from, is_material ? Meaning::material : Meaning::input)) return why;
        if (!is_name(edit.to)) return fmt::format("{} is not a valid id: use small letters, digits and _", edit.to);
    } else if (edit.to.empty()) {
        return why_still_needed(scene, {*scene.find(edit.node)});
    } else if (const Node& node = *scene.find(edit.node); auto why = why_invalid(at(node.type->fields, *node.type->find_field("id")), edit.to)) {
        return fmt::format("{} {}", edit.to, *why);
    }
    if (!is_material) return is_id_taken(scene, edit.to, edit.node) ? Reason(taken_id(edit.to)) : std::nullopt;
    for (const NodeId id : scene.materials())
        if (scene.find(id)->name == edit.to) return fmt::format("there is a material {} already", edit.to);
    return {};
}

bool is_in(int index, std::size_t count) { return index >= 0 && index < static_cast<int>(count); }

Reason no_such(std::string_view what) { return fmt::format("there is no such {}", what); }

Reason why_no_keys(const std::vector<std::string>& keys) {
    if (keys.empty()) return "an input needs a key";
    for (const std::string& key : keys)
        if (key_code(key) < 0) return fmt::format("no key of a keyboard is called {}", key);
    return {};
}

/// The first field that refers to an input, as "bat: input".
Reason user_of_input(const Scene& scene, const std::string& input) {
    for (const NodeId id : scene.all()) {
        const Node& node = *scene.find(id);
        for (std::size_t i = 0; i < node.fields.size(); ++i)
            if (node.type->fields[i].meta.meaning == Meaning::input && !identical(renamed(node.fields[i].value, input, ""), node.fields[i].value))
                return fmt::format("{} is moved by {}", scene.path(id), input);
    }
    for (const TableTest& test : scene.tests)
        if (std::any_of(test.inputs.begin(), test.inputs.end(), [&](const TableTest::Hand& hand) { return hand.input == input; }))
            return fmt::format("{} presses {}", test.name.empty() ? "a test" : "the test " + test.name, input);
    return {};
}

Reason why_impossible(const Scene& scene, const InsertInput& edit) {
    if (edit.index < 0 || edit.index > static_cast<int>(scene.inputs.size())) return no_such("place among the inputs");
    if (!is_name(edit.input.name)) return fmt::format("{} is not a valid id: use small letters, digits and _", edit.input.name);
    if (is_id_taken(scene, edit.input.name, {})) return taken_id(edit.input.name);
    if (auto why = why_before_included(edit.index, included_inputs(scene))) return why;
    return why_no_keys(edit.input.keys);
}

Reason why_impossible(const Scene& scene, const RemoveInput& edit) {
    if (!is_in(edit.index, scene.inputs.size())) return no_such("input");
    const InputBinding& input = at(scene.inputs, edit.index);
    if (auto why = why_elsewhere(scene, input.name, input.where)) return why;
    return user_of_input(scene, input.name);
}

Reason why_impossible(const Scene& scene, const SetKeys& edit) {
    if (!is_in(edit.index, scene.inputs.size())) return no_such("input");
    const InputBinding& input = at(scene.inputs, edit.index);
    if (auto why = why_elsewhere(scene, input.name, input.where)) return why;
    return why_no_keys(edit.keys);
}

Reason why_impossible(const Scene& scene, const InsertTest& edit) {
    if (edit.index < 0 || edit.index > static_cast<int>(scene.tests.size())) return no_such("place among the tests");
    if (edit.test.expectations.empty()) return "a test needs something to expect";
    for (const TableTest::Hand& hand : edit.test.inputs)
        if (std::none_of(scene.inputs.begin(), scene.inputs.end(), [&](const InputBinding& input) { return input.name == hand.input; }))
            return fmt::format("no input is called {}", hand.input);
    for (const TableTest::Expectation& expectation : edit.test.expectations) {
        const std::string& what = expectation.quantity;
        const bool counted = what == "escaped" || what == "drained";
        const Node* node = what.ends_with(".hits") ? scene.find(std::string_view(what).substr(0, what.size() - 5)) : nullptr;
        if (!counted && (!node || node->is_record())) return fmt::format("nothing called {} is measured", what);
    }
    return {};
}

Reason why_impossible(const Scene& scene, const RemoveTest& edit) { return is_in(edit.index, scene.tests.size()) ? Reason() : no_such("test"); }
Reason why_impossible(const Scene& scene, const RenameTest& edit) { return is_in(edit.index, scene.tests.size()) ? Reason() : no_such("test"); }

/// Every field of the scene that refers to a name of this sort takes another in its place.
void follow_name(Scene& scene, Meaning sort, const std::string& from, const std::string& to) {
    for (const NodeId id : scene.all()) {
        Node& node = *scene.find(id);
        for (std::size_t i = 0; i < node.fields.size(); ++i)
            if (node.type->fields[i].meta.meaning == sort) node.fields[i].value = renamed(node.fields[i].value, from, to);
    }
}

void follow_input_in_tests(Scene& scene, const std::string& from, const std::string& to) {
    for (TableTest& test : scene.tests)
        for (TableTest::Hand& hand : test.inputs)
            if (hand.input == from) hand.input = to;
}

/// What is measured of a node, or of what is made in it.
void follow_in_tests(Scene& scene, const std::string& from, const std::string& to) {
    for (TableTest& test : scene.tests)
        for (TableTest::Expectation& expectation : test.expectations)
            if (expectation.quantity.starts_with(from + ".")) {
                expectation.quantity.replace(0, from.size(), to);
                expectation.text.replace(expectation.text.find(from), from.size(), to);
            }
}

/// What is made in a node goes by the node's id.
void follow_in_children(Scene& scene, const Node& node, const std::string& from, const std::string& to) {
    for (const NodeId id : node.children) {
        Node& child = *scene.find(id);
        if (child.origin && child.name.starts_with(from + ".")) {
            child.name.replace(0, from.size(), to);
            at(child.fields, *child.type->find_field("id")).value = child.name;
        }
        follow_in_children(scene, child, from, to);
    }
}

// Each edit applied; what it returns takes it back.

Edit done(Scene& scene, const SetField& edit) { return apply(scene, edit); }

Edit done(Scene& scene, const Insert& edit) {
    scene.put(edit.nodes, edit.parent, edit.index);
    return Remove{edit.nodes.front().id};
}

Edit done(Scene& scene, const Remove& edit) {
    const NodeId parent = scene.find(edit.node)->parent;
    const int index = scene.index_of(edit.node);
    return Insert{parent, index, scene.take(edit.node)};
}

Edit done(Scene& scene, const Move& edit) {
    const Move back{edit.node, scene.find(edit.node)->parent, scene.index_of(edit.node)};
    scene.put(scene.take(edit.node), edit.parent, edit.index);
    return back;
}

Edit done(Scene& scene, const Wrap& edit) {
    Node wrapper = edit.wrapper;
    wrapper.children.clear();
    scene.put({wrapper}, edit.parent, edit.first);
    for (int i = 0; i < edit.count; ++i) {
        const NodeId child = at(scene.children_of(edit.parent), edit.first + 1);
        scene.put(scene.take(child), wrapper.id, i);
    }
    return Unwrap{wrapper.id};
}

Edit done(Scene& scene, const Unwrap& edit) {
    const std::vector<NodeId> children = scene.find(edit.node)->children;
    const NodeId parent = scene.find(edit.node)->parent;
    const int first = scene.index_of(edit.node);
    for (int i = 0; i < static_cast<int>(children.size()); ++i) scene.put(scene.take(at(children, i)), parent, first + 1 + i);
    Subtree wrapper = scene.take(edit.node);
    return Wrap{parent, first, static_cast<int>(children.size()), std::move(wrapper.front())};
}

Edit done(Scene& scene, const Retype& edit) {
    Node& node = *scene.find(edit.node);
    return Retype{edit.node, std::exchange(node.type, edit.type), std::exchange(node.fields, edit.fields)};
}

Edit done(Scene& scene, const Rename& edit) {
    Rename back{edit.node, edit.to, edit.from, edit.is_explicit};
    if (!edit.node) {
        for (InputBinding& input : scene.inputs)
            if (input.name == edit.from) input.name = edit.to;
        follow_name(scene, Meaning::input, edit.from, edit.to);
        follow_input_in_tests(scene, edit.from, edit.to);
        return back;
    }
    Node& node = *scene.find(edit.node);
    node.name = edit.to;
    if (node.is_record()) {
        follow_name(scene, Meaning::material, edit.from, edit.to);
        return back;
    }
    FieldSlot& id = at(node.fields, *node.type->find_field("id"));
    id.value = edit.to;
    back.is_explicit = std::exchange(id.is_explicit, edit.is_explicit);
    if (!edit.from.empty()) {
        follow_in_tests(scene, edit.from, edit.to);
        follow_in_children(scene, node, edit.from, edit.to);
    }
    return back;
}

Edit done(Scene& scene, const InsertInput& edit) {
    scene.inputs.insert(scene.inputs.begin() + edit.index, edit.input);
    return RemoveInput{edit.index};
}

Edit done(Scene& scene, const RemoveInput& edit) {
    InsertInput back{at(scene.inputs, edit.index), edit.index};
    scene.inputs.erase(scene.inputs.begin() + edit.index);
    return back;
}

Edit done(Scene& scene, const SetKeys& edit) { return SetKeys{edit.index, std::exchange(at(scene.inputs, edit.index).keys, edit.keys)}; }

Edit done(Scene& scene, const InsertTest& edit) {
    scene.tests.insert(scene.tests.begin() + edit.index, edit.test);
    return RemoveTest{edit.index};
}

Edit done(Scene& scene, const RemoveTest& edit) {
    InsertTest back{at(scene.tests, edit.index), edit.index, {}};
    scene.tests.erase(scene.tests.begin() + edit.index);
    return back;
}

Edit done(Scene& scene, const RenameTest& edit) { return RenameTest{edit.index, std::exchange(at(scene.tests, edit.index).name, edit.name)}; }

}  // namespace

Reason why_invalid(const Scene& scene, const SetField& edit) {
    const Node* node = scene.find(edit.node);
    if (!node) return gone();
    if (edit.field < 0 || edit.field >= static_cast<int>(node->fields.size())) return "the node has no such field";
    if (auto why = why_made(scene, edit.node)) return why;
    const FieldType& field = at(node->type->fields, edit.field);
    if (node->generator && (is_id_field(field) || !node->generator->is_group))
        return fmt::format("{} is more than one node: change its {} in the text", scene.path(edit.node), field.key);
    if (const FieldSlot& slot = at(node->fields, edit.field); slot.written) return why_fixed(scene, field, slot);
    if (auto why = why_invalid(field, edit.value)) return fmt::format("{} {}", field.key, *why);
    if (is_id_field(field)) {
        const auto& id = std::get<std::string>(edit.value);
        if (!id.empty() && is_id_taken(scene, id, edit.node)) return taken_id(id);
    }
    Node changed = *node;
    at(changed.fields, edit.field).value = edit.value;
    Diagnostics findings;
    check_references(KnownNames(scene), field, at(changed.fields, edit.field), 1, findings);
    if (auto broken = broken_contract(changed)) findings.push_back(std::move(*broken));
    if (!findings.empty()) return findings.front().message;
    return {};
}

Reason why_invalid(const Scene& scene, const Edit& edit) {
    if (const auto* field = std::get_if<SetField>(&edit)) return why_invalid(scene, *field);
    Reason why = std::visit(
        [&](const auto& e) -> Reason {
            if constexpr (std::is_same_v<std::decay_t<decltype(e)>, SetField>) return {};
            else return why_impossible(scene, e);
        },
        edit);
    if (why) return why;
    Scene after = scene;
    std::visit([&](const auto& e) { done(after, e); }, edit);
    for (const Diagnostic& found : validate(after))
        if (found.severity == Severity::error) return found.message;
    return {};
}

Value renamed(Value value, const std::string& from, const std::string& to) {
    if (auto* name = std::get_if<std::string>(&value); name && *name == from) *name = to;
    if (auto* names = std::get_if<std::vector<std::string>>(&value)) std::replace(names->begin(), names->end(), from, to);
    return value;
}

SetField apply(Scene& scene, const SetField& edit) {
    assert(!why_invalid(scene, edit) && "apply() takes edits that why_invalid() lets pass");
    Node& node = *scene.find(edit.node);
    FieldSlot& slot = at(node.fields, edit.field);
    SetField inverse{edit.node, edit.field, std::move(slot.value), slot.is_explicit};
    slot.value = edit.value;
    slot.is_explicit = edit.is_explicit;
    if (is_id_field(at(node.type->fields, edit.field))) node.name = std::get<std::string>(edit.value);
    return inverse;
}

Edit apply(Scene& scene, const Edit& edit) {
    assert(!why_invalid(scene, edit) && "apply() takes edits that why_invalid() lets pass");
    return std::visit([&](const auto& e) { return done(scene, e); }, edit);
}

Retype retyped(const Scene& scene, NodeId id, const NodeType& type) {
    const Node& node = *scene.find(id);
    Retype out{id, &type, {}};
    for (const FieldType& field : type.fields) {
        FieldSlot slot{field.initial, false, {}};
        if (const auto same = node.type->find_field(field.key)) {
            const FieldSlot& old = at(node.fields, *same);
            if (old.is_explicit && !why_invalid(field, old.value)) slot = old;
        }
        out.fields.push_back(std::move(slot));
    }
    return out;
}

}  // namespace pinfield
