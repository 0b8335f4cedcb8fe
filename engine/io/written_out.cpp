// What a maker made written out in its place.
#include <fmt/format.h>

#include <algorithm>

#include "engine/core/at.h"
#include "engine/io/field_patch.h"
#include "engine/io/rewriting.h"
#include "engine/io/same_content.h"
#include "engine/io/value_home.h"
#include "engine/scene/expanded.h"

namespace pinfield {
namespace {

/// Where the entries of the nodes written out stand, their defaults are left out.
void leave_out_defaults(Scene& scene, NodeId maker) {
    for (const NodeId id : scene.all()) {
        if (!scene.is_within(id, maker)) continue;
        Node& node = *scene.find(id);
        for (std::size_t i = 0; i < node.fields.size(); ++i)
            node.fields[i].is_explicit = node.type->fields[i].meta.required || !identical(node.fields[i].value, node.type->fields[i].initial);
    }
}

std::size_t column_of(const std::string& text, std::size_t at) {
    const std::size_t line = text.rfind('\n', at == 0 ? 0 : at - 1);
    return at - (line == std::string::npos ? 0 : line + 1);
}

/// The item's text in place of what stood from its key on; comments within go below its first line.
Splice item_splice(const Rewriting& rewriting, const YamlNode& list, const YamlNode& item, const std::string& block) {
    const std::string& text = rewriting.text();
    if (list.style == YamlStyle::flow) return {item.span, item_text(block).flow};
    const std::size_t key = column_of(text, item.span.begin), margin = key - std::min<std::size_t>(key, 2);
    std::string lines = indented_lines(block, margin).substr(margin + 2);
    const std::vector<Span> comments = comments_in(text, item.span, item);
    if (!comments.empty()) {
        std::string between;
        for (const Span& comment : comments) between += fmt::format("\n{:{}}{}", "", margin + 4, text.substr(comment.begin, comment.end - comment.begin));
        lines.insert(std::min(lines.find('\n'), lines.size()), between);
    }
    return {item.span, rewriting.with_breaks(lines)};
}

/// Where a test names what was renamed. `renamed` has the tests of `now`, with the names that they get.
std::vector<Splice> test_splices(const Reading& now, const Scene& renamed) {
    std::vector<Splice> out;
    for (std::size_t t = 0; t < now.scene.tests.size(); ++t)
        for (std::size_t e = 0; e < now.scene.tests[t].expectations.size(); ++e) {
            const TableTest::Expectation &was = now.scene.tests[t].expectations[e], &is = renamed.tests[t].expectations[e];
            if (was.quantity == is.quantity) continue;
            const std::size_t found = now.scene.sources.slice(was.where).find(was.quantity);
            if (found == std::string_view::npos) continue;  // the proof says so
            const std::size_t begin = was.where.span.begin + found;
            out.push_back({{begin, begin + was.quantity.size()}, is.quantity});
        }
    return out;
}

}  // namespace

Result<PatchedText> patch_written_out(const Reading& now, NodeId node, const Limits& limits) {
    const Node* maker = maker_of(now.scene, node);
    if (!maker) return failure("nothing made this node");
    Scene expected = expanded(now.scene, maker->id);
    leave_out_defaults(expected, maker->id);

    Rewriting rewriting(now);
    Indices where = indices_of(now.scene, maker->id);
    const int index = where.back();
    where.pop_back();
    const Result<Children> children = rewriting.children_of(where);
    if (!children) return tl::unexpected(children.error());
    if (!children->list || index >= static_cast<int>(children->list->items.size())) return failure("the text does not hold the node");
    const YamlNode& item = *at(children->list->items, index);
    if (const YamlNode* shared = shared_below(item)) return tl::unexpected(shared_failure(*shared));

    const NodeStyle style{list_style(rewriting.text(), rewriting.tree()), {}};
    std::vector<Splice> splices = test_splices(now, expected);
    splices.push_back(item_splice(rewriting, *children->list, item, write_item(expected.copy(maker->id), style)));
    std::sort(splices.begin(), splices.end(), [](const Splice& a, const Splice& b) { return a.replaced.begin < b.replaced.begin; });
    if (const auto written = rewriting.write(std::move(splices)); !written) return tl::unexpected(written.error());

    PatchedText out{{}, read_again(now, rewriting.text(), limits), 1};
    for (const Diagnostic& d : out.reading.diagnostics)
        if (d.severity == Severity::error) return failure(d.message);
    if (!same_content(out.reading.scene, expected)) return failure("the table would become another one");
    out.reading.scene.take_ids_of(expected);
    out.patches = std::move(rewriting).patches();
    return out;
}

}  // namespace pinfield
