#include "engine/reflect/value.h"

#include <algorithm>
#include <bit>

namespace pinfield {
namespace {

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }
bool same_bits(const Vec2& a, const Vec2& b) { return same_bits(a.x(), b.x()) && same_bits(a.y(), b.y()); }

}  // namespace

bool identical(const Value& a, const Value& b) {
    if (a.index() != b.index()) return false;
    if (const double* x = std::get_if<double>(&a)) return same_bits(*x, std::get<double>(b));
    if (const Vec2* p = std::get_if<Vec2>(&a)) return same_bits(*p, std::get<Vec2>(b));
    if (const auto* list = std::get_if<std::vector<Vec2>>(&a)) {
        const auto& other = std::get<std::vector<Vec2>>(b);
        return std::equal(list->begin(), list->end(), other.begin(), other.end(),
                          [](const Vec2& p, const Vec2& q) { return same_bits(p, q); });
    }
    return a == b;
}

std::string_view name(FieldKind kind) {
    switch (kind) {
        case FieldKind::boolean: return "bool";
        case FieldKind::integer: return "int";
        case FieldKind::number: return "number";
        case FieldKind::vec2: return "vec2";
        case FieldKind::points: return "list of vec2";
        case FieldKind::text: return "string";
        case FieldKind::choice: return "enum";
        case FieldKind::choices: return "list of enum";
        case FieldKind::color: return "color";
        case FieldKind::id: return "id";
        case FieldKind::names: return "list of ids";
    }
    return "?";
}

}  // namespace pinfield
