#include "engine/io/value_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "engine/core/closest.h"
#include "engine/core/color.h"
#include "engine/core/numbers.h"
#include "engine/io/calculate.h"
#include "engine/io/formula_reader.h"
#include "engine/io/quantity.h"
#include "engine/scene/validate.h"
#include "engine/io/yaml_text.h"

namespace pinfield {
namespace {

void report_shape(ReadContext& context, const YamlNode& node, std::string_view wanted) {
    if (node.kind == YamlKind::map && (node.find("spin") || node.find("wave") || node.find("keys")))
        return context.report(Code::motion_unsupported, node.span, "motions are not supported yet", "write a number");
    const char* found = node.kind == YamlKind::map        ? "a map"
                        : node.kind == YamlKind::sequence ? "a list"
                                                          : "a single value";
    context.report(Code::wrong_shape, node.span, fmt::format("{} is due here, not {}", wanted, found));
}

/// "0 m (18mm - 18mm)": what an expression gives here, for a message.
std::string value_text(double value, const FieldMeta& meta, const YamlNode& node) {
    const std::string unit = symbol(dimension_of(meta.unit));
    return fmt::format("{}{}{} ({})", to_text(value), unit.empty() ? "" : " ", unit, shortened(node.text));
}

std::optional<double> read_number(ReadContext& context, const FieldMeta& meta, const YamlNode& node) {
    if (node.kind != YamlKind::scalar) return report_shape(context, node, "a number"), std::nullopt;
    const QuantityResult read = read_quantity(node.text, meta.unit);
    FieldType plain{"", FieldKind::number, meta, {}, {}, false};
    if (!read && read.error().may_be_expression) {
        if (report_comma_split(context, node)) return {};
        const std::optional<double> value = calculate(context, node, dimension_of(meta.unit));
        if (value) context.written.push_back({context.parts_read, std::string(node.text)});
        ++context.parts_read;
        const auto why = value ? why_invalid(plain, Value(*value)) : std::nullopt;
        if (!why) return value;
        context.report(Code::out_of_range, node.span, fmt::format("{} {}", value_text(*value, meta, node), *why));
        return {};
    }
    ++context.parts_read;
    if (!read) {
        const bool wrong_type = read.error().code == Code::wrong_type;
        context.report(
            read.error().code, node.span,
            wrong_type ? fmt::format("a number is due here, not {}", shortened(node.text)) : read.error().message,
            read.error().hint);
        return {};
    }
    if (const auto why = why_invalid(plain, Value(read->value))) {
        context.report(Code::out_of_range, node.span, fmt::format("{} {}", shortened(node.text), *why));
        return {};
    }
    return read->value;
}

std::optional<Value> read_integer(ReadContext& context, const FieldType& field, const YamlNode& node) {
    FieldMeta unbounded;
    const auto number = read_number(context, unbounded, node);
    if (!number) return {};
    if (*number != std::floor(*number)) {
        context.report(Code::wrong_type, node.span, fmt::format("{} must be a whole number", field.key));
        return {};
    }
    if (std::fabs(*number) > 2147483647.0) {
        context.report(Code::out_of_range, node.span, fmt::format("{} is too large", shortened(node.text)));
        return {};
    }
    const Value value = static_cast<std::int64_t>(*number);
    if (const auto why = why_invalid(field, value)) {
        context.report(Code::out_of_range, node.span, fmt::format("{} {}", field.key, *why));
        return {};
    }
    return value;
}

std::optional<Vec2> read_vec2(ReadContext& context, const FieldMeta& meta, const YamlNode& node) {
    if (node.kind != YamlKind::sequence) return report_shape(context, node, "a pair [x, y]"), std::nullopt;
    if (node.items.size() != 2) {
        for (const YamlNode* item : node.items)
            if (report_comma_split(context, item->resolved())) return {};
        context.report(Code::wrong_shape, node.span,
                       fmt::format("a pair [x, y] is due here, not {} values", node.items.size()));
        return {};
    }
    const auto x = read_number(context, meta, node.items[0]->resolved());
    const auto y = read_number(context, meta, node.items[1]->resolved());
    if (!x || !y) return {};
    return Vec2(*x, *y);
}

std::optional<Value> read_points(ReadContext& context, const FieldType& field, const YamlNode& node) {
    if (node.kind != YamlKind::sequence)
        return report_shape(context, node, "a list of pairs [[x, y], ...]"), std::nullopt;
    if (node.items.size() > context.limits.points) {
        context.report(Code::too_many_points, node.span,
                       fmt::format("{} points; at most {} are read", node.items.size(), context.limits.points));
        return {};
    }
    std::vector<Vec2> points;
    bool good = true;
    for (const YamlNode* item : node.items) {
        if (context.full()) return {};
        const auto point = read_vec2(context, field.meta, item->resolved());
        if (point)
            points.push_back(*point);
        else
            good = false;
    }
    if (!good) return {};
    return points;
}

std::optional<Value> read_boolean(ReadContext& context, const FieldType& field, const YamlNode& node) {
    if (node.kind == YamlKind::scalar && (node.text == "true" || node.text == "false")) return node.text == "true";
    context.report(Code::wrong_type, node.span, fmt::format("{} must be true or false", field.key));
    return {};
}

/// The text of a part of the value: as it stands, or what a $name stands for.
std::optional<std::string> read_text(ReadContext& context, const YamlNode& node) {
    std::optional<std::string> text = resolve_text(context, node);
    ++context.parts_read;
    return text;
}

std::optional<std::string> read_name(ReadContext& context, const FieldType& field, const YamlNode& node) {
    if (node.kind != YamlKind::scalar) return report_shape(context, node, "a name"), std::nullopt;
    std::optional<std::string> text = read_text(context, node);
    if (!text) return {};
    if (!is_name(*text)) {
        context.report(
            Code::bad_name, node.span,
            fmt::format("{} is not a valid {}", text->empty() ? "an empty text" : shortened(*text), field.key),
            "small letters, digits and _, not beginning with a digit");
        return {};
    }
    return text;
}

/// A list of what `read_item` reads of each item, at most `most` of them, or one alone without the brackets.
template <class ReadItem>
std::optional<Value> read_texts(ReadContext& context, const YamlNode& node, std::size_t most, const ReadItem& read_item) {
    std::vector<std::string> texts;
    bool good = true;
    const auto take = [&](const YamlNode& item) {
        std::optional<std::string> text = read_item(item);
        if (text) texts.push_back(std::move(*text));
        else good = false;
    };
    if (node.kind != YamlKind::sequence) {
        take(node);
    } else if (node.items.size() > most) {
        context.report(Code::too_many_points, node.span, fmt::format("{} words; at most {} are read", node.items.size(), most));
        return {};
    } else {
        for (const YamlNode* item : node.items)
            if (!context.full()) take(item->resolved());
    }
    if (!good) return {};
    return texts;
}

std::optional<std::string> read_color(ReadContext& context, const FieldType& field, const YamlNode& node) {
    if (node.kind != YamlKind::scalar) return report_shape(context, node, fmt::format("a {}", name(field.kind))), std::nullopt;
    const std::optional<std::string> text = read_text(context, node);
    if (!text || parse_color(*text)) return text;
    const bool hex = (text->size() == 3 || text->size() == 6) && text->find_first_not_of("0123456789abcdefABCDEF") == std::string::npos;
    std::string hint = R"(a CSS name, or a quoted "#rgb" or "#rrggbb")";
    if (hex)
        hint = fmt::format("write \"#{}\", with the quotes", *text);
    else if (const auto close = closest_match(*text, color_names()))
        hint = fmt::format("did you mean {}?", *close);
    context.report(Code::unknown_color, node.span, fmt::format("{} is no color", shortened(*text)), hint);
    return {};
}

/// A text, or one of the words that a field chooses from.
std::optional<std::string> read_word(ReadContext& context, const FieldType& field, const YamlNode& node) {
    if (node.kind != YamlKind::scalar)
        return report_shape(context, node, fmt::format("a {}", name(field.choices.empty() ? field.kind : FieldKind::choice))), std::nullopt;
    std::optional<std::string> word = read_text(context, node);
    if (!word) return {};
    const Value value = field.kind == FieldKind::choices ? Value(std::vector{*word}) : Value(*word);
    if (const auto why = why_invalid(field, value)) {
        context.report(Code::unknown_choice, node.span, fmt::format("{} {}", field.key, *why), suggestion(*word, field.choices));
        return {};
    }
    return word;
}

std::optional<Value> as_value(std::optional<std::string> text) {
    return text ? std::optional<Value>(std::move(*text)) : std::nullopt;
}

}  // namespace

void report_missing_value(ReadContext& context, const YamlNode& key, const YamlNode& value) {
    const std::string_view text = context.source().text();
    if (const auto color = color_in_comment(text, value.span.begin, line_end(text, value.span.begin)))
        return context.report(Code::comment_ate_value, {*color, *color + 1},
                              fmt::format("this # begins a comment, so {} has no value", key.text),
                              "quote the color: \"#7c5\"");
    context.report(Code::missing_value, key.span, fmt::format("{} has no value", shortened(key.text)));
}

bool report_comma_split(ReadContext& context, const YamlNode& value) {
    if (value.kind != YamlKind::scalar || value.style != YamlStyle::plain) return false;
    if (std::count(value.text.begin(), value.text.end(), '(') <= std::count(value.text.begin(), value.text.end(), ')'))
        return false;
    // Its own field may have reported it already.
    const auto reported = [&](const Diagnostic& d) {
        return d.where == context.source().place(value.span) && d.code == entry(Code::comma_split).code;
    };
    if (std::none_of(context.diagnostics.begin(), context.diagnostics.end(), reported))
        context.report(Code::comma_split, value.span, "a comma split this expression", "quote it");
    return true;
}

std::optional<Value> read_value(ReadContext& context, const FieldType& field, const YamlNode& node) {
    switch (field.kind) {
        case FieldKind::boolean: return read_boolean(context, field, node);
        case FieldKind::integer: return read_integer(context, field, node);
        case FieldKind::number: {
            const auto number = read_number(context, field.meta, node);
            return number ? std::optional<Value>(*number) : std::nullopt;
        }
        case FieldKind::vec2: {
            const auto pair = read_vec2(context, field.meta, node);
            return pair ? std::optional<Value>(*pair) : std::nullopt;
        }
        case FieldKind::points: return read_points(context, field, node);
        case FieldKind::id: return as_value(read_name(context, field, node));
        case FieldKind::names:
            return read_texts(context, node, context.limits.events, [&](const YamlNode& item) { return read_name(context, field, item); });
        case FieldKind::choices:
            return read_texts(context, node, context.limits.points, [&](const YamlNode& item) { return read_word(context, field, item); });
        case FieldKind::color: return as_value(read_color(context, field, node));
        case FieldKind::text:
            if (field.meta.meaning == Meaning::formula) return as_value(read_formula(context, field, node));
            [[fallthrough]];
        case FieldKind::choice: return as_value(read_word(context, field, node));
    }
    return {};
}

}  // namespace pinfield
