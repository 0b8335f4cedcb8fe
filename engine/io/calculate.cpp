#include "engine/io/calculate.h"

#include <fmt/format.h>

#include "engine/core/at.h"
#include "engine/scene/validate.h"

namespace pinfield {
namespace {

using Kind = NamedValue::Kind;

std::string no_such_name(const ReadContext& context, std::string_view name) {
    const std::vector<std::string_view> known = context.names ? context.names->all(Kind::number) : std::vector<std::string_view>();
    return known.empty() ? "name it under params" : suggestion(name, known);
}

/// What the names of an expression are here.
struct Bound {
    std::vector<Measure> measures;
    std::vector<double> values;
};

std::optional<Bound> bind(ReadContext& context, const YamlNode& node, const Expression& expression) {
    Bound out;
    bool good = true;
    for (const ExpressionName& name : expression.names) {
        const std::optional<NamedValue> found = number_named(context, node, name);
        good = good && found;
        if (!good) continue;
        out.measures.push_back(found->measure);
        out.values.push_back(found->value);
    }
    return good ? std::optional(std::move(out)) : std::nullopt;
}

bool is_literal(const Expression& expression) {
    const ExpressionNode& root = expression.nodes.back();
    const bool negated = root.operation == Operation::negate;
    return (negated ? at(expression.nodes, root.operands[0]) : root).operation == Operation::literal;
}

std::optional<Calculated> calculated(ReadContext& context, const YamlNode& node, const Dimension* due) {
    const auto refuse = [&](const ExpressionError& e) {
        context.report(e.code, span_within(context, node, e.span), e.message, e.hint);
        return std::nullopt;
    };
    const auto expression = parse_expression(node.text);
    if (!expression) return refuse(expression.error());
    const std::optional<Bound> names = bind(context, node, *expression);
    if (!names) return {};
    const auto measure = measure_of(*expression, names->measures);
    if (!measure) return refuse(measure.error());
    if (const auto why = why_unfit(*expression, *measure, due ? *due : measure->dimension)) return refuse(*why);
    const auto value = evaluate(*expression, names->values);
    if (!value) return refuse(value.error());
    return Calculated{*value, *measure, is_literal(*expression)};
}

}  // namespace

Span span_within(const ReadContext& context, const YamlNode& node, Span span) {
    const std::string_view held = context.source().slice(node.span);
    const std::size_t begin = held.find(node.text);
    if (begin == std::string_view::npos) return node.span;
    return {node.span.begin + begin + span.begin, node.span.begin + begin + span.end};
}

std::optional<NamedValue> number_named(ReadContext& context, const YamlNode& node, const ExpressionName& name) {
    const NamedValue* found = context.names ? context.names->find(name.text) : nullptr;
    if (found && found->kind == Kind::number) return *found;
    const Span where = span_within(context, node, name.span);
    if (!found)
        context.report(Code::unknown_name, where, fmt::format("nothing is called {} here", name.text), no_such_name(context, name.text));
    else if (found->kind == Kind::text)
        context.report(Code::wrong_type, where, fmt::format("{} is a text, and a number is due here", name.text),
                       fmt::format("where a text is due: ${}", name.text));
    else
        context.fail_silently();
    return {};
}

std::string shortened(std::string_view text) {
    return text.size() <= 40 ? std::string(text) : std::string(text.substr(0, 37)) + "...";
}

std::optional<Calculated> calculate(ReadContext& context, const YamlNode& node) { return calculated(context, node, nullptr); }

std::optional<double> calculate(ReadContext& context, const YamlNode& node, const Dimension& due) {
    const std::optional<Calculated> out = calculated(context, node, &due);
    return out ? std::optional(out->value) : std::nullopt;
}

std::optional<std::string> resolve_text(ReadContext& context, const YamlNode& node) {
    if (node.text.size() < 2 || node.text[0] != '$' || !is_name(node.text.substr(1))) return std::string(node.text);
    const std::string_view name = node.text.substr(1);
    const NamedValue* found = context.names ? context.names->find(name) : nullptr;
    if (found && found->kind == Kind::text) {
        context.written.push_back({context.parts_read, std::string(node.text)});
        return found->text;
    }
    if (!found) {
        const std::vector<std::string_view> known = context.names ? context.names->all(Kind::text) : std::vector<std::string_view>();
        context.report(Code::unknown_name, node.span, fmt::format("no text is called {} here", name),
                       known.empty() ? "a template's arguments may be texts" : suggestion(name, known));
    } else if (found->kind == Kind::number) {
        context.report(Code::wrong_type, node.span, fmt::format("{} is a number, and a text is due here", name));
    } else {
        context.fail_silently();
    }
    return {};
}

}  // namespace pinfield
