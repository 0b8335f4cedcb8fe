// Whether a ball may start at a place: what is there instead of room for it.
#pragma once
#include <span>

#include "engine/physics/world.h"

namespace pinfield {

enum class Hindrance : unsigned char {
    none,
    outside,  ///< its centre would be where the domain says that no ball may be
    solid,    ///< it would overlap something that does not move
    drain,    ///< it would be drained at once
    mover     ///< it would overlap a mover where that stands now
};

/// What keeps a ball from starting at a place.
struct Start {
    Hindrance hindrance = Hindrance::none;
    NodeId node;      ///< what hinders it: the part's scene node, else the solid's; the table's where that has no domain of its own
    double depth = 0; ///< metres by which it would overlap that; 0 for a drain
    int mover = -1;
};

/// Of a ball with its centre at p, movers where `q` says (one value per mover). A ball that overlaps a solid by no more than the
/// table's tolerance touches it.
Start start_at(const Program& program, std::span<const double> q, const Vec2& p, LayerMask layers = ground_layer);
/// With movers at rest, as when a game starts.
Start start_at(const Program& program, const Vec2& p, LayerMask layers = ground_layer);

/// Is a point where the domain of one of these layers says that no ball may be?
bool is_outside(const Program& program, const Vec2& p, LayerMask layers = ground_layer);

}  // namespace pinfield
