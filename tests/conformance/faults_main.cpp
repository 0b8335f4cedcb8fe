// conformance_faults: plants every known fault and reports which laws kill it; 1 when one survives the law it is for.
#include <fmt/format.h>

#include <set>

#include "tests/conformance/faults.h"

int main() {
    using namespace pinfield::conformance;
    int killed = 0;
    for (const PlantedFault& fault : planted_faults()) {
        const Report report = fault.check();
        std::set<std::string> laws;
        for (const Violation& violation : report.violations) laws.insert(violation.law);
        const bool dies = report.breaks(fault.law);
        killed += dies ? 1 : 0;
        fmt::print("{:8} {:42} {}\n", dies ? "killed" : "SURVIVES", fault.what, fault.law);
        for (const std::string& law : laws)
            if (law != fault.law) fmt::print("{:51} {}\n", "", law);
    }
    const auto planted = static_cast<int>(planted_faults().size());
    fmt::print("{} of {} planted faults are killed\n", killed, planted);
    return killed == planted ? 0 : 1;
}
