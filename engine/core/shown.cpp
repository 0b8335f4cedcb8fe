#include "engine/core/shown.h"

#include <fmt/format.h>

namespace pinfield {
namespace {

unsigned byte_at(std::string_view text, std::size_t at) { return static_cast<unsigned char>(text[at]); }

/// Of a well-formed sequence of `length` bytes.
unsigned code_point(std::string_view text, std::size_t at, std::size_t length) {
    if (length == 1) return byte_at(text, at);
    unsigned code = byte_at(text, at) & (0x7fu >> length);
    for (const char byte : text.substr(at + 1, length - 1)) code = code << 6 | (static_cast<unsigned char>(byte) & 0x3fu);
    return code;
}

bool is_control(unsigned c) { return c < 0x20 || (c >= 0x7f && c < 0xa0); }

/// Characters that one does not see and that change how others are seen.
bool deceives(unsigned c) {
    return c == 0xad || c == 0x61c || c == 0x200b || c == 0x200e || c == 0x200f || (c >= 0x2028 && c <= 0x202e) || (c >= 0x2060 && c <= 0x206f) || c == 0xfeff ||
           (c >= 0xfff9 && c <= 0xfffb) || (c >= 0xe0000 && c <= 0xe007f);
}

void append_escaped(std::string& out, unsigned c) {
    if (c == '\n') out += "\\n";
    else if (c == '\t') out += "\\t";
    else if (c == '\r') out += "\\r";
    else if (c < 0x100) out += fmt::format("\\x{:02x}", c);
    else out += fmt::format("\\u{:04x}", c);
}

std::string escaped(std::string_view text, bool keeps_lines) {
    std::string out;
    out.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        const CharacterAt here = character_at(text, at);
        if (here.is_harmless || (keeps_lines && here.code == '\n'))
            out += text.substr(at, here.bytes);
        else
            append_escaped(out, here.code);
        at += here.bytes;
    }
    return out;
}

}  // namespace

std::size_t utf8_length(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) {
        return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0u;
    };
    const auto follows = [&](std::size_t count) {
        for (std::size_t i = 1; i <= count; ++i)
            if ((byte(i) & 0xC0u) != 0x80u) return false;
        return true;
    };
    const unsigned a = byte(0), b = byte(1);
    if (a < 0x80) return 1;
    if (a >= 0xC2 && a <= 0xDF) return follows(1) ? 2 : 0;
    if (a >= 0xE0 && a <= 0xEF) {
        const bool overlong = a == 0xE0 && b < 0xA0, surrogate = a == 0xED && b > 0x9F;
        return follows(2) && !overlong && !surrogate ? 3 : 0;
    }
    if (a >= 0xF0 && a <= 0xF4) {
        const bool overlong = a == 0xF0 && b < 0x90, beyond = a == 0xF4 && b > 0x8F;
        return follows(3) && !overlong && !beyond ? 4 : 0;
    }
    return 0;
}

CharacterAt character_at(std::string_view text, std::size_t at) {
    const std::size_t length = utf8_length(text, at);
    if (length == 0) return {byte_at(text, at), 1, false, false};
    const unsigned code = code_point(text, at, length);
    return {code, length, true, !is_control(code) && !deceives(code)};
}

std::string shown(std::string_view text) { return escaped(text, false); }
std::string shown_lines(std::string_view text) { return escaped(text, true); }

}  // namespace pinfield
