#include "editor/scene_change.h"

#include "engine/core/at.h"
#include "engine/io/same_content.h"

namespace pinfield::editor {

std::vector<SceneChange> changes_between(const Scene& before, const Scene& after) {
    const std::vector<SceneChange> everything{SceneChange{true, {}, 0}};
    const std::vector<NodeId> nodes = after.all();
    if (nodes != before.all()) return everything;
    std::vector<SceneChange> changes;
    Scene adapted = before;  // the earlier scene with the later one's values: all there is where only fields differ
    for (const NodeId id : nodes) {
        Node& node = *adapted.find(id);
        const Node& later = *after.find(id);
        if (node.type != later.type) return everything;
        for (int i = 0; i < static_cast<int>(node.fields.size()); ++i)
            if (!identical(at(node.fields, i).value, at(later.fields, i).value)) changes.push_back({false, id, i});
        node.fields = later.fields;
        node.generator = later.generator;
    }
    adapted.params = after.params;  // nothing but nodes is made of them
    adapted.templates = after.templates;
    if (!same_content(adapted, after)) return everything;
    if (changes.empty()) changes.push_back({false, after.table().id, 0});
    return changes;
}

}  // namespace pinfield::editor
