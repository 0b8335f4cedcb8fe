// The author's YAML as a light tree that knows where every byte of it stands: the reader gives it meaning, the patcher
// edits by it.
#pragma once
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/diagnostic.h"
#include "engine/io/limits.h"

namespace pinfield {

enum class YamlKind : unsigned char { null, scalar, sequence, map, alias };
/// `pair` is a map of one entry in a flow sequence without braces of its own: [circle: {...}].
enum class YamlStyle : unsigned char { plain, single_quoted, double_quoted, block_text, flow, block, pair };

/// Scalars stay raw text until a field gives them a type. Spans leave out anchors, trailing blanks and comments.
struct YamlNode {
    YamlKind kind = YamlKind::null;
    YamlStyle style = YamlStyle::plain;
    bool anchored = false;
    std::uint32_t references = 0;  ///< aliases of this node
    std::uint32_t height = 1;      ///< of the subtree, aliases expanded
    std::uint64_t weight = 1;      ///< nodes in the subtree, aliases expanded
    Span span;                     ///< a missing value has an empty span where it would stand
    std::string_view text;         ///< of a scalar, unquoted and unescaped; of an alias, its name
    std::vector<YamlNode*> items;  ///< of a sequence; of a map: key, value, key, value ...
    YamlNode* parent = nullptr;
    YamlNode* target = nullptr;  ///< of an alias

    const YamlNode& resolved() const { return target ? *target : *this; }
    /// Nothing, ~ or null: what YAML calls no value.
    bool is_empty() const;
    std::size_t entries() const { return items.size() / 2; }
    const YamlNode& key(std::size_t i) const { return *items[2 * i]; }
    /// Value of entry i as it stands in the text: perhaps an alias.
    const YamlNode& value(std::size_t i) const { return *items[2 * i + 1]; }
    /// Index of the first entry with this key, or entries().
    std::size_t entry_of(std::string_view key) const;
    /// Value (resolved) of the first entry with this key, or null.
    const YamlNode* find(std::string_view key) const;
};

struct YamlTree {
    std::deque<YamlNode> nodes;      ///< addresses are stable
    std::deque<std::string> texts;   ///< scalars that the source does not hold letter by letter
    const YamlNode* root = nullptr;  ///< null when the text could not be read to its end
    Diagnostics diagnostics;
};

/// The node of exactly these bytes; null: there is none.
const YamlNode* node_at(const YamlTree& tree, Span span);

/// What is said in place of the findings beyond Limits::errors.
inline constexpr std::string_view more_errors_follow = "more errors follow; mend these first";

/// Reads one document; the tree refers to the source's text, which must outlive it. Never throws; never recurses deeper
/// than the limits let it.
YamlTree read_yaml(const SourceText& source, const Limits& limits = {});

}  // namespace pinfield
