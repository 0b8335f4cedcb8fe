#include "engine/io/formula_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/core/at.h"
#include "engine/core/numbers.h"
#include "engine/io/calculate.h"

namespace pinfield {
namespace {

bool is_coordinate(std::string_view name) { return name == "x" || name == "y"; }

/// A number as an expression says it, whatever it measures: (0.046 * 1m), (0.0004 * 1m ^ 2).
std::string spelled(double value, const Measure& measure) {
    std::string out = fmt::format("({}", to_text(value));
    const auto times = [&](int exponent, std::string_view unit) {
        if (exponent == 1) out += fmt::format(" * 1{}", unit);
        else if (exponent != 0) out += fmt::format(" * 1{} ^ {}", unit, exponent);
    };
    times(measure.dimension.length, "m");
    times(measure.dimension.angle, "deg");
    times(measure.dimension.time, "s");
    times(measure.dimension.mass, "kg");
    return out.append(1, ')');
}

/// The author's text with numbers in place of all names but x and y.
class Filling {
public:
    Filling(ReadContext& context, const YamlNode& node) : context_(context), node_(node), text_(node.text) {}

    std::optional<std::string> run() {
        auto expression = parse_expression(text_);
        if (!expression) return refused(expression.error());
        std::vector<Measure> measures;
        for (const ExpressionName& name : expression->names) {
            if (!bind(name)) return {};
            measures.push_back(values_.back().measure);
        }
        const auto measure = measure_of(*expression, measures);
        if (!measure) return refused(measure.error());
        if (const auto why = why_unfit(*expression, *measure, {1, 0, 0, 0})) return refused(*why);
        return filled(*expression);
    }

private:
    std::optional<std::string> refused(const ExpressionError& error) {
        context_.report(error.code, span_within(context_, node_, error.span), error.message, error.hint);
        return {};
    }

    bool bind(const ExpressionName& name) {
        if (is_coordinate(name.text)) {
            values_.push_back({.value = 0, .measure = {{1, 0, 0, 0}, false, false}, .text = name.text});
            return true;
        }
        std::optional<NamedValue> found = number_named(context_, node_, name);
        if (!found) return false;
        found->text = spelled(found->value, found->measure);
        values_.push_back(std::move(*found));
        return true;
    }

    std::string filled(const Expression& expression) const {
        std::vector<const ExpressionNode*> names;
        for (const ExpressionNode& node : expression.nodes)
            if (node.operation == Operation::name) names.push_back(&node);
        std::sort(names.begin(), names.end(), [](const auto* a, const auto* b) { return a->span.begin < b->span.begin; });
        std::string out;
        std::size_t copied = 0;
        for (const ExpressionNode* name : names) {
            out.append(text_, copied, name->span.begin - copied).append(at(values_, name->operands[0]).text);
            copied = name->span.end;
        }
        return out.append(text_, copied, std::string::npos);
    }

    ReadContext& context_;
    const YamlNode& node_;
    std::string text_;
    std::vector<NamedValue> values_;  ///< parallel to the expression's names
};

}  // namespace

std::optional<std::string> read_formula(ReadContext& context, const FieldType& field, const YamlNode& node) {
    if (node.kind != YamlKind::scalar) {
        context.report(Code::wrong_shape, node.span, fmt::format("{} is an expression of x and y", field.key), "write it as one text");
        return {};
    }
    if (report_comma_split(context, node)) return {};
    std::optional<std::string> out = Filling(context, node).run();
    if (out && *out != node.text) context.written.push_back({context.parts_read, std::string(node.text)});
    ++context.parts_read;
    return out;
}

}  // namespace pinfield
