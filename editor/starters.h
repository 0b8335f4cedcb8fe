// The tables that File > New offers: small, played as they are, and worth reading.
#pragma once
#include <span>
#include <string_view>

namespace pinfield::editor {

struct Starter {
    std::string_view action;  ///< "new.classic"
    std::string_view title, doc;
    std::string_view text;
};

/// The first is what a new window begins with.
std::span<const Starter> starters();

}  // namespace pinfield::editor
