#include "engine/io/json_schema.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/io/field_json.h"
#include "engine/io/limits.h"
#include "engine/io/schema_parts.h"
#include "engine/io/section.h"
#include "engine/scene/part_traits.h"

namespace pinfield {
namespace {

using Json = nlohmann::ordered_json;

/// A text that a template's argument stands for.
const Json dollar{{"type", "string"}, {"pattern", R"(^\$[a-z_][a-z0-9_]*$)"}};

Json kind_schema(const FieldType& field) {
    switch (field.kind) {
        case FieldKind::boolean: return {{"type", "boolean"}};
        case FieldKind::integer: {
            Json out{{"type", "integer"}};
            if (std::isfinite(field.meta.min.value)) out["minimum"] = std::ceil(field.meta.min.value);
            if (std::isfinite(field.meta.max.value)) out["maximum"] = std::floor(field.meta.max.value);
            return {{"anyOf", {out, Json::parse(schema::expression())}}};
        }
        case FieldKind::number: return Json::parse(schema::number(field.meta));
        case FieldKind::vec2: return Json::parse(schema::pair(field.meta));
        case FieldKind::points:
            return {{"type", "array"}, {"items", Json::parse(schema::pair(field.meta))}, {"maxItems", Limits{}.points}};
        case FieldKind::choice: return {{"anyOf", {Json{{"enum", field.choices}}, dollar}}};
        case FieldKind::choices: {
            const Json word{{"anyOf", {Json{{"enum", field.choices}}, dollar}}};
            return {{"anyOf", {word, {{"type", "array"}, {"items", word}, {"maxItems", Limits{}.points}}}}};
        }
        case FieldKind::text:
            if (field.meta.meaning == Meaning::formula) return {{"type", {"string", "number"}}};
            return {{"type", {"string", "number", "boolean"}}};
        case FieldKind::color:
            return {{"type", "string"}, {"pattern", R"(^(#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})|[a-zA-Z]+|\$[a-z_][a-z0-9_]*)$)"}};
        case FieldKind::id: return {{"type", "string"}, {"pattern", R"(^\$?[a-z_][a-z0-9_]*$)"}};
        case FieldKind::names: return Json::parse(schema::reference("names"));
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

Json with_description(Json schema, std::string_view text) {
    schema["description"] = text;
    return schema;
}

Json type_schema(const NodeType& type);

/// What makes several nodes of one item, directly in the scene or a group.
void add_repetition(Json& properties) {
    FieldMeta length, angle;
    length.unit = Unit::metre;
    angle.unit = Unit::degree;
    const Json pair = Json::parse(schema::pair(length));
    properties["copies"] = {
        {"description", "Makes so many of the node, named .1 .2 ...; i is the number in its expressions."},
        {"type", "object"},
        {"required", {"count"}},
        {"additionalProperties", false},
        {"properties",
         {{"count", with_description(Json::parse(schema::any_number()), "How many.")},
          {"step", with_description(pair, "From each to the next.")},
          {"around", with_description(pair, "The point that they stand round.")},
          {"angle", with_description(Json::parse(schema::number(angle)), "From each to the next about that point; a full turn is shared else.")}}}};
    properties["pair"] = with_description(Json::parse(schema::number(length)),
                                          "Makes a second one, reflected in the line at this x; they are named .left and .right.");
}

/// A use of a template: a group's fields, and what the template is given.
Json use_schema(const Catalog& catalog) {
    Json out = type_schema(*catalog.find("group"));
    out["description"] = "Puts a template's nodes here.";
    Json& properties = out["properties"];
    properties.erase("children");
    properties["template"] = {{"description", "Its name."}, {"type", "string"}, {"pattern", schema::name_pattern}};
    properties["with"] = with_description(Json::parse(schema::named_map(R"({"type": ["number", "string"]})")), "Its arguments.");
    out["type"] = "object";
    out["required"] = {"template"};
    return out;
}

Json type_schema(const NodeType& type) {
    Json properties = Json::object(), required = Json::array();
    for (const FieldType& field : type.fields) {
        properties[std::string(field.key)] = field_schema(field);
        if (field.meta.required) required.push_back(field.key);
    }
    const ChildCount children = type.meta.children;
    if (children.max > 0) {
        Json list{{"type", "array"}, {"items", Json::parse(schema::reference(child_definition(type)))}, {"minItems", children.min}};
        if (children.max != any_number) list["maxItems"] = children.max;
        properties["children"] = list;
        if (children.min > 0) required.push_back("children");
    }
    if (type.meta.kind != NodeKind::record) add_repetition(properties);
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
            properties[std::string(type.key())] = Json::parse(schema::reference(std::string(type.key())));
    }
    return {{"type", "object"},
            {"minProperties", 1},
            {"maxProperties", 1},
            {"additionalProperties", false},
            {"properties", properties}};
}

}  // namespace

std::string json_schema(const Catalog& catalog) {
    Json definitions = Json::object();
    definitions["names"] = Json::parse(schema::one_or_list(fmt::format(R"({{"type": "string", "pattern": "{}"}})", R"(^\\$?[a-z_][a-z0-9_]*$)")));
    definitions["scene_node"] = one_key_node(catalog, true);
    definitions["scene_node"]["properties"]["use"] = Json::parse(schema::reference("use"));
    definitions["shape_node"] = one_key_node(catalog, false);
    for (const NodeType& type : catalog.types()) definitions[std::string(type.key())] = type_schema(type);
    definitions["use"] = use_schema(catalog);
    Json properties = Json::object();
    for (const Section* section : all_sections())
        if (section->schema) properties[std::string(section->key)] = Json::parse(section->schema());
    const Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
                      {"title", "Pinfield table"},
                      {"type", "object"},
                      {"additionalProperties", false},
                      {"required", {"pinfield"}},
                      {"properties", properties},
                      {"definitions", definitions}};
    return schema.dump(2) + "\n";
}

}  // namespace pinfield
