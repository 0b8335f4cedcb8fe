#include "tests/conformance/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "engine/sdf/register.h"
#include "tests/conformance/laws.h"
#include "tests/conformance/parameters.h"

namespace pinfield::conformance {
namespace {

/// How many subjects break a law, and how the first of them does; the violations of one subject follow each other.
std::string paragraph(std::string_view law, const std::vector<Violation>& violations) {
    std::string first, last_subject;
    std::size_t subjects = 0;
    for (const Violation& violation : violations) {
        if (violation.law != law) continue;
        subjects += violation.subject != last_subject;
        last_subject = violation.subject;
        if (subjects > 1) continue;
        if (first.empty()) first = fmt::format("    {}\n", violation.subject);
        first += fmt::format("      {}\n", violation.what);
    }
    const std::string others = subjects > 1 ? fmt::format(" ({} sets of parameters; the first)", subjects) : "";
    return fmt::format("  {}{}\n{}", law, others, first);
}

}  // namespace

bool Report::breaks(std::string_view law) const {
    return std::any_of(violations.begin(), violations.end(), [&](const Violation& v) { return v.law == law; });
}

std::string text(const Report& report) {
    if (report) return fmt::format("{} obeys every law", report.node);
    std::vector<std::string_view> broken;
    for (const Violation& violation : report.violations)
        if (std::find(broken.begin(), broken.end(), violation.law) == broken.end()) broken.push_back(violation.law);
    std::string out = fmt::format("{} breaks {}:\n", report.node, broken.size() == 1 ? "a law" : fmt::format("{} laws", broken.size()));
    for (const std::string_view law : broken) out += paragraph(law, report.violations);
    out.pop_back();
    return out;
}

std::ostream& operator<<(std::ostream& out, const Report& report) { return out << text(report); }

Report check(const Catalog& catalog, const NodeType& type, const Witness& witness, int random_sets) {
    Report report{std::string(type.key()), {}};
    CounterRng rng(2024);
    std::vector<Values> sets{defaults_of(type)};
    if (!Subject::accepted(type, sets[0])) {
        report.violations.push_back({"defaults are accepted", report.node, "a range or a contract refuses them"});
        return report;
    }
    if (type.own_fields > 0)
        for (int i = 0; i < random_sets; ++i) sets.push_back(random_values(type, rng));
    for (Values& values : degenerate_values(type)) sets.push_back(std::move(values));
    std::uint64_t seed = 1;
    for (const Values& values : sets)
        for (const Subject& subject : subjects_of(catalog, type, values))
            for (Violation& violation : check(subject, witness, ++seed)) report.violations.push_back(std::move(violation));
    return report;
}

Report check(const Catalog& catalog, const NodeType& type, int random_sets) {
    return check(catalog, type, witness_of(*type.kernels), random_sets);
}

Report check(const NodeType& type, const Witness& witness, int random_sets) {
    Catalog built_in;
    sdf::add_built_in(built_in);
    return check(built_in, type, witness, random_sets);
}

}  // namespace pinfield::conformance
