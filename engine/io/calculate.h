// What stands where a number or a word is due and is more than that: expressions, and names after $.
#pragma once
#include <optional>
#include <string>

#include "engine/expression/expression.h"
#include "engine/io/read_context.h"

namespace pinfield {

/// What an expression comes to, in m, deg, s, kg and what they make.
struct Calculated {
    double value = 0;
    Measure measure{};
    bool is_literal = false;  ///< a number with or without sign and unit: nothing is calculated
};

/// The expression that a scalar holds, whatever it measures; nothing, and the reason reported, where it has no value here.
std::optional<Calculated> calculate(ReadContext& context, const YamlNode& node);
/// The same where only one dimension will do.
std::optional<double> calculate(ReadContext& context, const YamlNode& node, const Dimension& due);

/// The number that a name of a scalar's expression stands for; nothing, and the reason reported, where it stands for none.
std::optional<NamedValue> number_named(ReadContext& context, const YamlNode& node, const ExpressionName& name);
/// Bytes of a scalar's text as bytes of the file; the whole scalar where the file does not hold its text letter by letter.
Span span_within(const ReadContext& context, const YamlNode& node, Span span);

/// The text of a scalar, or, of a $name, the text that the name stands for; nothing, and the reason reported, where it stands for none.
std::optional<std::string> resolve_text(ReadContext& context, const YamlNode& node);

/// Text up to a length that a message can bear.
std::string shortened(std::string_view text);

}  // namespace pinfield
