// Plain compiled records of parts, materials and settings, for physics. A reflex loads the struct of its own part (engine/scene/parts/)
// from a record, so that nothing is declared twice; this header names none, so that touching one part rebuilds only what asks for it.
#pragma once
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/core/id.h"
#include "engine/reflect/load.h"
#include "engine/reflect/node_type.h"
#include "engine/scene/records.h"

namespace pinfield {

struct Part {
    const NodeType* type = nullptr;
    NodeId origin;
    std::string name;              ///< the author's id, or its path
    Similarity world_from_part;
    std::vector<double> params;    ///< packed
    std::uint32_t layers = 1;      ///< a LayerMask: where a drain drains, and where the ball of a spawn starts
    std::vector<int> inputs;       ///< indices into Program::inputs
    int solid = -1;                ///< index into Program::fixed.solids, or -1
    int mover = -1;                ///< index into Program::movers, or -1
    int sensor = -1;               ///< index into Program::sensors, or -1

    /// Is it a part of this struct's type?
    template <class P>
    bool is() const { return type->key() == P::describe().meta.key; }
    /// Its parameters; texts and names keep their defaults.
    template <class P>
    P as() const { return load<P>(params.data()); }
};

/// As Material (engine/scene/records.h), with the color ready for drawing.
struct MaterialRecord {
    std::string name;
    double restitution = 0.3, falloff = 0, tangential = 0, friction = 0.3, scatter_degrees = 0;
    std::string color;  ///< the author's text; empty: the theme decides
};

/// As PhysicsSettings, with gravity in the plane worked out.
struct PhysicsRecord {
    double step = 0.001;
    Integrator integrator = Integrator::symplectic_euler;
    Vec2 gravity{0, 0};  ///< m/s^2; of a ball that rolls on the playfield, what is left for its way
    double ball_radius = 0.0135, ball_mass = 0.08, ball_restitution = 0.8;
    double ball_inertia = 0.5;        ///< in units of m r^2
    double rolling_resistance = 0;    ///< m/s^2, against the way a ball goes on the playfield
    double tolerance = 1e-7, rest_speed = 0.005;
};

}  // namespace pinfield
