#include "engine/io/node_reference.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/numbers.h"

namespace pinfield {
namespace {

using Json = nlohmann::ordered_json;

std::string_view word(Side side) { return side == Side::exact ? "exact" : "bound"; }

Json to_json(const Value& value) {
    if (const bool* b = std::get_if<bool>(&value)) return *b;
    if (const std::int64_t* i = std::get_if<std::int64_t>(&value)) return *i;
    if (const double* d = std::get_if<double>(&value)) return *d;
    if (const Vec2* v = std::get_if<Vec2>(&value)) return Json::array({v->x(), v->y()});
    if (const std::string* s = std::get_if<std::string>(&value)) return *s;
    if (const auto* names = std::get_if<std::vector<std::string>>(&value)) return *names;
    Json points = Json::array();
    for (const Vec2& p : std::get<std::vector<Vec2>>(value)) points.push_back({p.x(), p.y()});
    return points;
}

/// Infinite limits are no limits.
Json limit(double v) { return std::isfinite(v) ? Json(v) : Json(); }

Json to_json(const FieldType& field) {
    Json out{{"key", field.key},
             {"type", name(field.kind)},
             {"unit", symbol(field.meta.unit)},
             {"default", field.meta.required ? Json() : to_json(field.initial)},
             {"min", limit(field.meta.min.value)},
             {"min_open", field.meta.min.open},
             {"max", limit(field.meta.max.value)},
             {"max_open", field.meta.max.open},
             {"required", field.meta.required},
             {"common", field.common},
             {"doc", field.meta.doc}};
    if (!field.choices.empty()) out["choices"] = field.choices;
    return out;
}

Json to_json(const NodeType& type) {
    const ChildCount& children = type.meta.children;
    Json out{{"key", type.key()},
             {"kind", name(type.meta.kind)},
             {"doc", type.meta.doc},
             {"exactness",
              {{"outside", word(type.meta.exactness.outside)},
               {"inside", word(type.meta.exactness.inside)},
               {"lipschitz", type.meta.exactness.lipschitz}}},
             {"fields", Json::array()},
             {"contracts", Json::array()},
             {"children", {{"min", children.min}, {"max", children.max == any_number ? Json() : Json(children.max)}}}};
    for (const FieldType& field : type.fields) out["fields"].push_back(to_json(field));
    for (const ContractType& contract : type.contracts) out["contracts"].push_back(contract.sentence);
    return out;
}

std::string default_text(const FieldType& field) {
    if (field.meta.required) return "required";
    const std::string text = to_json(field.initial).dump();
    return text == "\"\"" || text == "[]" ? "none" : text;
}

/// "> 0", "0 ... 1", "" when there is no limit.
std::string range_text(const FieldMeta& meta) {
    const bool low = std::isfinite(meta.min.value), high = std::isfinite(meta.max.value);
    if (low && high)
        return fmt::format("{}{} ... {}{}", meta.min.open ? "above " : "", to_text(meta.min.value), meta.max.open ? "below " : "",
                           to_text(meta.max.value));
    if (low) return fmt::format("{} {}", meta.min.open ? ">" : ">=", to_text(meta.min.value));
    if (high) return fmt::format("{} {}", meta.max.open ? "<" : "<=", to_text(meta.max.value));
    return {};
}

std::string children_text(const ChildCount& count) {
    if (count.max == 0) return "none";
    if (count.max == any_number) return fmt::format("{} or more", count.min);
    return count.min == count.max ? fmt::format("{}", count.min) : fmt::format("{} to {}", count.min, count.max);
}

std::string exactness_text(const NodeType& type) {
    const Exactness& e = type.meta.exactness;
    return fmt::format("{} outside, {} inside, Lipschitz {}", word(e.outside), word(e.inside), to_text(e.lipschitz));
}

std::string what_it_takes(const FieldType& field) {
    std::string out(name(field.kind));
    if (!field.choices.empty()) out = fmt::format("{}", fmt::join(field.choices, " or "));
    if (const std::string_view unit = symbol(field.meta.unit); !unit.empty()) out += fmt::format(", {}", unit);
    if (const std::string range = range_text(field.meta); !range.empty()) out += fmt::format(", {}", range);
    return out;
}

bool has_distance(const NodeType& type) { return type.kernels != nullptr; }

}  // namespace

std::vector<const NodeType*> referenced_types(const Catalogue& catalogue, const std::string& key) {
    std::vector<const NodeType*> out;
    for (const NodeType& type : catalogue.types())
        if (key.empty() ? type.meta.kind != NodeKind::record : type.key() == key) out.push_back(&type);
    return out;
}

std::string reference_text(const std::vector<const NodeType*>& types) {
    std::string out;
    for (const NodeType* type : types) {
        out += fmt::format("{} ({}): {}\n", type->key(), name(type->meta.kind), type->meta.doc);
        for (const FieldType& field : type->fields)
            if (!field.common)
                out += fmt::format("  {:<14} {} [{}]  {}\n", field.key, what_it_takes(field), default_text(field), field.meta.doc);
        for (const ContractType& contract : type->contracts) out += fmt::format("  must hold: {}\n", contract.sentence);
        if (type->meta.children.max > 0) out += fmt::format("  children: {}\n", children_text(type->meta.children));
        if (has_distance(*type)) out += fmt::format("  distance: {}\n", exactness_text(*type));
        out += "\n";
    }
    return out;
}

std::string reference_markdown(const std::vector<const NodeType*>& types) {
    const auto row = [](const FieldType& field) {
        return fmt::format("| `{}` | {} | {} | {} |\n", field.key, what_it_takes(field), default_text(field), field.meta.doc);
    };
    const std::string head = "| field | takes | default | meaning |\n|---|---|---|---|\n";
    std::string out;
    const NodeType* with_common = nullptr;
    for (const NodeType* type : types) {
        out += fmt::format("## {}\n\n{} *{}*", type->key(), type->meta.doc, name(type->meta.kind));
        if (has_distance(*type)) out += fmt::format(", {}", exactness_text(*type));
        if (type->meta.children.max > 0) out += fmt::format(", children: {}", children_text(type->meta.children));
        out += ".\n\n";
        if (type->own_fields > 0) out += head;
        for (const FieldType& field : type->fields) {
            if (!field.common) out += row(field);
            else with_common = type;
        }
        if (type->own_fields > 0) out += "\n";
        for (const ContractType& contract : type->contracts) out += fmt::format("Must hold: {}.\n\n", contract.sentence);
    }
    if (with_common) {
        out += "## Fields of every node\n\n" + head;
        for (const FieldType& field : with_common->fields)
            if (field.common) out += row(field);
    }
    return out;
}

std::string reference_json(const std::vector<const NodeType*>& types) {
    Json out = Json::array();
    for (const NodeType* type : types) out.push_back(to_json(*type));
    return out.dump(2) + "\n";
}

}  // namespace pinfield
