#include "tests/conformance/faults.h"

#include <cmath>

#include "engine/sdf/register.h"
#include "tests/conformance/faulty_nodes.h"
#include "tests/conformance/published_faults.h"

namespace pinfield::conformance {
namespace {

using namespace sdf::faulty;

/// One faulty node among sound ones, with few sets of parameters: a fault that needs many is not caught well.
template <template <class> class N>
Report checked() {
    return check<N>(2);
}

/// Faults that sit in the kernels, not in a formula: the engine's disc, tampered with.
Report checked_disc(void (*tamper)(sdf::Kernels&)) {
    Catalog catalog;
    sdf::add_built_in(catalog);
    NodeType disc = *catalog.find("circle");
    const Witness& witness = witness_of(*disc.kernels);
    disc.meta.key = "tampered_disc";
    sdf::Kernels tampered = *disc.kernels;
    tamper(tampered);
    disc.kernels = &tampered;
    return check(catalog, catalog.add(disc), witness, 1);
}

sdf::PacketDistance sound_packets = nullptr;

Report value_apart_from_gradient() {
    return checked_disc([](sdf::Kernels& k) {
        k.distance = [](const double* params, double x, double y) { return std::sqrt(x * x + y * y) - params[0] * (1 + 1e-15); };
    });
}

Report last_of_a_tail() {
    return checked_disc([](sdf::Kernels& k) {
        sound_packets = k.packets[0].distance;
        k.packets[0].distance = [](const double* params, const sdf::PacketFrame& frame, const float* x, const float* y, float* d, int n) {
            sound_packets(params, frame, x, y, d, n);
            if (n == 7) d[6] += 1e-7f;
        };
    });
}

}  // namespace

const std::vector<PlantedFault>& planted_faults() {
    static const std::vector<PlantedFault> all = {
        {"not a number at the centre", "everything is finite", checked<NanAtCentre>},
        {"zero on the whole plane", "the field is not zero on an area", checked<ZeroPlane>},
        {"a seam", "the field changes no faster than its Lipschitz constant", checked<Jump>},
        {"claims more distance than there is", "no side over-estimates", checked<OverEstimate>},
        {"inside out on an axis alone", "the sign tells inside from outside", checked<WrongSignOnAxis>},
        {"inside out on an axis alone", "the field changes no faster than its Lipschitz constant", checked<WrongSignOnAxis>},
        {"inside out", "the sign tells inside from outside", checked<InsideOut>},
        {"no gradient on an axis", "the gradient is a unit vector where the distance is exact", checked<NoGradientOnAxis>},
        {"a lost derivative", "the gradient is the central difference", checked<LostDerivative>},
        {"bounds too small", "the bounds contain the solid", checked<BoundsTooSmall>},
        {"bounds too large", "the bounds of a shape are tight", checked<BoundsTooLarge>},
        {"packets off", "packets are the value within the declared float error", checked<PacketOff>},
        {"a Lipschitz constant too small", "the gradient is within the Lipschitz constant", checked<WrongLipschitz>},
        {"a Lipschitz constant too small", "the field changes no faster than its Lipschitz constant", checked<WrongLipschitz>},
        {"a bound called exact", "exact sides are brute-force distances", checked<WrongClaim>},
        {"the distance of another figure", "the foot point is on the outline where the distance is exact", checked<HalfDistance>},
        {"described otherwise than computed", "the exactness at defaults is as described", checked<TwoClaims>},
        {"a union said exact inside", "exact sides are brute-force distances", checked<UnionSaidExact>},
        {"a blend beyond its slack", "a fold strays no further than its slack", checked<SlackTooSmall>},
        {"partial derivatives of something else", "a fold's partial derivatives are its differences", checked<WrongPartials>},
        {"an affine form of something else", "a modifier is what its affine form says", checked<WrongAffine>},
        {"a warp's packets off", "a warp's packets send points where the warp does", checked<WarpPacketsOff>},
        {"a branch by one number of many", "an enclosure over a box holds the samples in it", checked<BranchesByMiddle>},
        {"a Lipschitz constant too small", "no enclosure of the gradient refutes the Lipschitz constant", checked<WrongLipschitz>},
        {"a Lipschitz constant too small", "the disc of safe distance holds no surface", checked<WrongLipschitz>},
        {"an outline drawn as that of a hole", "the solid is on the left of its outline", checked<OutlineOfAHole>},
        {"a normal by what rounding leaves", "the gradient on the outline points out", checked<NormalByFoot>},
        {"a length that nobody gave", "another size is the same figure in proportion", checked<HiddenLength>},
        {"a union that prefers its first child", "the order of a symmetric fold's children is no matter", checked<FirstComesFirst>},
        {"a region to the left of its chain", "the order of a chain's points is no matter", checked<LeftOfChain>},
        {"a value apart from its gradient's", "the value alone is the value with its gradient", value_apart_from_gradient},
        {"an instruction set of its own mind", "every instruction set gives the same bits", last_of_a_tail},

        {"segment: ends that meet", "everything is finite", checked<SegmentOfNoLength>},
        {"uneven capsule: one disc in the other", "everything is finite", checked<CapsuleSwallowed>},
        {"ellipse: equal axes", "everything is finite", checked<EllipseOfEqualAxes>},
        {"ellipse: f over its gradient", "the gradient is within the Lipschitz constant", checked<EllipseByItsGradient>},
        {"vesica: higher than long", "the field changes no faster than its Lipschitz constant", checked<LensHigherThanLong>},
        {"rounded box: radii beyond its size", "the field changes no faster than its Lipschitz constant", checked<BoxTooRound>},
        {"cross: stubby arms", "no side over-estimates", checked<CrossWithStubbyArms>},
        {"open curve: a sign of its own", "the field changes no faster than its Lipschitz constant", checked<OpenCurveWithASign>},
        {"triangle: corners in a line", "the field is not zero on an area", checked<TriangleOfOneLine>},
        {"repetition: no neighbours asked", "the field changes no faster than its Lipschitz constant",
         checked<RepetitionWithoutNeighbours>},
        {"round union: both distances at once", "the gradient is within the Lipschitz constant", checked<RoundUnionBothSides>},
        {"intersection said exact outside", "exact sides are brute-force distances", checked<IntersectionSaidExact>},
    };
    return all;
}

}  // namespace pinfield::conformance
