#include "engine/io/json_schema.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/color.h"
#include "engine/io/quantity.h"
#include "engine/scene/part_traits.h"

namespace pinfield {
namespace {

using Json = nlohmann::ordered_json;

Json reference(const std::string& definition) { return {{"$ref", "#/definitions/" + definition}}; }

/// A bare number, or a text of digits and a unit that fits. Ranges can only be told of bare numbers: the reader checks the rest.
Json number_schema(const FieldMeta& meta, bool integer) {
    Json bare{{"type", integer ? "integer" : "number"}};
    if (std::isfinite(meta.min.value)) bare[meta.min.open ? "exclusiveMinimum" : "minimum"] = meta.min.value;
    if (std::isfinite(meta.max.value)) bare[meta.max.open ? "exclusiveMaximum" : "maximum"] = meta.max.value;
    std::vector<std::string> suffixes;
    for (const UnitSuffix& suffix : unit_suffixes())
        if (suffix.unit == meta.unit) suffixes.emplace_back(suffix.text);
    if (integer || suffixes.empty()) return bare;
    std::string alternatives;
    for (const std::string& suffix : suffixes) {
        std::string escaped;
        for (const char c : suffix) {
            if (c == '^' || c == '.' || c == '/') escaped += '\\';
            escaped += c;
        }
        alternatives += (alternatives.empty() ? "" : "|") + escaped;
    }
    const Json spelled{{"type", "string"},
                       {"pattern", fmt::format("^[+-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)? ?({})$", alternatives)}};
    return {{"anyOf", Json::array({bare, spelled})}};
}

Json pair_of(const Json& number) {
    return {{"type", "array"}, {"items", number}, {"minItems", 2}, {"maxItems", 2}};
}

Json field_schema(const FieldType& field) {
    switch (field.kind) {
        case FieldKind::boolean: return {{"type", "boolean"}};
        case FieldKind::integer: return number_schema(field.meta, true);
        case FieldKind::number: return number_schema(field.meta, false);
        case FieldKind::vec2: return pair_of(number_schema(field.meta, false));
        case FieldKind::points: return {{"type", "array"}, {"items", pair_of(number_schema(field.meta, false))}};
        case FieldKind::choice: return {{"enum", field.choices}};
        case FieldKind::color: return reference("color");
        case FieldKind::id: return reference("id");
        case FieldKind::names: return reference("names");
        case FieldKind::text: return {{"type", "string"}};
    }
    return {};
}

/// The value of a one-key node, or a record.
Json fields_schema(const NodeType& type, const std::string& children_definition) {
    Json properties = Json::object(), required = Json::array();
    for (const FieldType& field : type.fields) {
        Json schema = field_schema(field);
        schema["description"] = field.meta.doc;
        properties[std::string(field.key)] = std::move(schema);
        if (field.meta.required) required.push_back(field.key);
    }
    const ChildCount& count = type.meta.children;
    if (count.max > 0) {
        Json children{{"type", "array"}, {"items", reference(children_definition)}, {"minItems", count.min}};
        if (count.max != any_number) children["maxItems"] = count.max;
        properties["children"] = std::move(children);
        if (count.min > 0) required.push_back("children");
    }
    Json out{{"type", "object"}, {"description", type.meta.doc}, {"properties", properties}, {"additionalProperties", false}};
    if (!required.empty()) out["required"] = required;
    // `- spawn:` without a value is a node with all its defaults.
    if (required.empty()) out["type"] = Json::array({"object", "null"});
    return out;
}

bool is_shape(const NodeType& type) {
    return type.meta.kind == NodeKind::shape || type.meta.kind == NodeKind::operation;
}

/// A map with exactly one key, the type: an editor can then say which field of which type is wrong.
template <class Belongs>
Json one_key_node(const Catalogue& catalogue, Belongs belongs) {
    Json properties = Json::object();
    for (const NodeType& type : catalogue.types())
        if (belongs(type)) properties[std::string(type.key())] = reference("node_" + std::string(type.key()));
    return {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}, {"minProperties", 1}, {"maxProperties", 1}};
}

Json definitions(const Catalogue& catalogue) {
    const Json id{{"type", "string"}, {"pattern", "^[a-z_][a-z0-9_]*$"}};
    Json out{{"id", id},
             {"names", {{"anyOf", Json::array({Json{{"type", "string"}}, Json{{"type", "array"}, {"items", {{"type", "string"}}}}})}}},
             {"color", {{"anyOf", Json::array({Json{{"type", "string"}, {"pattern", "^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})$"}},
                                               Json{{"enum", color_names()}}})}}},
             {"shape", one_key_node(catalogue, is_shape)},
             {"scene_node", one_key_node(catalogue, [](const NodeType& t) { return t.meta.kind != NodeKind::record; })}};
    for (const NodeType& type : catalogue.types()) {
        const bool group = type.part && type.part->role == Role::group;
        const std::string prefix = type.meta.kind == NodeKind::record ? "" : "node_";
        out[prefix + std::string(type.key())] = fields_schema(type, group ? "scene_node" : "shape");
    }
    return out;
}

Json test_schema() {
    const Json point = pair_of({{"anyOf", Json::array({Json{{"type", "number"}}, Json{{"type", "string"}}})}});
    const Json launch{{"type", "object"}, {"properties", {{"at", point}, {"velocity", point}}}, {"additionalProperties", false}};
    return {{"type", "object"},
            {"properties",
             {{"name", {{"type", "string"}}},
              {"launch", {{"anyOf", Json::array({launch, Json{{"type", "array"}, {"items", launch}}})}}},
              {"run", {{"type", Json::array({"number", "string"})}}},
              {"expect", {{"anyOf", Json::array({Json{{"type", "string"}}, Json{{"type", "array"}, {"items", {{"type", "string"}}}}})}}}}},
            {"additionalProperties", false}};
}

}  // namespace

std::string json_schema(const Catalogue& catalogue) {
    const Json properties{
        {"pinfield", {{"const", 1}, {"description", "Version of the format."}}},
        {"table", reference("table")},
        {"physics", reference("physics")},
        {"materials", {{"type", "object"}, {"additionalProperties", reference("material")}}},
        {"scene", {{"type", "array"}, {"items", reference("scene_node")}}},
        {"inputs", {{"type", "object"}, {"additionalProperties", reference("names")}}},
        {"tests", {{"type", "array"}, {"items", test_schema()}}}};
    const Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
                      {"title", "Pinfield table"},
                      {"type", "object"},
                      {"properties", properties},
                      {"required", Json::array({"pinfield"})},
                      {"additionalProperties", false},
                      {"definitions", definitions(catalogue)}};
    return schema.dump(2) + "\n";
}

}  // namespace pinfield
