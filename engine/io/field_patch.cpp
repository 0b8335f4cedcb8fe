#include "engine/io/field_patch.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "engine/core/at.h"
#include "engine/io/quantity.h"
#include "engine/io/value_writer.h"

namespace pinfield {
namespace {

/// Bytes between two items of a list, or what would stand there; comments belong to the items they follow.
std::string separator(const std::string& text, const YamlNode& list) {
    if (list.items.size() >= 2) {
        const std::size_t begin = list.items[0]->span.end, end = list.items[1]->span.begin;
        const std::string between = text.substr(begin, end - begin);
        if (between.find('#') == std::string::npos) return between;
    }
    return ", ";
}

class ValueSplice {
public:
    ValueSplice(const std::string& text, const FieldType& field) : text_(text), field_(field) {}

    /// The smallest replacement of a value's text.
    Splice of(const YamlNode& node, const Value& before, const Value& after) const {
        if (const auto* pair = std::get_if<Vec2>(&after); pair && node.kind == YamlKind::sequence)
            return pair_patch(node, std::get<Vec2>(before), *pair);
        if (const auto* points = std::get_if<std::vector<Vec2>>(&after); points && node.kind == YamlKind::sequence)
            return points_patch(node, std::get<std::vector<Vec2>>(before), *points);
        if (node.kind == YamlKind::scalar) return {node.span, write_scalar_like(field_, after, node)};
        return {node.span, list_or_value(node, after)};
    }

private:
    /// A pair again, each untouched component with the bytes it had.
    std::string pair_text(const YamlNode& node, const Vec2& before, const Vec2& after) const {
        const YamlNode &x = *node.items[0], &y = *node.items[1];
        const auto component = [&](const YamlNode& item, double old_value, double new_value) {
            return identical(Value(old_value), Value(new_value)) ? slice(item.span.begin, item.span.end)
                                                                 : write_number_like(field_, new_value, &item);
        };
        return slice(node.span.begin, x.span.begin) + component(x, before.x(), after.x()) +
               slice(x.span.end, y.span.begin) + component(y, before.y(), after.y()) + slice(y.span.end, node.span.end);
    }

    /// Only from the first to the last component that changes.
    Splice pair_patch(const YamlNode& node, const Vec2& before, const Vec2& after) const {
        const YamlNode &x = *node.items[0], &y = *node.items[1];
        const bool same_x = identical(Value(before.x()), Value(after.x())),
                   same_y = identical(Value(before.y()), Value(after.y()));
        if (same_x) return {y.span, write_number_like(field_, after.y(), &y)};
        if (same_y) return {x.span, write_number_like(field_, after.x(), &x)};
        return {{x.span.begin, y.span.end},
                write_number_like(field_, after.x(), &x) + slice(x.span.end, y.span.begin) +
                    write_number_like(field_, after.y(), &y)};
    }

    /// Points in common at both ends keep their bytes; what is between is written anew, point by point where the counts
    /// agree.
    Splice points_patch(const YamlNode& node, const std::vector<Vec2>& before,
                           const std::vector<Vec2>& after) const {
        const auto same = [&](std::size_t i, std::size_t j) { return identical(Value(before[i]), Value(after[j])); };
        std::size_t head = 0, tail = 0;
        const std::size_t common = std::min(before.size(), after.size());
        while (head < common && same(head, head)) ++head;
        while (tail < common - head && same(before.size() - 1 - tail, after.size() - 1 - tail)) ++tail;
        const std::size_t old_count = before.size() - head - tail, new_count = after.size() - head - tail;
        if (before.empty() || after.empty()) return {node.span, write_value(field_, after)};
        const std::string between = separator(text_, node);
        std::string out;
        for (std::size_t i = 0; i < new_count; ++i) {
            const bool replaces = i < old_count && node.items[head + i]->kind == YamlKind::sequence;
            const std::string point = replaces ? pair_text(*node.items[head + i], before[head + i], after[head + i])
                                               : new_point(node, after[head + i]);
            const bool keep_gap = i > 0 && i < old_count;
            if (i > 0)
                out += keep_gap ? slice(node.items[head + i - 1]->span.end, node.items[head + i]->span.begin) : between;
            out += point;
        }
        if (old_count > 0 && new_count > 0)
            return {{node.items[head]->span.begin, node.items[head + old_count - 1]->span.end}, out};
        if (old_count > 0) {  // points are taken out, with the separator on one side
            if (head > 0) return {{node.items[head - 1]->span.end, node.items[head + old_count - 1]->span.end}, ""};
            return {{node.items[0]->span.begin, node.items[old_count]->span.begin}, ""};
        }
        if (head > 0) return {{node.items[head - 1]->span.end, node.items[head - 1]->span.end}, between + out};
        return {{node.items[0]->span.begin, node.items[0]->span.begin}, out + between};
    }

    /// In the units of the list's first point.
    std::string new_point(const YamlNode& list, const Vec2& point) const {
        const YamlNode& like = list.items[0]->resolved();
        if (like.items.size() != 2) return write_value(field_, Value(point));
        return fmt::format("[{}, {}]", write_number_like(field_, point.x(), like.items[0]),
                           write_number_like(field_, point.y(), like.items[1]));
    }

    /// A list of names that was written as a list stays one.
    std::string list_or_value(const YamlNode& node, const Value& after) const {
        const auto* names = std::get_if<std::vector<std::string>>(&after);
        if (names && names->size() == 1 && node.kind == YamlKind::sequence)
            return fmt::format("[{}]", write_text(names->front()));
        return write_value(field_, after);
    }

    std::string slice(std::size_t begin, std::size_t end) const { return text_.substr(begin, end - begin); }

    const std::string& text_;
    const FieldType& field_;
};

/// How often each spelling of a unit stands in the text of given fields; a bare number is the empty spelling.
using Spellings = std::map<std::string, int>;

void count_spellings(const Scene& scene, const Node& node, Unit unit, Spellings& counts) {
    constexpr std::string_view between = "[]{}, '\"\r\n";
    for (std::size_t i = 0; i < node.fields.size(); ++i) {
        if (!node.fields[i].is_explicit || node.type->fields[i].meta.unit != unit) continue;
        std::string_view text = scene.sources.slice(node.fields[i].where);
        while (!text.empty()) {
            const std::size_t length = std::min(text.find_first_of(between), text.size());
            const QuantityResult read = read_quantity(text.substr(0, length), unit);
            // Zero is the same in every unit, and nobody writes one with it.
            if (read && (read->value != 0 || read->suffix))
                ++counts[read->suffix ? std::string(read->suffix->text) : ""];
            text.remove_prefix(std::min(length + 1, text.size()));
        }
    }
}

/// A new section for a record that the text does not mention.
Splice new_section(const std::string& text, const YamlNode& root, const Node& record, const std::string& entry) {
    std::size_t index = 0;
    for (std::size_t i = 0; i < root.entries(); ++i)
        if (root.key(i).text == "pinfield" || root.key(i).text == "table") index = i + 1;
    return insert_entry(text, root, index, fmt::format("{}: {{{}}}", record.type->key(), entry));
}

}  // namespace

std::size_t index_for_new_field(const YamlNode& map, const FieldType& field) {
    if (field.common && field.meta.meaning == Meaning::id) return 0;
    if (field.common && field.key == "at") return map.entries() > 0 && map.key(0).text == "id" ? 1 : 0;
    for (std::size_t i = 0; i < map.entries(); ++i)
        if (map.key(i).text == "children") return i;
    return map.entries();
}

EntryOfNode find_entry(const YamlTree& tree, const Node& node) {
    if (!node.key) return {};
    for (const YamlNode& key : tree.nodes) {
        if (key.span != node.key.span || key.kind != YamlKind::scalar || !key.parent || key.parent->kind != YamlKind::map) continue;
        const auto& items = key.parent->items;
        const auto at = static_cast<std::size_t>(std::find(items.begin(), items.end(), &key) - items.begin());
        if (at % 2 == 0) return {key.parent, at / 2};
    }
    return {};
}

const YamlNode* shared_above(const YamlNode* node) {
    for (; node; node = node->parent)
        if (node->references > 0) return node;
    return nullptr;
}
const YamlNode* shared_below(const YamlNode& node) {
    if (node.references > 0 || node.target) return &node;
    for (const YamlNode* item : node.items)
        if (const YamlNode* found = shared_below(*item)) return found;
    return nullptr;
}

Failure shared_failure(const YamlNode& shared) {
    if (shared.target)
        return {fmt::format("the value stands for the one at the anchor &{}; edit the text", shared.text)};
    return {fmt::format("the value is shared by {} places of the file; edit the text", shared.references + 1)};
}

std::string customary_number(const Scene& scene, const Node* node, Unit unit) {
    if (unit == Unit::none) return {};
    Spellings counts;
    if (node) count_spellings(scene, *node, unit, counts);
    if (counts.empty())
        for (const NodeId id : scene.all()) count_spellings(scene, *scene.find(id), unit, counts);
    const auto most = std::max_element(counts.begin(), counts.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == counts.end() || most->first.empty() ? std::string() : "1" + most->first;
}

Splice value_splice(const std::string& text, const FieldType& field, const YamlNode& node, const Value& before, const Value& after) {
    return ValueSplice(text, field).of(node, before, after);
}

Result<Splice> splice_for(const Reading& now, const Node& node, const SetField& edit) {
    const std::string& text = now.source().text();
    const FieldSlot& slot = at(node.fields, edit.field);
    const FieldType& field = at(node.type->fields, edit.field);
    if (!edit.is_explicit && !identical(edit.value, field.initial)) return failure("only a default value can be left out of the text");
    const auto new_entry = [&] {
        return fmt::format("{}: {}", field.key, write_value(field, edit.value, customary_number(now.scene, &node, field.meta.unit)));
    };
    const EntryOfNode entry = find_entry(*now.tree, node);
    if (!entry.owner) {
        if (!node.is_record()) return failure("the text does not hold the node");
        return new_section(text, *now.tree->root, node, new_entry());
    }
    const YamlNode& body = entry.owner->value(entry.index);
    if (const YamlNode* shared = shared_above(&body)) return tl::unexpected<Failure>(shared_failure(*shared));
    if (body.target) return tl::unexpected<Failure>(shared_failure(body));
    if (body.is_empty()) return insert_body(text, body, new_entry());
    for (std::size_t i = 0; i < body.entries(); ++i) {
        if (body.key(i).text != field.key) continue;
        if (const YamlNode* shared = shared_below(body.value(i))) return tl::unexpected<Failure>(shared_failure(*shared));
        if (!edit.is_explicit) return remove_entry(text, body, i);
        return value_splice(text, field, body.value(i), slot.value, edit.value);
    }
    return insert_entry(text, body, index_for_new_field(body, field), new_entry());
}

}  // namespace pinfield
