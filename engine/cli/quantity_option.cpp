#include "engine/cli/quantity_option.h"

#include <fmt/format.h>

#include "engine/core/numbers.h"
#include "engine/io/quantity.h"

namespace pinfield::cli {

std::string why_invalid_quantity(const std::string& text, Unit unit, Limit min, Limit max, double* value) {
    const QuantityResult quantity = read_quantity(text, unit);
    if (!quantity) return quantity.error().message;
    const double x = quantity->value;
    if (min.open ? !(x > min.value) : !(x >= min.value))
        return fmt::format("{} must be {} {}", text, min.open ? "above" : "at least", to_text(min.value));
    if (max.open ? !(x < max.value) : !(x <= max.value))
        return fmt::format("{} must be {} {}", text, max.open ? "below" : "at most", to_text(max.value));
    if (value) *value = x;
    return "";
}

Option add_quantity(const Command& command, const std::string& name, std::optional<double>& target, Unit unit, Limit min, Limit max,
                    const std::string& doc) {
    const auto take = [&target, unit, min, max](const std::string& text) {
        double value = 0;
        const std::string complaint = why_invalid_quantity(text, unit, min, max, &value);
        if (complaint.empty()) target = value;
        return complaint;
    };
    return command.option(name, take, doc);
}

}  // namespace pinfield::cli
