// The words of an expression: for its parser.
#pragma once
#include <optional>
#include <string_view>

#include "engine/expression/expression.h"

namespace pinfield {

struct Token {
    enum class Sort : unsigned char { end, number, name, sign };
    Sort sort = Sort::end;
    Span span;
    std::string_view text;               ///< of a number: with its unit
    double value = 0;                    ///< of a number
    const UnitSuffix* suffix = nullptr;  ///< of a number; null: bare
};

/// The token that begins at or behind `at`, or what is wrong there.
tl::expected<Token, ExpressionError> next_token(std::string_view text, std::size_t at);

}  // namespace pinfield
