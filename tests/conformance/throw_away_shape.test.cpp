#include <catch2/catch.hpp>

#include "engine/sdf/make_kernels.h"
#include "engine/sdf/nodes/circle.h"
#include "engine/sdf/register.h"
#include "tests/conformance/laws.h"

namespace pinfield::sdf {
namespace {

/// Two discs side by side, a shape the engine has never heard of. They may touch, not overlap: then it is exact on both sides.
template <class Real>
struct Spectacles {
    Real radius = Real(0.02);
    Real gap = Real(0.03);

    Real distance(const Point<Real>& p) const {
        const Point<Real> folded{abs(p.x) - (radius + gap * Real(0.5)), p.y};
        return norm(folded) - radius;
    }
    Box2 bounds() const { return Box2::centred(2 * radius + 0.5 * gap, radius); }
    void outline(Outline& out) const {
        for (const double side : {-1.0, 1.0}) out.push_back(Piece::circle({side * (radius + 0.5 * gap), 0}, radius));
    }

    static constexpr auto describe() {
        return shape<Spectacles>({.key = "spectacles", .doc = "Two discs side by side."},
                                 fields(field("radius", &Spectacles::radius, {.unit = Unit::metre, .min = above(0), .doc = "Of each disc."}),
                                        field("gap", &Spectacles::gap, {.unit = Unit::metre, .min = from(0), .doc = "Between them."})));
    }
};

}  // namespace
}  // namespace pinfield::sdf

namespace pinfield::conformance {

TEST_CASE("a shape that a program adds of its own goes through every law") {
    Catalogue catalogue;
    sdf::add_built_in(catalogue);
    const std::size_t built_in = catalogue.types().size();
    const NodeType& type = catalogue.add(sdf::sdf_node_type<sdf::Spectacles>());
    REQUIRE(catalogue.types().size() == built_in + 1);
    REQUIRE(catalogue.find("spectacles") == &type);
    CHECK_THAT(text(check(catalogue, type, 40)), Catch::Matchers::StartsWith("0 violations"));
}

}  // namespace pinfield::conformance
