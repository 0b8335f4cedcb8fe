#include "tests/conformance/sheet/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/numbers.h"
#include "engine/io/node_reference.h"

namespace pinfield::conformance {
namespace {

const char* word(Side side) { return side == Side::exact ? "exact" : "bound"; }

const char* text_of(Reference reference) {
    switch (reference) {
        case Reference::outline: return "its lines and arcs";
        case Reference::curve: return "its parametric curve";
        default: return "its own zero line";
    }
}

/// Rounded up, but for what rounding adds to a slope of 1.
std::string slope_text(double slope) { return to_text(std::ceil((slope - 1e-6) * 1000) / 1000, 3); }

std::string nanoseconds_text(const std::optional<double>& ns) { return ns ? to_text(*ns) : "-"; }

std::string float_text(const Entry& entry) {
    return entry.measure.float_error < 0 ? "-" : at_most(entry.measure.float_error, 1e-9);
}

std::string side_rows(const Entry& entry, std::string_view name, const std::vector<SideMeasure>& sides) {
    std::string out;
    for (const SideMeasure& side : sides) {
        const double floor = floor_of(side.reference);
        out +=
            fmt::format("| {} | {} | {} | {} | {} | {} points in {} of {} trials |\n", name, word(side.claimed), at_most(side.over, floor),
                        at_most(side.under, floor), text_of(side.reference), side.points, side.subjects, entry.measure.subjects);
    }
    return out;
}

/// The largest of some error over the subjects of one claim. What the best reference cannot tell from nothing counts as less than its
/// floor, unless a lesser one shows more than its own.
std::string largest(const std::vector<SideMeasure>& sides, Side claimed, double (*error)(const SideMeasure&)) {
    double most = 0, floor = infinity;
    for (const SideMeasure& side : sides) {
        if (side.claimed != claimed) continue;
        floor = std::min(floor, floor_of(side.reference));
        if (error(side) > floor_of(side.reference)) most = std::max(most, error(side));
    }
    return at_most(most, floor);
}

/// What was measured where the claim is the one at the defaults: "exact", and how far off; "bound", and how far to either side.
std::string side_cell(Side claimed, const std::vector<SideMeasure>& sides) {
    if (claimed == Side::exact)
        return fmt::format("**exact**<br>off {}", largest(sides, claimed, [](const SideMeasure& s) { return std::max(s.over, s.under); }));
    return fmt::format("bound<br>over {}<br>under {}", largest(sides, claimed, [](const SideMeasure& s) { return s.over; }),
                       largest(sides, claimed, [](const SideMeasure& s) { return s.under; }));
}

std::string index_row(const Entry& entry) {
    const NodeType& type = *entry.type;
    const Exactness& claim = type.meta.exactness;
    const Measure& m = entry.measure;
    return fmt::format("| [<img src=\"{0}.png\" width=\"120\" alt=\"{0}\">]({0}.md) "
                       "| [`{0}`]({0}.md)<br>{1} | {2} | {3} | {4} | {5} | {6} | {7} |\n",
                       type.key(), type.meta.doc, side_cell(claim.outside, m.outside), side_cell(claim.inside, m.inside),
                       slope_text(m.slope), float_text(entry), nanoseconds_text(entry.timing.in_double),
                       nanoseconds_text(entry.timing.in_packets));
}

std::string index_table(std::span<const Entry> entries, NodeKind kind) {
    std::string out =
        "| | node | outside | inside | slope | floats off | ns, double | ns, packets |\n"
        "|---|---|---|---|--:|--:|--:|--:|\n";
    for (const Entry& entry : entries)
        if (entry.type->meta.kind == kind) out += index_row(entry);
    return out;
}

constexpr std::string_view how_to_read = R"(# The conformance sheet

What every shape and operation of the catalog claims, and what was measured of it. All of this folder is generated:

```sh
build/release/bin/conformance_sheet --out docs/nodes      # --keep-timings: all but the nanoseconds
build/release/bin/conformance_sheet --check docs/nodes    # a test, too: fails when a page is stale
```

- **Pictures** are the examples of [`scenes/nodes/`](../../scenes/nodes), drawn as `pinfield render --mode isolines` draws them: blue is
  solid, sand is free, white the outline between them; 10 mm from line to line, the table's edge a wall.
  They show what balls meet: the true distance, also where the formula alone, which is what the tables measure, is a bound.
- **exact**: the value is the true distance. **bound**: it is never above the distance, so that a step of that length is safe. The claim
  is for the default parameters and exact children; a page also tells what was measured where other parameters claim less.
- **off, over, under**: the largest error, over-estimate and under-estimate that was found, over the default and random parameters,
  in points up to six sizes away; in sizes of the solid: its largest coordinate, half its width or height if it lies about the
  origin. Errors are rounded up to one digit, and `<` is where the brute force's own begin: 2e-12 against lines and arcs, 2e-08
  against other parametric curves, 1e-06 against the field's own zero line. The latter is for operations and for shapes that hand
  out no curve; of their field it trusts the sign alone.
- **slope**: the steepest that was found, of gradients and of differences: a measured Lipschitz constant.
- **floats off**: the largest difference between float packets and doubles, in sizes.
- **ns**: nanoseconds a point, one by one in double and many at once in packets, at default parameters. Of an operation, its own work
  without its children's; - where it has none. They are from one machine ([`timings.csv`](timings.csv)) and differ on yours.
)";

}  // namespace

std::string at_most(double error, double floor) {
    if (error <= floor) return fmt::format("< {:.0e}", floor);
    int exponent = static_cast<int>(std::floor(std::log10(error)));
    int digit = static_cast<int>(std::ceil(error / std::pow(10, exponent) * (1 - 1e-9)));
    if (digit == 10) digit = 1, ++exponent;
    return to_text(*parse_number(fmt::format("{}e{}", digit, exponent)));
}

std::string header_of(const NodeType& type) {
    return fmt::format("engine/sdf/{}/{}.h", type.meta.kind == NodeKind::shape ? "nodes" : "operations", type.key());
}

std::string page_of(const Entry& entry) {
    const NodeType& type = *entry.type;
    const Measure& m = entry.measure;
    const std::string header = header_of(type);
    std::string out = fmt::format("# {0}\n\n{1}\n\n![Isolines of the example below]({0}.png)\n\n", type.key(), type.meta.doc);
    out += fmt::format("{} of the [conformance sheet](README.md). Formula: [`{}`](../../{}).",
                       type.meta.kind == NodeKind::shape ? "A shape" : "An operation", header, header);
    if (type.meta.kind == NodeKind::operation) out += fmt::format(" Children: {}.", children_text(type));
    out += "\n\n## Parameters\n\n";
    const std::string fields = fields_markdown(type);
    out += fields.empty() ? "None of its own.\n\n" : fields;

    out += "## Distance\n\nIn sizes of the solid:\n\n";
    out += "| side | claimed | largest over-estimate | largest under-estimate | against | tried |\n|---|---|---|---|---|---|\n";
    out += side_rows(entry, "outside", m.outside) + side_rows(entry, "inside", m.inside);
    out += fmt::format("\n- Steepest slope: {}, where at most {} is claimed.\n", slope_text(m.slope), slope_text(m.slope_claimed));
    if (m.float_error >= 0)
        out += fmt::format("- Float packets: off by at most {}, where {} is declared.\n", float_text(entry),
                           to_text(type.meta.float_error));
    else out += "- Float packets: its children's, it has none of its own.\n";
    if (entry.timing.in_double)
        out += fmt::format("- Cost: {} ns a point in double, {} ns in packets{}.\n", nanoseconds_text(entry.timing.in_double),
                           nanoseconds_text(entry.timing.in_packets),
                           entry.timing.isa.empty() ? "" : fmt::format(" ({})", entry.timing.isa));
    else out += "- Cost: its child's, for each place where the child is seen.\n";

    out += fmt::format("\n## Example\n\n[`scenes/nodes/{0}.yaml`](../../scenes/nodes/{0}.yaml)\n\n```yaml\n{1}```\n", type.key(),
                       entry.example);
    return out;
}

std::string index_of(std::span<const Entry> entries) {
    std::string out(how_to_read);
    out += "\n## Shapes\n\n" + index_table(entries, NodeKind::shape);
    out += "\n## Operations\n\n" + index_table(entries, NodeKind::operation);
    return out;
}

}  // namespace pinfield::conformance
