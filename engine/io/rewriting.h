// The author's text while an edit of its structure changes it, a step at a time.
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/io/node_writer.h"
#include "engine/io/table_reader.h"
#include "engine/io/text_patch.h"
#include "engine/io/yaml_items.h"

namespace pinfield {

/// Child of the top level, child of that child ...: where a node is, whatever it is called.
using Indices = std::vector<int>;
/// In the table's own text: what it includes, which comes before, is not counted, and has an index below 0.
Indices indices_of(const Scene& scene, NodeId node);
/// Of a child of `parent`, likewise.
int index_in_text(const Scene& scene, NodeId parent, int index);

/// Where the list of a node's children stands, or would stand.
struct Children {
    const YamlNode* owner = nullptr;  ///< the map one of whose entries is the node; null: the root of the file
    std::size_t entry = 0;
    const YamlNode* body = nullptr;  ///< the node's fields
    const YamlNode* list = nullptr;  ///< null: there is none
};

class Rewriting {
public:
    explicit Rewriting(const Reading& now) : now_(now), source_(now.scene.sources.shared_main()), tree_(now.tree) {}

    const Reading& now() const { return now_; }  ///< as it was before the first change
    const std::string& text() const { return source_->text(); }
    const YamlNode& root() const { return *tree_->root; }
    const YamlTree& tree() const { return *tree_; }
    std::vector<TextPatch> patches() && { return std::move(patches_); }

    /// Splices of the text as it is, in its order. Fails where they make it no YAML.
    Result<void> write(std::vector<Splice> splices);
    Result<Children> children_of(const Indices& node) const;
    Result<ItemText> item(const Indices& parent, int index) const;
    Result<void> insert(const Indices& parent, int index, ItemText item);
    Result<void> remove(const Indices& parent, int index);
    NodeStyle style(const Node* beside) const;
    /// Lines of other files end as those of this one do.
    std::string with_breaks(const std::string& lines) const;

private:
    const Reading& now_;
    std::shared_ptr<const SourceText> source_;
    std::shared_ptr<const YamlTree> tree_;
    std::vector<TextPatch> patches_;
};

}  // namespace pinfield
