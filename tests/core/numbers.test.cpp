#include "engine/core/numbers.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

#include "engine/core/rng.h"

using namespace pinfield;

TEST_CASE("every finite double survives the way to text and back") {
    CounterRng rng(1);
    for (int i = 0; i < 200000; ++i) {
        const double x = i % 2 ? std::bit_cast<double>(rng.next_u64()) : rng.in(-1, 1) * std::pow(10, rng.in(-6, 17));
        if (!std::isfinite(x)) continue;
        const auto back = parse_number(to_text(x));
        if (!back || std::bit_cast<std::uint64_t>(*back) != std::bit_cast<std::uint64_t>(x)) FAIL(to_text(x));
    }
}

TEST_CASE("ordinary numbers are written in plain digits, as short as can be") {
    CHECK(to_text(0) == "0");
    CHECK(to_text(-0.0) == "-0");
    CHECK(to_text(1) == "1");
    CHECK(to_text(-2.5) == "-2.5");
    CHECK(to_text(0.1) == "0.1");
    CHECK(to_text(1.0 / 3) == "0.3333333333333333");
    CHECK(to_text(0.0001) == "0.0001");
    CHECK(to_text(0.012345) == "0.012345");
    CHECK(to_text(100000) == "100000");
    CHECK(to_text(999999999999999) == "999999999999999");
    CHECK(to_text(1e15) == "1e+15");
    CHECK(to_text(1e-7) == "1e-07");
    CHECK(to_text(1e300) == "1e+300");
    CHECK(to_text(HUGE_VAL) == "inf");
}

TEST_CASE("a fixed number of decimals") {
    CHECK(to_text(0.5, 3) == "0.500");
    CHECK(to_text(-1.2345, 2) == "-1.23");
    CHECK(to_text(-0.0001, 2) == "0.00");
    CHECK(to_text(-0.0, 0) == "0");
    CHECK(to_text(12.5, 0) == "12");  // to even
}

TEST_CASE("numbers that people write are read") {
    CHECK(parse_number("0") == 0.0);
    CHECK(parse_number("-2.5") == -2.5);
    CHECK(parse_number("+1") == 1.0);
    CHECK(parse_number(".5") == 0.5);
    CHECK(parse_number("-.5") == -0.5);
    CHECK(parse_number("5.") == 5.0);
    CHECK(parse_number("0.001") == 0.001);
    CHECK(parse_number("1e-3") == 0.001);
    CHECK(parse_number("2.5E+2") == 250.0);
    CHECK(parse_number("1e05") == 1e5);
    CHECK(std::signbit(parse_number("-0").value()));
}

TEST_CASE("what only looks like a number is refused") {
    for (const char* text : {"",
                             " ",
                             "+",
                             "-",
                             ".",
                             "-.",
                             "e5",
                             ".e5",
                             "1e",
                             "1e+",
                             "--1",
                             "+-1",
                             "1 ",
                             " 1",
                             "1a",
                             "01",
                             "007",
                             "-01",
                             "00.5",
                             "1_000",
                             "1,5",
                             "1:30",
                             "0x10",
                             "0b1",
                             "inf",
                             "-inf",
                             ".inf",
                             "nan",
                             ".nan",
                             "NaN",
                             "infinity",
                             "1.2.3",
                             "1e5.",
                             "1e999",
                             "-1e999",
                             "1e-999",
                             "1\n",
                             "\xc2\xa0"
                             "1",
                             "\xef\xbc\x91"}) {
        CAPTURE(text);
        CHECK_FALSE(parse_number(text).has_value());
    }
    CHECK_FALSE(parse_number(std::string_view("1\0", 2)).has_value());
}
