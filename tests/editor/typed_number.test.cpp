#include "editor/typed_number.h"

#include <catch2/catch.hpp>

using namespace pinfield;
using namespace pinfield::editor;

TEST_CASE("a typed number means the unit that is shown, and sums may mix units") {
    const auto metres = [](std::string_view text) { return typed_number(text, Unit::metre, "mm").value(); };
    CHECK(metres("30") == 0.030);
    CHECK(metres("26+4") == 0.030);
    CHECK(metres(" 2 * (26 - 11) ") == Approx(0.030));
    CHECK(metres("26mm") == 0.026);
    CHECK(metres("0.5m") == Approx(0.5));
    CHECK(metres("1in") == Approx(0.0254));
    CHECK(metres("1in+2") == 0.0274);
    CHECK(metres("2*1in") == Approx(0.0508));
    CHECK(metres("26mm/2") == 0.013);
    CHECK(metres("-5") == Approx(-0.005));
    CHECK(metres("1e2") == Approx(0.1));
    CHECK(typed_number("0.8/2", Unit::none, "").value() == 0.4);
    CHECK(typed_number("0.1+0.2", Unit::none, "").value() == 0.3);
}

TEST_CASE("what is no number, or no length, is refused with a reason") {
    for (const char* text : {"", "abc", "1+", "(2", "2)", "1 2", "3/0", "1mm*1mm", "1/1mm", "5 kg", "--", "1..2"}) {
        INFO(text);
        const Result<double> read = typed_number(text, Unit::metre, "mm");
        REQUIRE_FALSE(read);
        CHECK_FALSE(read.error().message.empty());
    }
    CHECK_FALSE(typed_number(std::string(100'000, '('), Unit::metre, "mm"));
}
