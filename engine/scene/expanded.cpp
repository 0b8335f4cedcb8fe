#include "engine/scene/expanded.h"

#include <algorithm>
#include <map>
#include <set>

#include "engine/core/at.h"

namespace pinfield {
namespace {

std::vector<NodeId> below(const Scene& scene, NodeId node) {
    std::vector<NodeId> out;
    for (const NodeId id : scene.all())
        if (scene.is_within(id, node)) out.push_back(id);
    return out;
}

void rename_in_tests(Scene& scene, const std::map<std::string, std::string>& ids) {
    for (TableTest& test : scene.tests)
        for (TableTest::Expectation& expectation : test.expectations) {
            const std::size_t dot = expectation.quantity.rfind('.');
            const auto id = dot == std::string::npos ? ids.end() : ids.find(expectation.quantity.substr(0, dot));
            if (id == ids.end()) continue;
            expectation.text.replace(expectation.text.find(id->first), id->first.size(), id->second);
            expectation.quantity.replace(0, dot, id->second);
        }
}

/// Plain ids for those of these nodes that have dots, each unlike all others.
std::map<std::string, std::string> plain_ids(const Scene& scene, const std::vector<NodeId>& nodes) {
    std::set<std::string> taken;
    for (const InputBinding& input : scene.inputs) taken.insert(input.name);
    for (const Param& param : scene.params) taken.insert(param.name);
    for (const NodeId id : scene.all()) taken.insert(scene.find(id)->name);
    std::map<std::string, std::string> out;
    for (const NodeId id : nodes) {
        const std::string& name = scene.find(id)->name;
        if (name.find('.') == std::string::npos) continue;
        std::string plain = name;
        std::replace(plain.begin(), plain.end(), '.', '_');
        while (!taken.insert(plain).second) plain += '_';
        out.emplace(name, plain);
    }
    return out;
}

void write_out(Scene& scene, const std::vector<NodeId>& nodes) {
    const std::map<std::string, std::string> ids = plain_ids(scene, nodes);
    for (const NodeId id : nodes) {
        Node& node = *scene.find(id);
        node.generator.reset();
        for (FieldSlot& slot : node.fields) slot.written.reset();
        const auto plain = ids.find(node.name);
        if (plain == ids.end()) continue;
        node.name = plain->second;
        at(node.fields, *node.type->find_field("id")).value = plain->second;
    }
    rename_in_tests(scene, ids);
}

}  // namespace

Scene expanded(Scene scene) {
    write_out(scene, scene.all());
    scene.includes.clear();
    scene.params.clear();
    scene.templates.clear();
    return scene;
}

Scene expanded(Scene scene, NodeId node) {
    const std::vector<NodeId> nodes = below(scene, node);
    write_out(scene, nodes);
    for (const NodeId id : nodes) scene.find(id)->origin.reset();
    return scene;
}

}  // namespace pinfield
