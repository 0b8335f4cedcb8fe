#include "engine/cli/json.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/core/numbers.h"

namespace pinfield::cli {

std::string json_text(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            (out += '\\') += c;
        else if (c == '\n')
            out += "\\n";
        else if (static_cast<unsigned char>(c) < 0x20)
            out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        else
            out += c;
    }
    return out + '"';
}

std::string json_number(double x) { return std::isfinite(x) ? to_text(x) : "null"; }

JsonObject& JsonObject::add_raw(std::string_view key, std::string_view json) {
    if (!members_.empty()) members_ += ", ";
    members_ += json_text(key);
    members_ += ": ";
    members_ += json;
    return *this;
}

std::string json_array(const std::vector<std::string>& values) { return fmt::format("[{}]", fmt::join(values, ", ")); }

}  // namespace pinfield::cli
