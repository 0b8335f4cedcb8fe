#include "tests/io/random_table.h"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "engine/core/at.h"
#include "engine/io/value_writer.h"
#include "engine/scene/validate.h"
#include "tests/io/support.h"

namespace pinfield::test {
namespace {

template <class List>
const auto& any_of(const List& list, CounterRng& rng) {
    return list[rng.next_u64() % list.size()];
}

bool chance(CounterRng& rng, double share) { return rng.uniform() < share; }
int below(CounterRng& rng, std::size_t n) { return static_cast<int>(rng.next_u64() % n); }

/// A node of any type, as it is by default.
Subtree some_node(const Scene& scene, CounterRng& rng) {
    const NodeType* type = nullptr;
    while (!type || type->meta.kind == NodeKind::record) type = &any_of(catalog()->types(), rng);
    Scene other(catalog());
    Node& node = other.add(*type);
    for (std::size_t i = 0; i < node.fields.size(); ++i) node.fields[i].is_explicit = type->fields[i].meta.required;
    return scene.with_new_ids(other.copy(node.id));
}

std::vector<NodeId> parents_in(const Scene& scene) {
    std::vector<NodeId> parents{NodeId{}};
    for (const NodeId id : scene.all())
        if (!scene.find(id)->is_record() && scene.find(id)->type->meta.children.max > 0) parents.push_back(id);
    return parents;
}

std::vector<NodeId> nodes_in(const Scene& scene) {
    std::vector<NodeId> nodes;
    for (const NodeId id : scene.all())
        if (!scene.find(id)->is_record()) nodes.push_back(id);
    return nodes;
}

void apply_if_valid(Scene& scene, const Edit& edit) {
    if (!why_invalid(scene, edit)) pinfield::apply(scene, edit);
}

TableTest some_test(const Scene& scene, CounterRng& rng) {
    TableTest test;
    if (chance(rng, 0.5)) test.name = "t" + std::to_string(rng.next_u64() % 20);
    if (chance(rng, 0.5)) test.launches.push_back({Vec2(0.25, 0.5), Vec2(rng.uniform(), 0)});
    test.run = 1 + below(rng, 5);
    test.expectations.push_back({"drained", "<=", 3, "drained <= 3", {}});
    for (const NodeId id : scene.all())
        if (const Node& node = *scene.find(id); !node.is_record() && !node.name.empty() && chance(rng, 0.1))
            test.expectations.push_back({node.name + ".hits", ">=", 1, node.name + ".hits >= 1", {}});
    return test;
}

/// A scene grown by valid edits alone.
Scene random_scene(CounterRng& rng) {
    Scene scene(catalog());
    for (const char* material : {"rubber", "steel", "wood"})
        if (chance(rng, 0.6)) scene.add_material(material);
    for (const char* input : {"left", "right"})
        if (chance(rng, 0.6)) scene.inputs.push_back({input, {chance(rng, 0.5) ? "Z" : "Slash"}});
    const int tests = chance(rng, 0.4) ? 1 + below(rng, 3) : 0;
    for (int i = 0; i < tests; ++i) apply_if_valid(scene, InsertTest{some_test(scene, rng), 0, {}});
    const int nodes = 3 + below(rng, 14);
    for (int i = 0; i < nodes; ++i) {
        const NodeId parent = any_of(parents_in(scene), rng);
        apply_if_valid(scene, Insert{parent, below(rng, scene.children_of(parent).size() + 1), some_node(scene, rng)});
    }
    for (int i = 0; i < nodes / 3; ++i) {
        const NodeId parent = any_of(parents_in(scene), rng);
        const std::size_t count = scene.children_of(parent).size();
        if (count == 0) continue;
        apply_if_valid(scene, Wrap{parent, below(rng, count), 1 + below(rng, 3), some_node(scene, rng).front()});
    }
    for (const NodeId node : nodes_in(scene))
        if (chance(rng, 0.5)) apply_if_valid(scene, Rename{node, "", fmt::format("n{}", below(rng, 40)), true});
    for (int i = 0; i < 3 * nodes; ++i)
        if (const auto edit = some_edit(scene, rng)) apply_if_valid(scene, *edit);
    for (const NodeId node : nodes_in(scene))
        if (!scene.materials().empty() && chance(rng, 0.3)) {
            const auto field = scene.find(node)->type->find_field("material");
            if (field) apply_if_valid(scene, SetField{node, *field, scene.find(any_of(scene.materials(), rng))->name, true});
        }
    return scene;
}

/// Writes scenes in a hand of its own, which it makes up.
class Hand {
public:
    explicit Hand(CounterRng& rng)
        : rng_(rng),
          dash_(any_of(std::array{0, 2, 4}, rng)),
          body_(any_of(std::array{2, 3, 4}, rng)),
          flow_(any_of(std::array{0.1, 0.5, 0.9}, rng)),
          comments_(any_of(std::array{0.0, 0.15, 0.4}, rng)),
          like_(any_of(std::array{"1", "1mm", "1.0cm", "1in"}, rng)) {}

    std::string table(const Scene& scene) {
        std::string out = "pinfield: 1" + behind() + "\n";
        above(out, 0);
        records(out, scene);
        out += "scene:" + behind() + "\n";
        for (const NodeId node : scene.roots()) item(out, scene, node, dash_);
        above(out, 0);
        inputs(out, scene);
        tests(out, scene);
        if (chance(rng_, 0.2)) out.pop_back();
        if (chance(rng_, 0.2)) out = with_crlf(out);
        return chance(rng_, 0.1) ? "\xEF\xBB\xBF" + out : out;
    }

private:
    std::string comment() { return fmt::format("# note {}{}", ++notes_, chance(rng_, 0.3) ? ": ä [b], {c}" : ""); }
    std::string behind() { return chance(rng_, comments_) ? "   " + comment() : ""; }
    void above(std::string& out, int column) {
        if (chance(rng_, 0.3 * comments_)) out += "\n";
        while (chance(rng_, comments_)) out += std::string(static_cast<std::size_t>(column), ' ') + comment() + "\n";
        if (chance(rng_, 0.2 * comments_)) out += "\n";
    }

    void inputs(std::string& out, const Scene& scene) {
        if (scene.inputs.empty()) {
            if (chance(rng_, 0.4)) out += any_of(std::array{"inputs:", "inputs: {}", "inputs: ~"}, rng_) + behind() + "\n";
            return;
        }
        out += "inputs:\n";
        for (const InputBinding& input : scene.inputs) {
            const std::string format = any_of(std::array{"  {}: [{}]", "  {}: {}", "  {}:\n    - {}"}, rng_);
            out += fmt::format(fmt::runtime(format), input.name, input.keys.front()) + behind() + "\n";
        }
    }

    void tests(std::string& out, const Scene& scene) {
        if (scene.tests.empty()) {
            if (chance(rng_, 0.4)) out += any_of(std::array{"tests:", "tests: []", "tests: null"}, rng_) + behind() + "\n";
            return;
        }
        const bool flow = chance(rng_, 0.2);
        out += flow ? "tests: [" : "tests:" + behind() + "\n";
        std::string_view comma;
        for (const TableTest& test : scene.tests) {
            const std::string body = fmt::format("run: {}, expect: [{}]", test.run, test.expectations.front().text);
            const std::string name = test.name.empty() ? "" : fmt::format("name: {}", test.name);
            if (flow) {
                out += fmt::format("{}{{{}{}{}}}", std::exchange(comma, ", "), name, name.empty() ? "" : ", ", body);
                continue;
            }
            above(out, dash_);
            const std::string margin(static_cast<std::size_t>(dash_), ' ');
            if (name.empty() || chance(rng_, 0.5)) out += fmt::format("{}- {{{}{}{}}}", margin, name, name.empty() ? "" : ", ", body) + behind() + "\n";
            else out += fmt::format("{}- {}{}\n{}  expect: {}\n{}  run: {}\n", margin, name, behind(), margin, test.expectations.front().text, margin, test.run);
        }
        if (flow) out += "]" + behind() + "\n";
    }

    static std::string with_crlf(const std::string& text) {
        std::string out;
        for (const char c : text) out += c == '\n' ? std::string("\r\n") : std::string(1, c);
        return out;
    }

    void records(std::string& out, const Scene& scene) {
        if (chance(rng_, 0.5)) out += "table: {name: \"T\"}" + behind() + "\n";
        if (scene.materials().empty()) {
            if (chance(rng_, 0.4)) out += any_of(std::array{"materials:", "materials: {}", "materials: null"}, rng_) + behind() + "\n";
            return;
        }
        out += "materials:" + behind() + "\n";
        for (const NodeId id : scene.materials()) {
            const Node& material = *scene.find(id);
            if (chance(rng_, 0.7)) {
                out += "  " + material.name + ": " + flow_map(scene, material) + behind() + "\n";
                continue;
            }
            out += "  " + material.name + ":" + behind() + "\n";
            fields(out, material, 6);
        }
    }

    /// No table reads without what its nodes require.
    static bool is_said(const Node& node, std::size_t field) { return node.fields[field].is_explicit || node.type->fields[field].meta.required; }

    std::string value(const FieldType& field, const Value& v) {
        const std::string text = write_value(field, v, field.meta.unit == Unit::metre ? like_ : "");
        const bool plain_word = !text.empty() && text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == std::string::npos;
        if (field.kind == FieldKind::boolean || !plain_word || !chance(rng_, 0.3)) return text;
        return chance(rng_, 0.5) ? "'" + text + "'" : "\"" + text + "\"";
    }

    /// With an anchor, or as an alias of one, where another node says the same.
    std::string shared(const FieldType& field, const Value& v) {
        const std::string text = value(field, v);
        if (field.kind == FieldKind::id || text.find('\n') != std::string::npos) return text;
        for (const auto& [anchor, anchored] : anchors_)
            if (anchored == text) return "*" + anchor;
        if (!chance(rng_, 0.02)) return text;
        anchors_.emplace_back(fmt::format("v{}", anchors_.size()), text);
        return "&" + anchors_.back().first + " " + text;
    }

    void fields(std::string& out, const Node& node, int column) {
        for (std::size_t i = 0; i < node.fields.size(); ++i) {
            if (!is_said(node, i)) continue;
            above(out, column);
            const FieldType& field = node.type->fields[i];
            out += std::string(static_cast<std::size_t>(column), ' ') +
                   fmt::format("{}: {}", field.key, shared(field, node.fields[i].value)) + behind() + "\n";
        }
    }

    std::string flow_map(const Scene& scene, const Node& node) {
        const std::string room = chance(rng_, 0.2) ? " " : "";
        std::string out = "{" + room;
        std::string_view comma;
        const auto entry = [&](const std::string& text) { out += fmt::format("{}{}", std::exchange(comma, ", "), text); };
        for (std::size_t i = 0; i < node.fields.size(); ++i)
            if (is_said(node, i))
                entry(fmt::format("{}: {}", node.type->fields[i].key, shared(node.type->fields[i], node.fields[i].value)));
        if (!node.children.empty()) {
            std::string list;
            for (const NodeId child : node.children) list += (list.empty() ? "" : ", ") + flow_item(scene, *scene.find(child));
            entry("children: [" + list + "]");
        }
        return out + (chance(rng_, 0.1) && comma == ", " ? "," : "") + room + "}";
    }

    std::string flow_item(const Scene& scene, const Node& node) {
        const std::string pair = fmt::format("{}: {}", node.type->key(), flow_map(scene, node));
        return chance(rng_, 0.4) ? "{" + pair + "}" : pair;
    }

    void item(std::string& out, const Scene& scene, NodeId id, int column) {
        const Node& node = *scene.find(id);
        const std::string margin(static_cast<std::size_t>(column), ' ');
        above(out, column);
        if (chance(rng_, node.children.empty() ? flow_ : 0.3 * flow_)) {
            out += margin + "- " + flow_item(scene, node) + behind() + "\n";
            return;
        }
        out += margin + "- " + std::string(node.type->key()) + ":" + behind() + "\n";
        const int inner = column + 2 + body_;
        fields(out, node, inner);
        if (node.children.empty()) return;
        out += std::string(static_cast<std::size_t>(inner), ' ') + "children:" + behind() + "\n";
        for (const NodeId child : node.children) item(out, scene, child, inner + dash_);
    }

    CounterRng& rng_;
    int dash_, body_;
    double flow_, comments_;
    std::string_view like_;
    int notes_ = 0;
    std::vector<std::pair<std::string, std::string>> anchors_;
};

std::optional<Edit> some_edit_of_records(const Scene& scene, CounterRng& rng) {
    const std::string name = "m" + std::to_string(rng.next_u64() % 20);
    const std::vector<NodeId>& materials = scene.materials();
    switch (rng.next_u64() % 4) {
        case 0: {
            Scene other(catalog());
            return Insert{{}, below(rng, materials.size() + 1), scene.with_new_ids(other.copy(other.add_material(name).id))};
        }
        case 1:
            if (materials.empty()) return {};
            return Remove{any_of(materials, rng)};
        case 2: {
            if (materials.empty()) return {};
            const NodeId material = any_of(materials, rng);
            return Rename{material, scene.find(material)->name, name, true};
        }
        default:
            if (scene.inputs.empty()) return {};
            return Rename{{}, any_of(scene.inputs, rng).name, name, true};
    }
}

std::optional<Edit> some_edit_of_lists(const Scene& scene, CounterRng& rng) {
    const auto& inputs = scene.inputs;
    const auto& tests = scene.tests;
    const std::vector<std::string> keys = chance(rng, 0.5) ? std::vector<std::string>{"X"} : std::vector<std::string>{"Space", "LeftShift"};
    switch (rng.next_u64() % 6) {
        case 0: return InsertInput{{"i" + std::to_string(rng.next_u64() % 20), keys, {}}, below(rng, inputs.size() + 1)};
        case 1: return inputs.empty() ? std::optional<Edit>() : RemoveInput{below(rng, inputs.size())};
        case 2: return inputs.empty() ? std::optional<Edit>() : SetKeys{below(rng, inputs.size()), keys};
        case 3: return InsertTest{some_test(scene, rng), below(rng, tests.size() + 1), {}};
        case 4: return tests.empty() ? std::optional<Edit>() : RemoveTest{below(rng, tests.size())};
        default: return tests.empty() ? std::optional<Edit>() : RenameTest{below(rng, tests.size()), chance(rng, 0.3) ? "" : "renamed"};
    }
}

std::optional<Edit> some_edit_of_nodes(const Scene& scene, CounterRng& rng) {
    const std::vector<NodeId> nodes = nodes_in(scene);
    if (nodes.empty()) return {};
    const NodeId node = any_of(nodes, rng), parent = any_of(parents_in(scene), rng);
    const std::size_t count = scene.children_of(parent).size();
    switch (rng.next_u64() % 8) {
        case 0:
        case 1: return Move{node, parent, below(rng, count + 1)};
        case 2: {
            Subtree copy = scene.with_new_ids(scene.copy(node));
            for (Node& each : copy) {
                each.name.clear();
                at(each.fields, *each.type->find_field("id")) = {std::string(), false, {}};
            }
            return Insert{parent, below(rng, count + 1), std::move(copy)};
        }
        case 3:
            if (count == 0) return {};
            return Wrap{parent, below(rng, count), 1 + below(rng, 2), some_node(scene, rng).front()};
        case 4: return Unwrap{node};
        case 5: return Rename{node, scene.find(node)->name, "name_" + std::to_string(rng.next_u64() % 50), true};
        case 6: return retyped(scene, node, any_of(catalog()->types(), rng));
        default: return Remove{node};
    }
}

}  // namespace

std::string random_table(CounterRng& rng) {
    const Scene scene = random_scene(rng);
    return Hand(rng).table(scene);
}

std::optional<Edit> some_structural_edit(const Scene& scene, CounterRng& rng) {
    for (int attempt = 0; attempt < 30; ++attempt) {
        std::optional<Edit> edit = chance(rng, 0.15) ? some_edit_of_records(scene, rng)
                                   : chance(rng, 0.1) ? some_edit_of_lists(scene, rng)
                                                      : some_edit_of_nodes(scene, rng);
        if (edit && !why_invalid(scene, *edit)) return edit;
    }
    return {};
}

}  // namespace pinfield::test
