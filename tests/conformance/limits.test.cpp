// What a node refuses, whatever is no number and the first number on the wrong side of each limit, and which fields do nothing.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/rng.h"
#include "engine/scene/catalog.h"
#include "tests/conformance/parameters.h"

namespace pinfield::conformance {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// A field's value with `v` for each of its numbers in turn.
std::vector<Value> with_number(const FieldType& field, double v) {
    switch (field.kind) {
        case FieldKind::number: return {v};
        case FieldKind::vec2: {
            const Vec2 now = std::get<Vec2>(field.initial);
            return {Vec2(v, now.y()), Vec2(now.x(), v)};
        }
        case FieldKind::points: {
            std::vector<Value> out;
            const auto& now = std::get<std::vector<Vec2>>(field.initial);
            for (std::size_t i = 0; i < now.size(); ++i)
                for (const int axis : {0, 1}) {
                    std::vector<Vec2> points = now;
                    points[i][axis] = v;
                    out.emplace_back(std::move(points));
                }
            return out;
        }
        default: return {};
    }
}

/// The limit as it is meant for lengths: none is endless, and what must be above 0 is so by a length.
Limit as_of_lengths(const FieldType& field, const Limit& limit) {
    if (field.meta.unit != Unit::metre) return limit;
    if (limit.open && limit.value == 0) return from(shortest_length);
    return std::isfinite(limit.value) ? limit : from(std::copysign(longest_length, limit.value));
}

void check_limit(const FieldType& field, const Limit& written, double inwards) {
    const Limit limit = as_of_lengths(field, written);
    if (!std::isfinite(limit.value)) return;
    for (const Value& value : with_number(field, std::nextafter(limit.value, -inwards))) CHECK(why_invalid(field, value));
    for (const Value& value : with_number(field, limit.value)) CHECK(why_invalid(field, value).has_value() == limit.open);
    for (const Value& value : with_number(field, std::nextafter(limit.value, inwards))) CHECK_FALSE(why_invalid(field, value));
}

}  // namespace

TEST_CASE("every field of every node refuses what is no finite number, and each limit parts neighbouring doubles") {
    const Catalog catalog = built_in_catalog();
    int limits = 0;
    for (const NodeType& type : catalog.types())
        for (const FieldType& field : type.fields) {
            INFO(type.key() << "." << field.key);
            for (const double v : {not_a_number, infinity, -infinity})
                for (const Value& value : with_number(field, v)) CHECK(why_invalid(field, value));
            if (field.meta.min.value == field.meta.max.value) continue;
            check_limit(field, field.meta.min, infinity);
            check_limit(field, field.meta.max, -infinity);
            limits += std::isfinite(field.meta.min.value) + std::isfinite(field.meta.max.value);
        }
    CHECK(limits > 100);
}

TEST_CASE("a field that is of use only with a choice changes distances with it, and none without") {
    const Catalog catalog = built_in_catalog();
    int fields = 0;
    for (const NodeType& type : catalog.types())
        for (std::size_t i = 0; type.kernels && i < static_cast<std::size_t>(type.own_fields); ++i) {
            const OnlyWith& with = type.fields[i].meta.only_with;
            if (with.field.empty()) continue;
            INFO(type.key() << "." << type.fields[i].key);
            ++fields;
            const auto at = static_cast<std::size_t>(type.find_field(with.field).value());
            REQUIRE(std::count(type.fields[at].choices.begin(), type.fields[at].choices.end(), with.choice) == 1);
            for (const std::string_view choice : type.fields[at].choices) {
                Values values = defaults_of(type);
                values[at] = std::string(choice);
                const Subject one = subjects_of(catalog, type, values).front();
                values[i] = std::get<std::int64_t>(values[i]) + 1;
                const Subject other = subjects_of(catalog, type, values).front();
                CounterRng rng(12);
                bool differ = false;
                for (int k = 0; k < 2000; ++k) {
                    const double x = rng.in(-0.05, 0.05);
                    const Vec2 p(x, rng.in(-0.05, 0.05));
                    differ = differ || one.value(p) != other.value(p);
                }
                INFO(choice);
                CHECK(differ == (choice == with.choice));
            }
        }
    CHECK(fields > 0);
}

}  // namespace pinfield::conformance
