#include "engine/reflect/node_type.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/core/numbers.h"
#include "engine/reflect/text_fault.h"

namespace pinfield {
namespace {

std::string with_unit(double v, Unit unit) {
    const std::string_view u = symbol(unit);
    return u.empty() ? to_text(v) : fmt::format("{} {}", to_text(v), u);
}

std::optional<std::string> why_invalid_number(const FieldMeta& meta, double v) {
    if (!std::isfinite(v)) return "must be a finite number";
    if (meta.unit == Unit::metre) {
        if (std::fabs(v) > longest_length) return fmt::format("must be within {}", with_unit(longest_length, meta.unit));
        if (meta.min.open && meta.min.value == 0 && v > 0 && v < shortest_length)
            return fmt::format("must be at least {}", with_unit(shortest_length, meta.unit));
    }
    if (v < meta.min.value || (meta.min.open && v == meta.min.value))
        return fmt::format("must be {} {}", meta.min.open ? "above" : "at least", with_unit(meta.min.value, meta.unit));
    if (v > meta.max.value || (meta.max.open && v == meta.max.value))
        return fmt::format("must be {} {}", meta.max.open ? "below" : "at most", with_unit(meta.max.value, meta.unit));
    return {};
}

std::optional<std::string> why_invalid_vec2(const FieldMeta& meta, const Vec2& v) {
    if (auto why = why_invalid_number(meta, v.x())) return why;
    return why_invalid_number(meta, v.y());
}

std::optional<std::string> why_invalid_choice(const FieldType& field, const std::string& word) {
    if (std::find(field.choices.begin(), field.choices.end(), word) != field.choices.end()) return {};
    return fmt::format("must be one of {}", fmt::join(field.choices, ", "));
}

std::optional<std::string> why_invalid_text(const FieldType& field, const std::string& text) {
    std::vector<double> read;
    if (!field.pack_text) return {};
    if (auto fault = field.pack_text(text, read)) return std::move(fault->message);
    return {};
}

double index_of_choice(const FieldType& field, const std::string& word) {
    return static_cast<double>(std::find(field.choices.begin(), field.choices.end(), word) - field.choices.begin());
}

}  // namespace

std::optional<int> NodeType::find_field(std::string_view wanted) const {
    const auto it = std::find_if(fields.begin(), fields.end(), [&](const FieldType& f) { return f.key == wanted; });
    if (it == fields.end()) return {};
    return static_cast<int>(it - fields.begin());
}

std::optional<std::string> why_invalid(const FieldType& field, const Value& value) {
    const auto wrong_kind = [&] { return fmt::format("must be a {}", name(field.kind)); };
    switch (field.kind) {
        case FieldKind::boolean:
            if (!std::holds_alternative<bool>(value)) return wrong_kind();
            return {};
        case FieldKind::integer:
            if (!std::holds_alternative<std::int64_t>(value)) return wrong_kind();
            return why_invalid_number(field.meta, static_cast<double>(std::get<std::int64_t>(value)));
        case FieldKind::number:
            if (!std::holds_alternative<double>(value)) return wrong_kind();
            return why_invalid_number(field.meta, std::get<double>(value));
        case FieldKind::vec2:
            if (!std::holds_alternative<Vec2>(value)) return wrong_kind();
            return why_invalid_vec2(field.meta, std::get<Vec2>(value));
        case FieldKind::points:
            if (!std::holds_alternative<std::vector<Vec2>>(value)) return wrong_kind();
            for (const Vec2& p : std::get<std::vector<Vec2>>(value))
                if (auto why = why_invalid_vec2(field.meta, p)) return why;
            return {};
        case FieldKind::choice:
            if (!std::holds_alternative<std::string>(value)) return wrong_kind();
            return why_invalid_choice(field, std::get<std::string>(value));
        case FieldKind::choices:
            if (!std::holds_alternative<std::vector<std::string>>(value)) return wrong_kind();
            for (const std::string& word : std::get<std::vector<std::string>>(value))
                if (auto why = why_invalid_choice(field, word)) return why;
            return {};
        case FieldKind::text:
            if (!std::holds_alternative<std::string>(value)) return wrong_kind();
            return why_invalid_text(field, std::get<std::string>(value));
        case FieldKind::color:
        case FieldKind::id:
            if (!std::holds_alternative<std::string>(value)) return wrong_kind();
            return {};
        case FieldKind::names:
            if (!std::holds_alternative<std::vector<std::string>>(value)) return wrong_kind();
            return {};
    }
    return {};
}

std::vector<double> pack(const NodeType& type, std::span<const Value> own_values, int derived) {
    assert(static_cast<int>(own_values.size()) >= type.own_fields && "pack needs a value for every own field");
    std::vector<double> block;
    std::vector<std::pair<std::size_t, std::size_t>> lists;  // where in the block each is described, and which field it is
    for (std::size_t i = 0; i < static_cast<std::size_t>(type.own_fields); ++i) {
        const FieldType& field = type.fields[i];
        const Value& value = own_values[i];
        switch (field.kind) {
            case FieldKind::boolean: block.push_back(std::get<bool>(value) ? 1.0 : 0.0); break;
            case FieldKind::integer: block.push_back(static_cast<double>(std::get<std::int64_t>(value))); break;
            case FieldKind::number: block.push_back(std::get<double>(value)); break;
            case FieldKind::vec2:
                block.push_back(std::get<Vec2>(value).x());
                block.push_back(std::get<Vec2>(value).y());
                break;
            case FieldKind::choice: block.push_back(index_of_choice(field, std::get<std::string>(value))); break;
            case FieldKind::points:
            case FieldKind::choices:
                lists.emplace_back(block.size(), i);
                block.insert(block.end(), 2, 0.0);
                break;
            case FieldKind::text:
                if (!field.pack_text) break;
                lists.emplace_back(block.size(), i);
                block.insert(block.end(), 2, 0.0);
                break;
            case FieldKind::color:
            case FieldKind::id:
            case FieldKind::names: break;
        }
    }
    block.insert(block.end(), static_cast<std::size_t>(derived), 0.0);
    for (const auto& [slot, i] : lists) {
        block[slot] = static_cast<double>(block.size());
        if (const auto* points = std::get_if<std::vector<Vec2>>(&own_values[i])) {
            block[slot + 1] = static_cast<double>(points->size());
            for (const Vec2& p : *points) block.insert(block.end(), {p.x(), p.y()});
        } else if (const auto* text = std::get_if<std::string>(&own_values[i])) {
            const std::size_t before = block.size();
            type.fields[i].pack_text(*text, block);
            block[slot + 1] = static_cast<double>(block.size() - before);
        } else {
            const auto& words = std::get<std::vector<std::string>>(own_values[i]);
            block[slot + 1] = static_cast<double>(words.size());
            for (const std::string& word : words) block.push_back(index_of_choice(type.fields[i], word));
        }
    }
    return block;
}

std::optional<std::string_view> broken_contract(const NodeType& type, const double* params) {
    for (const ContractType& contract : type.contracts)
        if (!contract.holds(params)) return contract.sentence;
    return {};
}

std::string_view name(NodeKind kind) {
    switch (kind) {
        case NodeKind::shape: return "shape";
        case NodeKind::operation: return "operation";
        case NodeKind::part: return "part";
        case NodeKind::record: return "record";
    }
    return "?";
}

std::string_view symbol(Unit unit) {
    switch (unit) {
        case Unit::none: return "";
        case Unit::metre: return "m";
        case Unit::degree: return "deg";
        case Unit::second: return "s";
        case Unit::kilogram: return "kg";
        case Unit::metre_per_second: return "m/s";
        case Unit::metre_per_second2: return "m/s^2";
        case Unit::degree_per_second: return "deg/s";
        case Unit::degree_per_second2: return "deg/s^2";
        case Unit::seconds_per_metre: return "s/m";
    }
    return "";
}

}  // namespace pinfield
