#include <catch2/catch.hpp>

#include <set>

#include "engine/sdf/register.h"
#include "tests/conformance/faulty_nodes.h"
#include "tests/conformance/laws.h"

namespace pinfield::conformance {
namespace {

using namespace sdf::faulty;

/// One faulty node in a catalogue that is otherwise sound.
template <template <class> class N>
Report complaints() {
    return check<N>(2);
}

std::set<std::string> caught_laws;

bool complains(const Report& report, std::string_view law) {
    if (report.breaks(law)) caught_laws.emplace(law);
    return report.breaks(law);
}

}  // namespace

TEST_CASE("each law catches the fault it is for") {
    caught_laws.clear();
    CHECK(complains(complaints<NanAtCentre>(), "everything is finite"));
    CHECK(complains(complaints<ZeroPlane>(), "the field is not zero on an area"));
    CHECK(complains(complaints<Jump>(), "the field changes no faster than its Lipschitz constant"));
    CHECK(complains(complaints<OverEstimate>(), "no side over-estimates"));
    CHECK(complains(complaints<WrongSignOnAxis>(), "the sign tells inside from outside"));
    CHECK(complains(complaints<WrongSignOnAxis>(), "the field changes no faster than its Lipschitz constant"));
    CHECK(complains(complaints<InsideOut>(), "the sign tells inside from outside"));
    CHECK(complains(complaints<NoGradientOnAxis>(), "the gradient is a unit vector where the distance is exact"));
    CHECK(complains(complaints<LostDerivative>(), "the gradient is the central difference"));
    CHECK(complains(complaints<BoundsTooSmall>(), "the bounds contain the solid"));
    CHECK(complains(complaints<BoundsTooLarge>(), "the bounds of a shape are tight"));
    CHECK(complains(complaints<PacketOff>(), "packets are the value within the declared float error"));
    CHECK(complains(complaints<WrongLipschitz>(), "the gradient is within the Lipschitz constant"));
    CHECK(complains(complaints<WrongLipschitz>(), "the field changes no faster than its Lipschitz constant"));
    CHECK(complains(complaints<WrongClaim>(), "exact sides are brute-force distances"));
    CHECK(complains(complaints<HalfDistance>(), "the foot point is on the outline where the distance is exact"));
    CHECK(complains(complaints<TwoClaims>(), "the exactness at defaults is as described"));
    CHECK(complains(complaints<UnionSaidExact>(), "exact sides are brute-force distances"));
    CHECK(complains(complaints<SlackTooSmall>(), "a fold strays no further than its slack"));
    CHECK(complains(complaints<WrongPartials>(), "a fold's partial derivatives are its differences"));
    CHECK(complains(complaints<WrongAffine>(), "a modifier is what its affine form says"));
    CHECK(complains(complaints<WarpPacketsOff>(), "a warp's packets send points where the warp does"));
    CHECK(complains(complaints<BranchesByMiddle>(), "an enclosure over a box holds the samples in it"));
    CHECK(complains(complaints<WrongLipschitz>(), "no enclosure of the gradient refutes the Lipschitz constant"));

    // The two laws whose faults sit in the kernels, not in a formula.
    Catalogue catalogue;
    sdf::add_built_in(catalogue);
    NodeType disc = *catalogue.find("circle");
    disc.meta.key = "tampered_disc";
    sdf::Kernels tampered = *disc.kernels;
    disc.kernels = &tampered;
    tampered.distance = [](const double* params, double x, double y) { return std::sqrt(x * x + y * y) - params[0] * (1 + 1e-15); };
    const NodeType& type = catalogue.add(disc);
    CHECK(complains(check(catalogue, type, 1), "the value alone is the value with its gradient"));
    static const sdf::PacketDistance sound = tampered.packets[0].distance;
    tampered.packets[0].distance = [](const double* params, const sdf::PacketFrame& frame, const float* x, const float* y, float* d, int n) {
        sound(params, frame, x, y, d, n);
        if (n == 7) d[6] += 1e-7f;  // in the tail only
    };
    CHECK(complains(check(catalogue, type, 1), "every instruction set gives the same bits"));

    for (const Law& law : laws()) CHECK_THAT(caught_laws.count(std::string(law.name)) ? "" : std::string(law.name), Catch::Matchers::Equals(""));
}

}  // namespace pinfield::conformance
