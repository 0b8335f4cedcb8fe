#include "editor/param_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/numbers.h"

namespace pinfield::editor {
namespace {

/// The number a person would write for it: a multiple of a step is not exact in binary.
double as_written(double value) { return parse_number(fmt::format("{:.9g}", value)).value_or(value); }

double within(const Param& param, double value) {
    if (param.min) value = std::max(value, param.min->value);
    if (param.max) value = std::min(value, param.max->value);
    return value;
}

}  // namespace

double step_of(const Param& param) {
    if (param.step) return param.step->value;
    const double wanted = param.min && param.max ? (param.max->value - param.min->value) / 200 : std::fabs(param.value.value) / 100;
    return wanted > 0 ? std::pow(10, std::floor(std::log10(wanted))) : 0.001;
}

std::optional<double> share_of(const Param& param, double value) {
    if (!param.min || !param.max || param.max->value <= param.min->value) return {};
    return std::clamp((value - param.min->value) / (param.max->value - param.min->value), 0.0, 1.0);
}

double value_at(const Param& param, double share) {
    const double low = param.min->value, step = step_of(param);
    const double value = low + std::clamp(share, 0.0, 1.0) * (param.max->value - low);
    return within(param, as_written(low + step * std::round((value - low) / step)));
}

double stepped(const Param& param, double from, double steps) { return within(param, as_written(from + std::round(steps) * step_of(param))); }

}  // namespace pinfield::editor
