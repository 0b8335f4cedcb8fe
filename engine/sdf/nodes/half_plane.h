#pragma once
#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// Everything below the local x axis, which is its outline: endless, so that none can be handed out.
template <class Real>
struct HalfPlane {
    static constexpr bool convex = true, endless = true;

    static Real distance(const Point<Real>& p) { return p.y; }
    static Box2 bounds() { return {{-infinity, -infinity}, {infinity, 0}}; }

    static constexpr auto describe() {
        return shape<HalfPlane>({.key = "half_plane", .doc = "Everything below the local x axis (local y < 0)."}, fields());
    }
};

}  // namespace pinfield::sdf
