#include "engine/cli/json.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/core/numbers.h"
#include "engine/core/shown.h"

namespace pinfield::cli {
namespace {

/// RFC 8259, section 7: of what lies beyond 16 bits, both halves of a surrogate pair.
std::string json_escape(unsigned code) {
    if (code < 0x10000) return fmt::format("\\u{:04x}", code);
    return fmt::format("\\u{:04x}\\u{:04x}", 0xd800 + ((code - 0x10000) >> 10), 0xdc00 + ((code - 0x10000) & 0x3ff));
}

}  // namespace

std::string json_text(std::string_view text) {
    std::string out = "\"";
    for (std::size_t at = 0; at < text.size();) {
        const CharacterAt here = character_at(text, at);
        if (here.code == '"' || here.code == '\\')
            (out += '\\') += static_cast<char>(here.code);
        else if (here.code == '\n')
            out += "\\n";
        else if (here.is_harmless)
            out += text.substr(at, here.bytes);
        else
            out += json_escape(here.is_utf8 ? here.code : 0xfffdu);
        at += here.bytes;
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
