// What is wrong with a text that a formula reads.
#pragma once
#include <string>

#include "engine/core/error_codes.h"

namespace pinfield {

/// Why a text may not stand in a field. `span` lies within it.
struct TextFault {
    Code code = Code::bad_expression;
    Span span;
    std::string message;
    std::string hint;
};

}  // namespace pinfield
