#include "engine/io/node_reference.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/numbers.h"
#include "engine/io/field_json.h"
#include "engine/io/quantity.h"
#include "engine/io/value_writer.h"

namespace pinfield {
namespace {

using Json = nlohmann::ordered_json;

const char* word(Side side) { return side == Side::exact ? "exact" : "bound"; }

Json field_json(const FieldType& field) {
    return {{"key", field.key},
            {"type", name(field.kind)},
            {"unit", symbol(field.meta.unit)},
            {"default", field.meta.required ? Json(nullptr) : value_json<Json>(field.initial)},
            {"min", number_json<Json>(field.meta.min.value)},
            {"min_open", field.meta.min.open},
            {"doc", field.meta.doc}};
}

Json type_json(const NodeType& type) {
    const Exactness& e = type.meta.exactness;
    Json fields = Json::array();
    for (const FieldType& field : type.fields) fields.push_back(field_json(field));
    const ChildCount& children = type.meta.children;
    return {{"key", type.key()},
            {"kind", name(type.meta.kind)},
            {"doc", type.meta.doc},
            {"exactness",
             {{"outside", word(e.outside)}, {"inside", word(e.inside)}, {"lipschitz", number_json<Json>(e.lipschitz)}}},
            {"fields", fields},
            {"children",
             {{"min", children.min}, {"max", children.max == any_number ? Json(nullptr) : Json(children.max)}}}};
}

std::string default_text(const FieldType& field) {
    if (field.meta.required) return "required";
    const auto* text = std::get_if<std::string>(&field.initial);
    const auto* names = std::get_if<std::vector<std::string>>(&field.initial);
    if ((text && text->empty()) || (names && names->empty())) return "none";
    return write_value(field, field.initial);
}

/// "> 0, <= 1", the words of a choice, or nothing.
std::string range_text(const FieldType& field) {
    if (!field.choices.empty()) return fmt::format("{}", fmt::join(field.choices, " | "));
    std::string out;
    const FieldMeta& m = field.meta;
    if (std::isfinite(m.min.value)) out = fmt::format("{} {}", m.min.open ? ">" : ">=", to_text(m.min.value));
    if (std::isfinite(m.max.value))
        out += fmt::format("{}{} {}", out.empty() ? "" : ", ", m.max.open ? "<" : "<=", to_text(m.max.value));
    return out;
}

std::string exactness_text(const NodeType& type) {
    const Exactness& e = type.meta.exactness;
    return fmt::format("{} outside, {} inside, Lipschitz constant {}", word(e.outside), word(e.inside),
                       to_text(e.lipschitz));
}

bool has_field(const NodeType& type) {
    return type.meta.kind == NodeKind::shape || type.meta.kind == NodeKind::operation;
}

/// The common fields are the same for all: they are listed once, after the last node.
std::vector<FieldType> common_fields(const std::vector<const NodeType*>& types) {
    std::vector<FieldType> out;
    for (const NodeType* type : types) {
        for (const FieldType& field : type->fields)
            if (field.common) out.push_back(field);
        if (!out.empty()) break;
    }
    return out;
}

std::string meaning_of(const FieldType& field) {
    const OnlyWith& with = field.meta.only_with;
    return with.field.empty() ? std::string(field.meta.doc) : fmt::format("{} Only with {}: {}.", field.meta.doc, with.field, with.choice);
}

std::string field_text(const FieldType& field) {
    const std::string unit(symbol(field.meta.unit)), range = range_text(field);
    return fmt::format("    {:<14} {:<13} {:<8} {:<22} {:<24} {}\n", field.key, name(field.kind), unit,
                       default_text(field), range, meaning_of(field));
}

/// A cell of a Markdown table holds no bare bar.
std::string cell(std::string_view text) {
    std::string out;
    for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
    return out;
}

std::string field_table(const std::vector<FieldType>& fields) {
    std::string out = "| field | type | unit | default | range | meaning |\n|---|---|---|---|---|---|\n";
    for (const FieldType& f : fields)
        out += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", f.key, name(f.kind), symbol(f.meta.unit),
                           cell(default_text(f)), cell(range_text(f)), cell(meaning_of(f)));
    return out;
}

std::vector<FieldType> own_fields(const NodeType& type) {
    return {type.fields.begin(), type.fields.begin() + type.own_fields};
}

}  // namespace

std::vector<const NodeType*> referenced_types(const Catalog& catalog, std::string_view key) {
    std::vector<const NodeType*> out;
    for (const NodeType& type : catalog.types())
        if (key.empty() ? type.meta.kind != NodeKind::record : type.key() == key) out.push_back(&type);
    return out;
}

std::string reference_json(const std::vector<const NodeType*>& types) {
    Json out = Json::array();
    for (const NodeType* type : types) out.push_back(type_json(*type));
    return out.dump(2) + "\n";
}

std::string children_text(const NodeType& type) {
    const ChildCount c = type.meta.children;
    if (c.max == 0) return "none";
    if (c.max == any_number) return c.min == 0 ? "any number" : fmt::format("{} or more", c.min);
    return c.min == c.max ? fmt::format("{}", c.min) : fmt::format("{} to {}", c.min, c.max);
}

std::string fields_markdown(const NodeType& type) {
    std::string out = type.own_fields > 0 ? field_table(own_fields(type)) + "\n" : "";
    for (const ContractType& contract : type.contracts) out += fmt::format("Must hold: {}.\n\n", contract.sentence);
    return out;
}

std::string reference_text(const std::vector<const NodeType*>& types) {
    std::string out;
    for (const NodeType* type : types) {
        out += fmt::format("{} ({}): {}\n", type->key(), name(type->meta.kind), type->meta.doc);
        if (has_field(*type)) out += fmt::format("    distance: {}\n", exactness_text(*type));
        if (type->meta.kind != NodeKind::record) out += fmt::format("    children: {}\n", children_text(*type));
        for (const FieldType& field : own_fields(*type)) out += field_text(field);
        for (const ContractType& contract : type->contracts)
            out += fmt::format("    must hold: {}\n", contract.sentence);
        out += "\n";
    }
    if (const auto common = common_fields(types); !common.empty()) {
        out += "Every scene node also has:\n";
        for (const FieldType& field : common) out += field_text(field);
    }
    return out;
}

std::string reference_markdown(const std::vector<const NodeType*>& types) {
    std::string out;
    for (const NodeType* type : types) {
        out += fmt::format("## {}\n\n{}\n\n", type->key(), type->meta.doc);
        out += fmt::format("Kind: {}.", name(type->meta.kind));
        if (has_field(*type)) out += fmt::format(" Distance: {}.", exactness_text(*type));
        if (type->meta.kind != NodeKind::record) out += fmt::format(" Children: {}.", children_text(*type));
        out += "\n\n";
        out += fields_markdown(*type);
    }
    if (const auto common = common_fields(types); !common.empty())
        out += "## Fields of every scene node\n\n" + field_table(common);
    return out;
}

namespace {

/// Calls tell(symbol, suffixes) for every dimension that has some.
template <class F>
void each_unit(F&& tell) {
    Dimension last;
    for (const UnitSuffix& suffix : unit_suffixes())
        if (suffix.dimension != last) tell(symbol(last = suffix.dimension), suffixes_of(suffix.dimension));
}

}  // namespace

std::string units_text() {
    std::string out = "Units that a number may carry; without one it is in the first column's:\n";
    each_unit([&](const std::string& unit, const std::string& suffixes) { out += fmt::format("    {:<8} {}\n", unit, suffixes); });
    return out;
}

std::string units_markdown() {
    std::string out = "## Units\n\nA number without one is in the first column's.\n\n| unit | may be written |\n|---|---|\n";
    each_unit([&](const std::string& unit, const std::string& suffixes) { out += fmt::format("| {} | {} |\n", unit, suffixes); });
    return out;
}

}  // namespace pinfield
