// The node reference and the JSON Schema say what the catalog says.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "engine/io/json_schema.h"
#include "engine/io/node_reference.h"
#include "engine/io/starters.h"
#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;
using Json = nlohmann::json;

TEST_CASE("the node reference as JSON has every node with the keys that programs rely on") {
    const auto types = referenced_types(*catalog());
    const Json all = Json::parse(reference_json(types));
    REQUIRE(all.is_array());
    REQUIRE(all.size() == types.size());
    for (std::size_t i = 0; i < types.size(); ++i) {
        const Json& node = all[i];
        CHECK(node["key"] == std::string(types[i]->key()));
        for (const char* key : {"key", "kind", "doc", "exactness", "fields", "children"}) CHECK(node.contains(key));
        CHECK(node.size() == 6);
        for (const char* key : {"outside", "inside", "lipschitz"}) CHECK(node["exactness"].contains(key));
        CHECK(node["children"].contains("max"));
        REQUIRE(node["fields"].size() == types[i]->fields.size());
        for (const Json& field : node["fields"]) {
            for (const char* key : {"key", "type", "unit", "default", "min", "min_open", "doc"})
                CHECK(field.contains(key));
            CHECK(field.size() == 7);
        }
    }
    const Json circle = Json::parse(reference_json(referenced_types(*catalog(), "circle")));
    CHECK(
        circle[0]["fields"][0] ==
        Json::parse(
            R"({"key": "radius", "type": "number", "unit": "m", "default": 0.05, "min": 0.0, "min_open": true, "doc": "From the centre to the rim."})"));
    CHECK(referenced_types(*catalog(), "nosuch").empty());
    CHECK(referenced_types(*catalog(), "physics").size() == 1);
}

TEST_CASE("text and Markdown name every node and field") {
    const auto types = referenced_types(*catalog());
    const std::string text = reference_text(types), markdown = reference_markdown(types);
    for (const NodeType* type : types) {
        CHECK(markdown.find("## " + std::string(type->key()) + "\n") != std::string::npos);
        for (const FieldType& field : type->fields) {
            CHECK(text.find("    " + std::string(field.key) + " ") != std::string::npos);
            CHECK(markdown.find("| `" + std::string(field.key) + "` |") != std::string::npos);
        }
    }
}

TEST_CASE("the schema describes every node, field and section") {
    const Json schema = Json::parse(json_schema(*catalog()));
    CHECK(schema["$schema"] == "http://json-schema.org/draft-07/schema#");
    for (const NodeType& type : catalog()->types()) {
        const Json& node = schema["definitions"][std::string(type.key())];
        CHECK(node["additionalProperties"] == false);
        for (const FieldType& field : type.fields) CHECK(node["properties"].contains(std::string(field.key)));
        CHECK(node["properties"].contains("children") == (type.meta.children.max > 0));
        CHECK(schema["definitions"]["scene_node"]["properties"].contains(std::string(type.key())) ==
              (type.meta.kind != NodeKind::record));
    }
    CHECK_FALSE(schema["definitions"]["shape_node"]["properties"].contains("bumper"));
    CHECK(schema["definitions"]["bumper"]["properties"]["children"]["items"]["$ref"] == "#/definitions/shape_node");
    CHECK(schema["definitions"]["group"]["properties"]["children"]["items"]["$ref"] == "#/definitions/scene_node");
    for (const char* section : {"pinfield", "table", "physics", "materials", "scene", "inputs", "tests"})
        CHECK(schema["properties"].contains(section));
}

TEST_CASE("the schema that is committed is this version's: `pinfield schema > scenes/table.schema.json` renews it") {
    CHECK((file_text(std::filesystem::path(source_dir()) / "scenes/table.schema.json") == json_schema(*catalog())));
}

TEST_CASE("every shipped table tells text editors where its schema is, and there it is") {
    for (const char* folder : {"tables", "nodes"})
        for (const auto& path : scene_files(folder)) {
            INFO(path);
            const std::string schema = "../table.schema.json";
            CHECK(file_text(path).starts_with(modeline(schema)));
            CHECK(std::filesystem::exists(path.parent_path() / schema));
        }
}
