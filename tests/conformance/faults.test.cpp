#include <catch2/catch.hpp>

#include <set>

#include "tests/conformance/faults.h"
#include "tests/conformance/laws.h"

namespace pinfield::conformance {

TEST_CASE("each planted fault is caught by the law it is for, and each law catches one") {
    std::set<std::string_view> caught;
    for (const PlantedFault& fault : planted_faults()) {
        const Report report = fault.check();
        INFO(fault.what << ": not seen by \"" << fault.law << "\", but:\n" << text(report));
        CHECK(report.breaks(fault.law));
        if (report.breaks(fault.law)) caught.insert(fault.law);
    }
    for (const Law& law : laws()) {
        INFO(law.name);
        CHECK(caught.count(law.name) == 1);
    }
}

}  // namespace pinfield::conformance
