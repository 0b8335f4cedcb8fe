// Field values as JSON; included by .cpp files only, which keep nlohmann's header to themselves.
#pragma once
#include <cmath>

#include "engine/reflect/node_type.h"

namespace pinfield {

/// Json is nlohmann's; a number that JSON has no word for becomes null.
template <class Json>
Json number_json(double x) {
    return std::isfinite(x) ? Json(x) : Json(nullptr);
}

template <class Json>
Json value_json(const Value& value) {
    if (const bool* flag = std::get_if<bool>(&value)) return *flag;
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return *integer;
    if (const double* number = std::get_if<double>(&value)) return number_json<Json>(*number);
    if (const Vec2* pair = std::get_if<Vec2>(&value))
        return Json::array({number_json<Json>(pair->x()), number_json<Json>(pair->y())});
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    Json list = Json::array();
    if (const auto* names = std::get_if<std::vector<std::string>>(&value))
        for (const std::string& name : *names) list.push_back(name);
    else
        for (const Vec2& p : std::get<std::vector<Vec2>>(value)) list.push_back(value_json<Json>(Value(p)));
    return list;
}

}  // namespace pinfield
