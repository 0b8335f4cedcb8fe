#include "engine/io/yaml_items.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "engine/core/source_text.h"
#include "engine/io/value_writer.h"
#include "engine/io/yaml_text.h"

namespace pinfield {
namespace {

std::string_view slice(std::string_view text, Span span) { return text.substr(span.begin, span.end - span.begin); }
std::size_t column_of(std::string_view text, std::size_t at) { return at - line_begin(text, at); }

bool is_comment_line(std::string_view text, std::size_t begin) {
    const std::size_t content = skip_spaces(text, begin);
    return content < line_end(text, begin) && text[content] == '#';
}

/// End of a node; a text of many lines (|, >) ends with its last one.
std::size_t content_end(std::string_view text, const YamlNode& node) {
    std::size_t end = node.span.end;
    while (end > node.span.begin && (text[end - 1] == '\n' || text[end - 1] == '\r')) --end;
    return end;
}

/// Where an item begins: its dash in a block list, its anchor or first letter between brackets.
std::size_t item_begin(std::string_view text, const YamlNode& list, std::size_t index) {
    const bool block = list.style == YamlStyle::block;
    if (index == 0) return block ? list.span.begin : skip_blank(text, list.span.begin + 1);
    std::size_t at = skip_blank(text, list.items[index - 1]->span.end);
    if (!block && at < text.size() && text[at] == ',') at = skip_blank(text, at + 1);
    return at;
}

/// The lines of a block list's item: from the first comment that belongs to it to the break of its last line.
struct Lines {
    std::size_t begin = 0, dash = 0, end = 0;
};

bool is_deeper(std::string_view text, std::size_t line, std::size_t column) { return column_of(text, skip_spaces(text, line)) > column; }

/// Comments right below an item belong to it when they are indented further than its dash.
std::size_t lines_end(std::string_view text, const YamlNode& list, std::size_t index) {
    const std::size_t column = column_of(text, list.span.begin);
    std::size_t end = next_line(text, content_end(text, *list.items[index]));
    while (end < text.size() && is_comment_line(text, end) && is_deeper(text, end, column)) end = next_line(text, end);
    return end;
}

/// Where the lines of a list can begin: below its key.
std::size_t lines_limit(std::string_view text, const YamlNode& list) {
    if (!list.parent) return 0;
    const auto& around = list.parent->items;
    const auto at = std::find(around.begin(), around.end(), &list) - around.begin();
    return at > 0 ? next_line(text, around[static_cast<std::size_t>(at - 1)]->span.end) : 0;
}

/// Comments above belong to an item when no blank line parts them and they are not indented further than its dash.
Lines lines_of(std::string_view text, const YamlNode& list, std::size_t index) {
    Lines out;
    out.dash = item_begin(text, list, index);
    const std::size_t column = column_of(text, out.dash);
    const std::size_t limit = index > 0 ? lines_end(text, list, index - 1) : lines_limit(text, list);
    out.begin = line_begin(text, out.dash);
    while (out.begin > limit) {
        const std::size_t above = line_begin(text, out.begin - 1);
        if (above < limit || !is_comment_line(text, above) || (index > 0 && is_deeper(text, above, column))) break;
        out.begin = above;
    }
    out.end = lines_end(text, list, index);
    return out;
}

/// Every line moved by `shift` columns (to the left only over blanks), none beyond `least` but the first.
std::string moved_lines(std::string_view lines, std::ptrdiff_t shift, std::size_t least, bool move_first) {
    std::string out;
    for (std::size_t begin = 0; begin < lines.size();) {
        const std::size_t end = next_line(lines, begin), content = std::min(skip_spaces(lines, begin), end);
        const std::string_view rest = lines.substr(content, end - content);
        const bool blank = rest.empty() || rest == "\n" || rest == "\r\n";
        if (begin == 0 && !move_first) {
            out += lines.substr(begin, end - begin);
        } else {
            const std::ptrdiff_t column = static_cast<std::ptrdiff_t>(content - begin) + shift;
            if (!blank) out.append(std::max(least, static_cast<std::size_t>(std::max<std::ptrdiff_t>(column, 0))), ' ');
            out += rest;
        }
        begin = end;
    }
    return out;
}

std::string without_break(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
    return text;
}

/// A scalar as its author wrote it, where that may stand in one line between brackets.
std::string scalar_in_line(std::string_view text, const YamlNode& node) {
    const std::string_view written = slice(text, node.span);
    const bool plain = node.style == YamlStyle::plain;
    const bool fits = written.find('\n') == std::string_view::npos && node.style != YamlStyle::block_text &&
                      (!plain || written.find_first_of(",[]{}") == std::string_view::npos);
    return fits ? std::string(written) : write_text(node.text, plain ? YamlStyle::plain : YamlStyle::double_quoted);
}

/// Everything in one line with the author's own scalars; nothing where an anchor would be lost.
std::optional<std::string> flow_of(std::string_view text, const YamlNode& node) {
    if (node.anchored) return {};
    if (node.kind == YamlKind::alias) return std::string(slice(text, node.span));
    if (node.kind == YamlKind::null) return "{}";
    if (node.kind == YamlKind::scalar) return scalar_in_line(text, node);
    const bool map = node.kind == YamlKind::map;
    std::string out;
    for (std::size_t i = 0; i < node.items.size(); ++i) {
        const std::optional<std::string> item = flow_of(text, *node.items[i]);
        if (!item) return {};
        if (i > 0) out += map && i % 2 == 1 ? ": " : ", ";
        out += *item;
    }
    if (node.style == YamlStyle::pair) return out;
    return map ? fmt::format("{{{}}}", out) : fmt::format("[{}]", out);
}

/// "circle: {...}" of an item that is a map of one entry.
std::optional<std::string> flow_item(std::string_view text, Span whole, const YamlNode& item) {
    if (!comments_in(text, whole, item).empty() || item.anchored) return {};
    if (item.kind == YamlKind::alias) return std::string(slice(text, item.span));
    if (item.kind != YamlKind::map || item.entries() != 1) return flow_of(text, item);
    const YamlNode& value = item.value(0);
    const std::string_view written = slice(text, {item.key(0).span.begin, std::max(item.key(0).span.end, value.span.end)});
    const bool as_it_stands = value.kind == YamlKind::map && value.style == YamlStyle::flow && written.find('\n') == std::string_view::npos;
    if (as_it_stands) return std::string(written);
    const auto key = flow_of(text, item.key(0)), body = flow_of(text, value);
    if (!key || !body) return {};
    return fmt::format("{}: {}", *key, *body);
}

void add_scalars(const YamlNode& node, std::vector<Span>& out) {
    if (node.kind == YamlKind::scalar) out.push_back(node.span);
    for (const YamlNode* item : node.items) add_scalars(*item, out);
}

std::vector<Span> pieces_of(std::string_view text, const YamlNode& list) {
    std::vector<Span> out;
    for (std::size_t i = 0; i < list.items.size(); ++i) out.push_back(item_extent(text, list, i));
    return out;
}

std::size_t after_colon(std::string_view text, const YamlNode& key) { return text.find(':', key.span.end) + 1; }

}  // namespace

std::string copy_in_line(std::string_view text, const YamlNode& node, Aliases aliases) {
    if (node.kind == YamlKind::alias)
        return aliases == Aliases::kept ? std::string(slice(text, node.span)) : copy_in_line(text, *node.target, aliases);
    if (node.kind == YamlKind::null) return "{}";
    if (node.kind == YamlKind::scalar) return scalar_in_line(text, node);
    const bool map = node.kind == YamlKind::map;
    std::string out;
    for (std::size_t i = 0; i < node.items.size(); ++i)
        out += fmt::format("{}{}", i == 0 ? "" : map && i % 2 == 1 ? ": " : ", ", copy_in_line(text, *node.items[i], aliases));
    return map ? fmt::format("{{{}}}", out) : fmt::format("[{}]", out);
}

std::string indented_lines(std::string_view lines, std::size_t column) {
    return moved_lines(lines, static_cast<std::ptrdiff_t>(column), 0, true);
}

std::vector<Span> comments_in(std::string_view text, Span whole, const YamlNode& node) {
    std::vector<Span> scalars, out;
    add_scalars(node, scalars);
    std::size_t next = 0;
    for (std::size_t at = whole.begin; at < whole.end; ++at) {
        while (next < scalars.size() && scalars[next].end <= at) ++next;
        if (next < scalars.size() && scalars[next].begin <= at) {
            at = scalars[next].end - 1;
        } else if (text[at] == '#' && (at == 0 || text[at - 1] == ' ' || text[at - 1] == '\t' || text[at - 1] == '\n')) {
            const std::size_t end = line_end(text, at);
            out.push_back({at, end});
            at = end;
        }
    }
    return out;
}

ListStyle list_style(std::string_view text, const YamlTree& tree) {
    std::map<std::size_t, int> dashes, bodies;
    for (const YamlNode& list : tree.nodes) {
        if (list.kind != YamlKind::sequence || list.style != YamlStyle::block || list.items.empty()) continue;
        const YamlNode* map = list.parent;
        if (!map || map->kind != YamlKind::map || map->style != YamlStyle::block) continue;
        const auto at = static_cast<std::size_t>(std::find(map->items.begin(), map->items.end(), &list) - map->items.begin());
        const std::size_t dash = column_of(text, list.span.begin), key = column_of(text, map->items[at - 1]->span.begin);
        if (dash >= key) ++dashes[dash - key];
        for (const YamlNode* item : list.items) {
            const YamlNode* body = item->kind == YamlKind::map && item->entries() == 1 ? &item->value(0) : nullptr;
            if (!body || body->kind != YamlKind::map || body->style != YamlStyle::block) continue;
            const std::size_t fields = column_of(text, body->span.begin);
            if (fields > dash + 2) ++bodies[fields - dash];
        }
    }
    const auto most = [](const std::map<std::size_t, int>& counts, std::size_t none) {
        const auto found = std::max_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
        return found == counts.end() ? none : found->first;
    };
    return {most(dashes, ListStyle{}.dash), most(bodies, ListStyle{}.body)};
}

Span item_extent(std::string_view text, const YamlNode& list, std::size_t index) {
    if (list.style != YamlStyle::block) return {item_begin(text, list, index), list.items[index]->span.end};
    const Lines lines = lines_of(text, list, index);
    return {lines.begin, lines.end};
}

ItemText item_text(std::string_view text, const YamlNode& list, std::size_t index) {
    const YamlNode& item = *list.items[index];
    if (list.style == YamlStyle::block) {
        const Lines lines = lines_of(text, list, index);
        const auto column = static_cast<std::ptrdiff_t>(column_of(text, lines.dash));
        const std::string block = moved_lines(slice(text, {lines.begin, lines.end}), -column, 0, true);
        return {without_break(block), flow_item(text, {lines.begin, lines.end}, item).value_or("")};
    }
    const Span whole = item_extent(text, list, index);
    // A map of one entry needs no braces after a dash.
    const bool braced = item.kind == YamlKind::map && item.style == YamlStyle::flow && !item.anchored && item.entries() == 1;
    const std::size_t begin = braced ? item.key(0).span.begin : whole.begin;
    const std::size_t end = braced ? std::max(item.key(0).span.end, item.value(0).span.end) : whole.end;
    const std::ptrdiff_t shift = 2 - static_cast<std::ptrdiff_t>(column_of(text, begin));
    return {"- " + moved_lines(slice(text, {begin, end}), shift, 4, false), flow_item(text, whole, item).value_or("")};
}

ItemText item_text(std::string block) {
    const SourceText source("", block);
    const YamlTree tree = read_yaml(source);
    if (!tree.root || tree.root->kind != YamlKind::sequence || tree.root->items.size() != 1) return {std::move(block), ""};
    return item_text(source.text(), *tree.root, 0);
}

std::vector<Splice> remove_item(std::string_view text, const YamlNode& list, std::size_t index) {
    if (list.style != YamlStyle::block) return {remove_flow(text, list.span, pieces_of(text, list), index)};
    const Lines lines = lines_of(text, list, index);
    const std::size_t last = lines.end > lines.begin && text[lines.end - 1] == '\n' ? lines.end - 1 : lines.end;
    Splice removed = remove_lines(text, lines.begin, last);
    if (list.items.size() > 1 || !list.parent || list.parent->kind != YamlKind::map) return {std::move(removed)};
    const auto& around = list.parent->items;
    const auto at = static_cast<std::size_t>(std::find(around.begin(), around.end(), &list) - around.begin());
    const std::size_t colon = after_colon(text, *around[at - 1]);
    return {{{colon, colon}, " []"}, std::move(removed)};
}

std::optional<Splice> insert_item(std::string_view text, const YamlNode& list, std::size_t index, const ItemText& item) {
    if (list.style != YamlStyle::block) {
        if (item.flow.empty()) return {};
        // Braces where the neighbours have them.
        const YamlNode& like = *list.items[std::min(index, list.items.size() - 1)];
        const bool braces = like.kind == YamlKind::map && like.style == YamlStyle::flow && !item.flow.starts_with('*');
        return insert_flow(text, list.span, pieces_of(text, list), index, braces ? fmt::format("{{{}}}", item.flow) : item.flow);
    }
    const std::size_t column = column_of(text, list.span.begin);
    const std::string lines = indented_lines(item.block, column);
    const std::string brk(line_break(text));
    if (index == 0) {
        const std::size_t begin = lines_of(text, list, 0).begin;
        return Splice{{begin, begin}, lines + brk};
    }
    const std::size_t end = lines_end(text, list, index - 1);
    const bool has_break = end > 0 && text[end - 1] == '\n';
    return Splice{{end, end}, has_break ? lines + brk : brk + lines};
}

std::optional<std::vector<Splice>> insert_first_item(std::string_view text, const YamlNode& body, std::string_view key, const ItemText& item,
                                                     ListStyle style) {
    const std::string brk(line_break(text));
    const std::size_t entry = body.entry_of(key);
    if (body.style != YamlStyle::block) {
        if (item.flow.empty()) return {};
        if (entry == body.entries()) return {{insert_entry(text, body, entry, fmt::format("{}: [{}]", key, item.flow))}};
        return {{{body.value(entry).span, fmt::format("[{}]", item.flow)}}};
    }
    if (entry == body.entries())
        return {{insert_entry(text, body, entry, fmt::format("{}:{}{}", key, brk, indented_lines(item.block, style.dash)))}};
    const YamlNode& list = body.value(entry);
    const std::size_t colon = after_colon(text, body.key(entry));
    const std::size_t end = list.kind == YamlKind::null ? colon : list.span.end, below = line_end(text, end);
    if (list.anchored || !comments_in(text, {colon, end}, list).empty()) return {};
    const std::size_t column = column_of(text, body.key(0).span.begin);
    return {{{{colon, end}, ""}, {{below, below}, brk + indented_lines(item.block, column + style.dash)}}};
}

std::optional<std::vector<Splice>> insert_first_item(std::string_view text, const YamlNode& map, std::size_t index, std::string_view key,
                                                     const ItemText& item, ListStyle style) {
    const YamlNode &header = map.key(index), &body = map.value(index);
    const std::string brk(line_break(text));
    const std::size_t entry = body.entry_of(key);
    const YamlNode* list = entry < body.entries() ? &body.value(entry) : nullptr;
    if (list && list->anchored) return {};
    if (body.kind == YamlKind::map && body.style == YamlStyle::block) return insert_first_item(text, body, key, item, style);
    const bool in_block = map.style == YamlStyle::block;
    const std::size_t colon = after_colon(text, header);
    const std::size_t end = body.kind == YamlKind::null ? colon : body.span.end;
    const bool one_line = text.substr(colon, end - colon).find('\n') == std::string_view::npos;
    if (in_block && one_line && !body.anchored) {  // its entries get lines of their own
        const std::size_t column = column_of(text, header.span.begin) + style.body - 2;
        std::string lines;
        for (std::size_t i = 0; i < body.entries(); ++i) {
            if (i == entry) continue;
            const Span piece{body.key(i).span.begin, std::max(body.key(i).span.end, body.value(i).span.end)};
            lines += brk + std::string(column, ' ') + std::string(slice(text, piece));
        }
        lines += fmt::format("{}{}{}:{}{}", brk, std::string(column, ' '), key, brk, indented_lines(item.block, column + style.dash));
        const std::size_t below = line_end(text, end);
        return {{{{colon, end}, ""}, {{below, below}, lines}}};
    }
    if (item.flow.empty()) return {};
    if (list) return {{{{list->span.begin, list->span.end}, fmt::format("[{}]", item.flow)}}};
    const std::string added = fmt::format("{}: [{}]", key, item.flow);
    if (body.is_empty()) return {{insert_body(text, body, added)}};
    return {{insert_entry(text, body, body.entries(), added)}};
}

}  // namespace pinfield
