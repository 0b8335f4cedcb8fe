// A shape the engine has never heard of, for the tests that add one of their own to the catalog.
#pragma once
#include <memory>

#include "engine/scene/catalog.h"
#include "engine/sdf/own_node.h"

namespace pinfield::sdf {

/// Two discs side by side. They may touch, not overlap: then it is exact on both sides.
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
        return shape<Spectacles>(
            {.key = "spectacles", .doc = "Two discs side by side."},
            fields(field("radius", &Spectacles::radius, {.unit = Unit::metre, .min = above(0), .doc = "Of each disc."}),
                   field("gap", &Spectacles::gap, {.unit = Unit::metre, .min = from(0), .doc = "Between them."})));
    }
};

}  // namespace pinfield::sdf

namespace pinfield::test {

/// The built-in catalog and spectacles.
inline std::shared_ptr<const Catalog> catalog_with_spectacles() {
    auto catalog = std::make_shared<Catalog>(built_in_catalog());
    add_scene_type(*catalog, sdf::sdf_node_type<sdf::Spectacles>());
    return catalog;
}

inline constexpr const char* spectacles_table =
    "pinfield: 1\n"
    "table: {size: [0.2, 0.2]}\n"
    "scene:\n"
    "  - spectacles: {id: nose, at: [0.1, 0.1], radius: 18mm, gap: 14mm}  # kept\n";

}  // namespace pinfield::test
