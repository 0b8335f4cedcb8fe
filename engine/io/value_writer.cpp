#include "engine/io/value_writer.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/core/numbers.h"
#include "engine/io/quantity.h"

namespace pinfield {
namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

bool may_be_plain(std::string_view text) {
    if (text.empty() || text.front() == ' ' || text.back() == ' ' || text.back() == ':') return false;
    if (std::string_view("-?:,[]{}#&*!|>'\"%@`~.=<").find(text.front()) != std::string_view::npos) return false;
    if (text == "null" || text == "Null" || text == "NULL") return false;
    if (text.find_first_of(",[]{}") != std::string_view::npos || text.find(": ") != std::string_view::npos ||
        text.find(" #") != std::string_view::npos)
        return false;
    return std::none_of(text.begin(), text.end(), is_control);
}

std::string double_quoted(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            out += fmt::format("\\{}", c);
        else if (c == '\n')
            out += "\\n";
        else if (c == '\t')
            out += "\\t";
        else if (is_control(c))
            out += fmt::format("\\x{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
        else
            out += c;
    }
    return out + '"';
}

std::string single_quoted(std::string_view text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
    return out + '\'';
}

template <class List, class Write>
std::string list_text(const List& list, Write write) {
    std::string out = "[";
    for (const auto& item : list) out += (out.size() > 1 ? ", " : "") + write(item);
    return out + "]";
}

std::string in_quotes_of(std::string_view text, const YamlNode* scalar) {
    if (scalar && scalar->style == YamlStyle::double_quoted) return double_quoted(text);
    if (scalar && scalar->style == YamlStyle::single_quoted) return single_quoted(text);
    return std::string(text);
}

}  // namespace

std::string write_text(std::string_view text, YamlStyle style) {
    const bool breaks = std::any_of(text.begin(), text.end(), is_control);
    if (style == YamlStyle::single_quoted && !breaks) return single_quoted(text);
    if (style == YamlStyle::plain && may_be_plain(text)) return std::string(text);
    return double_quoted(text);
}

std::string write_number_like(const FieldType& field, double value, const YamlNode* scalar) {
    return in_quotes_of(
        write_quantity(value, field.meta.unit, scalar && scalar->kind == YamlKind::scalar ? scalar->text : ""), scalar);
}

std::string write_scalar_like(const FieldType& field, const Value& value, const YamlNode& scalar) {
    if (const double* number = std::get_if<double>(&value)) return write_number_like(field, *number, &scalar);
    if (const auto* text = std::get_if<std::string>(&value)) return write_text(*text, scalar.style);
    if (const auto* names = std::get_if<std::vector<std::string>>(&value); names && names->size() == 1)
        return write_text(names->front(), scalar.style);
    const std::string plain = write_value(field, value);
    return std::holds_alternative<bool>(value) || std::holds_alternative<std::int64_t>(value)
               ? in_quotes_of(plain, &scalar)
               : plain;
}

namespace {

/// An expression as a text that stands in a list or a map: quoted where a comma would split it.
std::string expression_text(const WrittenParts& written, int index) {
    for (const WrittenPart& part : written)
        if (part.index == index) return write_text(part.text);
    return {};
}

std::string write(const FieldType& field, const Value& value, std::string_view like, const WrittenParts& written) {
    int parts = 0;
    const auto number_text = [&](double number) {
        const std::string expression = expression_text(written, parts++);
        return expression.empty() ? write_quantity(number, field.meta.unit, like) : expression;
    };
    const auto pair_text = [&](const Vec2& v) {
        const std::string x = number_text(v.x()), y = number_text(v.y());
        return fmt::format("[{}, {}]", x, y);
    };
    if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    if (const auto* integer = std::get_if<std::int64_t>(&value))
        return written.empty() ? fmt::format("{}", *integer) : expression_text(written, 0);
    if (const double* number = std::get_if<double>(&value)) return number_text(*number);
    if (const Vec2* pair = std::get_if<Vec2>(&value)) return pair_text(*pair);
    if (const auto* points = std::get_if<std::vector<Vec2>>(&value)) return list_text(*points, pair_text);
    const auto word = [&](const std::string& text) {
        std::string expression = expression_text(written, parts++);
        return expression.empty() ? write_text(text) : expression;
    };
    if (const auto* names = std::get_if<std::vector<std::string>>(&value))
        return names->size() == 1 ? word(names->front()) : list_text(*names, word);
    return word(std::get<std::string>(value));
}

}  // namespace

std::string write_value(const FieldType& field, const Value& value, std::string_view like) { return write(field, value, like, {}); }

std::string write_slot(const FieldType& field, const FieldSlot& slot, std::string_view like) {
    return write(field, slot.value, like, slot.written ? *slot.written : WrittenParts{});
}

}  // namespace pinfield
