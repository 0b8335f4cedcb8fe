#include "engine/io/json_schema.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/io/field_json.h"
#include "engine/io/limits.h"
#include "engine/io/quantity.h"
#include "engine/scene/part_traits.h"

namespace pinfield {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* name_pattern = "^[a-z_][a-z0-9_]*$";

Json reference(const std::string& definition) { return {{"$ref", "#/definitions/" + definition}}; }

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) out += c == '^' ? std::string("\\^") : std::string(1, c);
    return out;
}

/// A number with one of the unit's suffixes, or without.
std::string quantity_pattern(Unit unit) {
    std::string suffixes;
    for (const UnitSuffix& s : unit_suffixes())
        if (s.unit == unit) suffixes.append(suffixes.empty() ? "" : "|").append(escaped(s.text));
    const std::string number = R"([+-]?((0|[1-9][0-9]*)(\.[0-9]*)?|\.[0-9]+)([eE][+-]?[0-9]+)?)";
    return suffixes.empty() ? fmt::format("^{}$", number) : fmt::format("^{}({})?$", number, suffixes);
}

Json number_schema(const FieldMeta& meta) {
    Json bare{{"type", "number"}};
    if (meta.unit == Unit::metre) {
        bare["minimum"] = -longest_length;
        bare["maximum"] = longest_length;
    }
    if (meta.unit == Unit::metre && meta.min.open && meta.min.value == 0) {
        bare["minimum"] = shortest_length;
    } else if (std::isfinite(meta.min.value)) {
        bare[meta.min.open ? "exclusiveMinimum" : "minimum"] = meta.min.value;
    }
    if (std::isfinite(meta.max.value)) bare[meta.max.open ? "exclusiveMaximum" : "maximum"] = meta.max.value;
    return {{"anyOf", {bare, {{"type", "string"}, {"pattern", quantity_pattern(meta.unit)}}}}};
}

Json pair_schema(const FieldMeta& meta) {
    return {{"type", "array"}, {"items", number_schema(meta)}, {"minItems", 2}, {"maxItems", 2}};
}

Json kind_schema(const FieldType& field) {
    switch (field.kind) {
        case FieldKind::boolean: return {{"type", "boolean"}};
        case FieldKind::integer: {
            Json out{{"type", "integer"}};
            if (std::isfinite(field.meta.min.value)) out["minimum"] = std::ceil(field.meta.min.value);
            if (std::isfinite(field.meta.max.value)) out["maximum"] = std::floor(field.meta.max.value);
            return out;
        }
        case FieldKind::number: return number_schema(field.meta);
        case FieldKind::vec2: return pair_schema(field.meta);
        case FieldKind::points:
            return {{"type", "array"}, {"items", pair_schema(field.meta)}, {"maxItems", Limits{}.points}};
        case FieldKind::choice: return {{"enum", field.choices}};
        case FieldKind::choices: {
            const Json word{{"enum", field.choices}};
            return {{"anyOf", {word, {{"type", "array"}, {"items", word}, {"maxItems", Limits{}.points}}}}};
        }
        case FieldKind::text: return {{"type", {"string", "number", "boolean"}}};
        case FieldKind::color:
            return {{"type", "string"}, {"pattern", "^(#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})|[a-zA-Z]+)$"}};
        case FieldKind::id: return {{"type", "string"}, {"pattern", name_pattern}};
        case FieldKind::names: return reference("names");
    }
    return Json::object();
}

Json field_schema(const FieldType& field) {
    Json out = kind_schema(field);
    if (out.contains("$ref")) out = {{"allOf", {out}}};  // draft-07 ignores what stands beside a $ref
    out["description"] = field.meta.doc;
    if (!field.meta.required) out["default"] = value_json<Json>(field.initial);
    return out;
}

/// Which list of nodes a type's children come from.
std::string child_definition(const NodeType& type) {
    return type.part && type.part->role == Role::group ? "scene_node" : "shape_node";
}

Json type_schema(const NodeType& type) {
    Json properties = Json::object(), required = Json::array();
    for (const FieldType& field : type.fields) {
        properties[std::string(field.key)] = field_schema(field);
        if (field.meta.required) required.push_back(field.key);
    }
    const ChildCount children = type.meta.children;
    if (children.max > 0) {
        Json list{{"type", "array"}, {"items", reference(child_definition(type))}, {"minItems", children.min}};
        if (children.max != any_number) list["maxItems"] = children.max;
        properties["children"] = list;
        if (children.min > 0) required.push_back("children");
    }
    Json out{{"description", type.meta.doc},
             {"type", required.empty() ? Json::array({"object", "null"}) : Json("object")},
             {"additionalProperties", false},
             {"properties", properties}};
    if (!required.empty()) out["required"] = required;
    return out;
}

/// A map with exactly one key: an error then names that node's own field, not "no alternative matched".
Json one_key_node(const Catalog& catalog, bool with_parts) {
    Json properties = Json::object();
    for (const NodeType& type : catalog.types()) {
        const NodeKind kind = type.meta.kind;
        if (kind == NodeKind::shape || kind == NodeKind::operation || (with_parts && kind == NodeKind::part))
            properties[std::string(type.key())] = reference(std::string(type.key()));
    }
    return {{"type", "object"},
            {"minProperties", 1},
            {"maxProperties", 1},
            {"additionalProperties", false},
            {"properties", properties}};
}

Json one_or_list(const Json& item) { return {{"anyOf", {item, {{"type", "array"}, {"items", item}}}}}; }

FieldMeta unit_meta(Unit unit) {
    FieldMeta meta;
    meta.unit = unit;
    return meta;
}

Json test_schema() {
    FieldMeta run = unit_meta(Unit::second);
    run.min = above(0);
    const Json launch{
        {"type", "object"},
        {"additionalProperties", false},
        {"required", {"at"}},
        {"properties",
         {{"at", pair_schema(unit_meta(Unit::metre))}, {"velocity", pair_schema(unit_meta(Unit::metre_per_second))}}}};
    return {{"type", "object"},
            {"additionalProperties", false},
            {"required", {"expect"}},
            {"properties",
             {{"name", {{"type", {"string", "number", "boolean"}}}},
              {"launch", one_or_list(launch)},
              {"run", number_schema(run)},
              {"expect", one_or_list({{"type", "string"}, {"pattern", "^[^=!<>]+(==|!=|<=|>=|<|>)[^=!<>]+$"}})}}}};
}

Json named_map(const Json& value) {
    return {
        {"type", {"object", "null"}}, {"propertyNames", {{"pattern", name_pattern}}}, {"additionalProperties", value}};
}

}  // namespace

std::string json_schema(const Catalog& catalog) {
    Json definitions = Json::object();
    definitions["names"] = one_or_list({{"type", "string"}, {"pattern", name_pattern}});
    definitions["scene_node"] = one_key_node(catalog, true);
    definitions["shape_node"] = one_key_node(catalog, false);
    for (const NodeType& type : catalog.types()) definitions[std::string(type.key())] = type_schema(type);
    const Json keys = one_or_list({{"type", {"string", "integer"}}});
    const Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
                      {"title", "Pinfield table"},
                      {"type", "object"},
                      {"additionalProperties", false},
                      {"required", {"pinfield"}},
                      {"properties",
                       {{"pinfield", {{"description", "Version of the format."}, {"const", 1}}},
                        {"table", reference("table")},
                        {"physics", reference("physics")},
                        {"materials", named_map(reference("material"))},
                        {"scene", {{"type", {"array", "null"}}, {"items", reference("scene_node")}}},
                        {"inputs", named_map(keys)},
                        {"tests", {{"type", {"array", "null"}}, {"items", test_schema()}}}}},
                      {"definitions", definitions}};
    return schema.dump(2) + "\n";
}

}  // namespace pinfield
