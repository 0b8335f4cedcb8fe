#include "engine/io/section_patch.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/core/at.h"
#include "engine/io/field_patch.h"
#include "engine/io/node_writer.h"
#include "engine/io/section.h"
#include "engine/io/value_writer.h"
#include "engine/io/yaml_text.h"
#include "engine/scene/elsewhere.h"

namespace pinfield {
namespace {

/// Where a section that the text has not stands among those it has, in the order in which tables are written.
std::size_t index_of_new_section(const YamlNode& root, std::string_view key) {
    std::size_t index = 0;
    for (const Section* before : all_sections()) {
        if (before->key == key) break;
        if (const std::size_t at = root.entry_of(before->key); at < root.entries()) index = std::max(index, at + 1);
    }
    return index;
}

/// Comments below the section before that are indented belong to it.
Splice new_lines(std::string_view text, const YamlNode& root, std::size_t index, const std::string& lines) {
    if (index == 0) return insert_entry(text, root, 0, lines);
    const YamlNode &key = root.key(index - 1), &value = root.value(index - 1);
    std::size_t last = std::max(key.span.end, value.span.end);
    while (last > key.span.end && (text[last - 1] == '\n' || text[last - 1] == '\r'))
        --last;  // a text of many lines ends with its last one
    std::size_t end = next_line(text, last);
    for (std::size_t content = skip_spaces(text, end); end < text.size() && content > end && text[content] == '#';
         content = skip_spaces(text, end))
        end = next_line(text, end);
    const std::string brk(line_break(text));
    const bool has_break = end > 0 && text[end - 1] == '\n';
    return {{end, end}, has_break ? lines + brk : brk + lines};
}

/// The section as the text holds it; null where it does not. Fails where an alias repeats it.
Result<const YamlNode*> section_of(const Rewriting& text, std::string_view key) {
    const std::size_t entry = text.root().entry_of(key);
    if (entry == text.root().entries()) return nullptr;
    const YamlNode& section = text.root().value(entry);
    if (section.target || section.references > 0) return tl::unexpected(shared_failure(section));
    return &section;
}

/// Below a key whose value says nothing, or an empty map or list in one line: its first entry, as lines of their own. Nothing where a
/// comment or an anchor would be lost.
std::optional<std::vector<Splice>> first_lines(std::string_view text, const YamlNode& key, const YamlNode& value,
                                               const std::string& lines) {
    const std::size_t colon = text.find(':', key.span.end) + 1;
    const std::size_t end = value.kind == YamlKind::null ? colon : value.span.end, below = line_end(text, end);
    const bool one_line = text.substr(colon, end - colon).find('\n') == std::string_view::npos;
    if (!one_line || value.anchored || !comments_in(text, {colon, end}, value).empty()) return {};
    return {{{{colon, end}, ""}, {{below, below}, std::string(line_break(text)) + lines}}};
}

/// Puts "name: ..." into a section that is a map.
Result<void> insert_into_map(Rewriting& text, std::string_view key, int index, const std::string& entry) {
    const auto section = section_of(text, key);
    if (!section) return tl::unexpected(section.error());
    const YamlNode& root = text.root();
    const std::string brk(line_break(text.text()));
    const bool block = root.style == YamlStyle::block;
    if (!*section) {
        const std::size_t at = index_of_new_section(root, key);
        if (!block) return text.write({insert_entry(text.text(), root, at, fmt::format("{}: {{{}}}", key, entry))});
        return text.write({new_lines(text.text(), root, at, fmt::format("{}:{}{}", key, brk, indented_lines(entry, 2)))});
    }
    const YamlNode& map = **section;
    if (map.kind == YamlKind::map && map.entries() > 0)
        return text.write({insert_entry(text.text(), map, static_cast<std::size_t>(index), entry)});
    if (block)
        if (auto splices = first_lines(text.text(), root.key(root.entry_of(key)), map, indented_lines(entry, 2)))
            return text.write(std::move(*splices));
    if (map.is_empty()) return text.write({insert_body(text.text(), map, entry)});
    return text.write({insert_entry(text.text(), map, 0, entry)});
}

/// A list's or map's section that holds entry `index`.
Result<const YamlNode*> section_with(const Rewriting& text, std::string_view key, std::size_t index) {
    const auto section = section_of(text, key);
    if (!section) return section;
    const YamlNode* found = *section;
    const std::size_t count = !found ? 0 : found->kind == YamlKind::map ? found->entries() : found->items.size();
    if (index >= count) return failure(fmt::format("the text does not hold it among its {}", key));
    return found;
}

/// A test's own map.
Result<const YamlNode*> test_at(const Rewriting& text, int index) {
    const auto list = section_with(text, "tests", static_cast<std::size_t>(index));
    if (!list) return list;
    const YamlNode& test = *at((*list)->items, index);
    if (const YamlNode* shared = test.target || test.references > 0 ? &test : nullptr) return tl::unexpected(shared_failure(*shared));
    return &test;
}

}  // namespace

Result<void> insert_material(Rewriting& text, const Node& material, int index) {
    return insert_into_map(text, "materials", index,
                           fmt::format("{}: {}", material.name, flow_map(explicit_entries(material, text.style(nullptr)))));
}

Result<void> insert_param(Rewriting& text, int index, const std::string& entry) { return insert_into_map(text, "params", index, entry); }

Result<void> insert_template(Rewriting& text, const std::string& lines) {
    const auto section = section_of(text, "templates");
    if (!section) return tl::unexpected(section.error());
    const bool lines_of_its_own = text.root().style == YamlStyle::block && (!*section || (*section)->style != YamlStyle::flow);
    if (!lines_of_its_own) return failure("the templates stand in one line; give them lines of their own first");
    return insert_into_map(text, "templates", *section ? static_cast<int>((*section)->entries()) : 0, lines);
}

Result<void> insert_input(Rewriting& text, const InsertInput& edit) {
    return insert_into_map(text, "inputs", edit.index - included_inputs(text.now().scene), entry_of(edit.input));
}

Result<void> remove_input(Rewriting& text, const RemoveInput& edit) {
    const auto index = static_cast<std::size_t>(edit.index - included_inputs(text.now().scene));
    const auto map = section_with(text, "inputs", index);
    if (!map) return tl::unexpected(map.error());
    return text.write({remove_entry(text.text(), **map, index)});
}

/// One key alone stays a word where it was one.
Result<void> set_keys(Rewriting& text, const Scene& scene, const SetKeys& edit) {
    const auto index = static_cast<std::size_t>(edit.index - included_inputs(scene));
    const auto map = section_with(text, "inputs", index);
    if (!map) return tl::unexpected(map.error());
    const YamlNode& keys = (*map)->value(index);
    if (const YamlNode* shared = shared_below(keys)) return tl::unexpected(shared_failure(*shared));
    if (edit.keys == at(scene.inputs, edit.index).keys) return {};
    if (!comments_in(text.text(), keys.span, keys).empty()) return failure("the keys have comments of their own; edit the text");
    const bool word = keys.kind == YamlKind::scalar && edit.keys.size() == 1;
    std::string written = word ? write_text(edit.keys.front(), keys.style) : keys_text(edit.keys);
    if (keys.kind == YamlKind::sequence && keys.style == YamlStyle::block) {  // behind the key, not below it
        const std::size_t colon = text.text().find(':', (*map)->key(index).span.end) + 1;
        if (text.text().find('#', colon) >= keys.span.end) return text.write({{{colon, keys.span.end}, " " + written}});
    }
    return text.write({{keys.span, std::move(written)}});
}

Result<void> insert_test(Rewriting& text, const InsertTest& edit) {
    const auto list = section_of(text, "tests");
    if (!list) return tl::unexpected(list.error());
    const std::string entry = edit.text.empty() ? flow_map(entries_of(edit.test)) : edit.text;
    const ItemText item{"- " + entry, entry};
    std::optional<std::vector<Splice>> splices;
    if (*list && !(*list)->items.empty()) {
        // Items between brackets have braces of their own already.
        if ((*list)->style != YamlStyle::block) {
            std::vector<Span> pieces;
            for (const YamlNode* test : (*list)->items) pieces.push_back(test->span);
            splices = {insert_flow(text.text(), (*list)->span, pieces, static_cast<std::size_t>(edit.index), entry)};
        } else if (auto one = insert_item(text.text(), **list, static_cast<std::size_t>(edit.index), item)) {
            splices = {std::move(*one)};
        }
    } else if (const YamlNode& root = text.root(); !*list && root.style == YamlStyle::block) {
        const ListStyle style = list_style(text.text(), text.tree());
        const std::string lines = fmt::format("tests:{}{}", line_break(text.text()), indented_lines(item.block, style.dash));
        splices = {new_lines(text.text(), root, index_of_new_section(root, "tests"), lines)};
    } else {
        splices = insert_first_item(text.text(), root, "tests", item, list_style(text.text(), text.tree()));
    }
    if (!splices)
        return failure("the tests stand in one line, where a comment or an anchor would be lost; give them lines of their own first");
    return text.write(std::move(*splices));
}

Result<void> remove_test(Rewriting& text, const RemoveTest& edit) {
    const auto list = section_with(text, "tests", static_cast<std::size_t>(edit.index));
    if (!list) return tl::unexpected(list.error());
    return text.write(remove_item(text.text(), **list, static_cast<std::size_t>(edit.index)));
}

Result<void> rename_test(Rewriting& text, const RenameTest& edit) {
    const auto found = test_at(text, edit.index);
    if (!found) return tl::unexpected(found.error());
    const YamlNode& test = **found;
    const std::size_t entry = test.entry_of("name");
    if (entry == test.entries()) {
        if (edit.name.empty()) return {};
        return text.write({insert_entry(text.text(), test, 0, "name: " + write_text(edit.name))});
    }
    const YamlNode& name = test.value(entry);
    if (name.target || name.references > 0) return tl::unexpected(shared_failure(name));
    if (edit.name.empty()) return text.write({remove_entry(text.text(), test, entry)});
    return text.write({{name.span, write_text(edit.name, name.style)}});
}

}  // namespace pinfield
