#include "engine/io/schema_parts.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/io/quantity.h"
#include "engine/reflect/node_type.h"

namespace pinfield::schema {
namespace {

using Json = nlohmann::ordered_json;

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) out += c == '^' ? std::string("\\^") : std::string(1, c);
    return out;
}

/// A number with one of the unit's suffixes, or without.
std::string quantity_pattern(Unit unit) {
    std::string suffixes;
    for (const UnitSuffix& s : unit_suffixes())
        if (s.dimension == dimension_of(unit)) suffixes.append(suffixes.empty() ? "" : "|").append(escaped(s.text));
    const std::string number = R"([+-]?((0|[1-9][0-9]*)(\.[0-9]*)?|\.[0-9]+)([eE][+-]?[0-9]+)?)";
    return suffixes.empty() ? fmt::format("^{}$", number) : fmt::format("^{}({})?$", number, suffixes);
}

}  // namespace

std::string reference(std::string_view definition) { return fmt::format(R"({{"$ref": "#/definitions/{}"}})", definition); }

std::string expression() { return R"({"type": "string", "pattern": "^.+[-+*/%^(].*$|^[a-z_][a-z0-9_]*$"})"; }

std::string number(const FieldMeta& meta) {
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
    const Json schema{{"anyOf", {bare, {{"type", "string"}, {"pattern", quantity_pattern(meta.unit)}}, Json::parse(expression())}}};
    return schema.dump();
}

std::string any_number() { return R"({"type": ["number", "string"]})"; }

std::string pair(const FieldMeta& meta) {
    return fmt::format(R"({{"type": "array", "items": {}, "minItems": 2, "maxItems": 2}})", number(meta));
}

std::string one_or_list(std::string_view item) {
    return fmt::format(R"({{"anyOf": [{0}, {{"type": "array", "items": {0}}}]}})", item);
}

std::string named_map(std::string_view value) {
    return fmt::format(R"({{"type": ["object", "null"], "propertyNames": {{"pattern": "{}"}}, "additionalProperties": {}}})", name_pattern,
                       value);
}

std::string list(std::string_view item) { return fmt::format(R"({{"type": ["array", "null"], "items": {}}})", item); }

}  // namespace pinfield::schema
