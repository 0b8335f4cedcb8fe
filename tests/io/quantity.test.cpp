#include "engine/io/quantity.h"

#include <bit>
#include <catch2/catch.hpp>

#include "engine/core/numbers.h"
#include "engine/core/rng.h"

using namespace pinfield;

namespace {

double value(std::string_view text, Unit unit) {
    const QuantityResult read = read_quantity(text, unit);
    INFO(text);
    REQUIRE(read);
    return read->value;
}

Code refused(std::string_view text, Unit unit) {
    const QuantityResult read = read_quantity(text, unit);
    INFO(text);
    REQUIRE_FALSE(read);
    return read.error().code;
}

/// A unit of fields that the suffix fits.
Unit unit_of(const UnitSuffix& suffix) {
    int i = 0;
    while (dimension_of(static_cast<Unit>(i)) != suffix.dimension) ++i;
    return static_cast<Unit>(i);
}

}  // namespace

TEST_CASE("a suffix moves the decimal point and rounds once") {
    CHECK(value("24mm", Unit::metre) == 0.024);
    CHECK(value("2.4cm", Unit::metre) == 0.024);
    CHECK(value("0.3mm", Unit::metre) == 0.0003);
    CHECK(value("1ms", Unit::second) == 0.001);
    CHECK(value("80g", Unit::kilogram) == 0.08);
    CHECK(value("1e3um", Unit::metre) == 0.001);
    CHECK(value("-.5m", Unit::metre) == -0.5);
    CHECK(value("1in", Unit::metre) == 0.0254);
    CHECK(value("3.5m/s", Unit::metre_per_second) == 3.5);
    CHECK(value("223450deg/s^2", Unit::degree_per_second2) == 223450);
    CHECK(value("0.43s/m", Unit::seconds_per_metre) == 0.43);
}

TEST_CASE("half a turn is pi radians") {
    CHECK(value("3.141592653589793rad", Unit::degree) == Approx(180).epsilon(1e-15));
}

TEST_CASE("a bare number adapts to any dimension") {
    for (const Unit unit : {Unit::none, Unit::metre, Unit::degree, Unit::second, Unit::metre_per_second2})
        CHECK(value("1.5", unit) == 1.5);
}

TEST_CASE("what people mistake for numbers is refused with a reason of its own") {
    CHECK(refused("010", Unit::none) == Code::malformed_number);
    CHECK(refused("-007mm", Unit::metre) == Code::malformed_number);
    CHECK(refused("1_000", Unit::none) == Code::malformed_number);
    CHECK(refused("1:30", Unit::second) == Code::malformed_number);
    CHECK(refused("0x10", Unit::none) == Code::malformed_number);
    CHECK(refused("3 mm", Unit::metre) == Code::malformed_number);
    CHECK(refused("1e999", Unit::none) == Code::malformed_number);
    CHECK(refused(".nan", Unit::none) == Code::not_finite);
    CHECK(refused("-.inf", Unit::none) == Code::not_finite);
    CHECK(refused("Infinity", Unit::none) == Code::not_finite);
    CHECK(refused("3parsec", Unit::metre) == Code::unknown_unit);
    CHECK(refused("3mm", Unit::none) == Code::wrong_dimension);
    CHECK(refused("3mm", Unit::degree) == Code::wrong_dimension);
    CHECK(refused("yes", Unit::none) == Code::wrong_type);
    CHECK(refused("", Unit::none) == Code::wrong_type);
    CHECK(read_quantity("2 * gap", Unit::metre).error().may_be_expression);
    CHECK(read_quantity("gap", Unit::metre).error().may_be_expression);
    CHECK(read_quantity("-x", Unit::metre).error().may_be_expression);
    CHECK(read_quantity("r/2", Unit::metre).error().may_be_expression);
    CHECK(read_quantity("1/2", Unit::metre).error().may_be_expression);
    CHECK(read_quantity("2mm+1", Unit::metre).error().may_be_expression);
}

TEST_CASE("a wrong unit is met with those that fit") {
    CHECK(read_quantity("3mmm", Unit::metre).error().hint == "did you mean mm?");
    CHECK(read_quantity("24mm", Unit::degree).error().message == "24mm is a length where an angle is due");
    CHECK(read_quantity("24mm", Unit::degree).error().hint == "units here: deg, rad");
}

TEST_CASE("a number is written in the style of the one before") {
    CHECK(write_quantity(0.03, Unit::metre, "24mm") == "30mm");
    CHECK(write_quantity(0.0305, Unit::metre, "24mm") == "30.5mm");
    CHECK(write_quantity(0.03, Unit::metre, "24.0mm") == "30.0mm");
    CHECK(write_quantity(0.03, Unit::metre, "0.024") == "0.030");
    CHECK(write_quantity(0.03, Unit::metre) == "0.03");
    CHECK(write_quantity(0.0508, Unit::metre, "1in") == "2in");
    CHECK(write_quantity(1234, Unit::metre, "1mm") == "1234000mm");
    CHECK(write_quantity(0, Unit::metre, "1mm") == "0mm");
    CHECK(write_quantity(-0.001, Unit::metre, "1mm") == "-1mm");
}

TEST_CASE("whatever the unit, a written number reads back as the same double") {
    CounterRng rng(3);
    for (int i = 0; i < 20000; ++i) {
        double x = std::bit_cast<double>(rng.next_u64());
        if (!(x > -1e300 && x < 1e300)) continue;
        if (i % 2) x = rng.in(-10, 10);
        for (const UnitSuffix& suffix : unit_suffixes()) {
            const Unit unit = unit_of(suffix);
            const std::string like = "1.50" + std::string(suffix.text), text = write_quantity(x, unit, like);
            INFO(text);
            const QuantityResult read = read_quantity(text, unit);
            REQUIRE(read);
            REQUIRE(std::bit_cast<std::uint64_t>(read->value) == std::bit_cast<std::uint64_t>(x));
        }
    }
}
