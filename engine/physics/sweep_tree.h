// Time of impact of a ball against a solid kept as a tree of shapes and operations: safe-time conservative advancement.
#pragma once
#include "engine/physics/motion.h"
#include "engine/program/program.h"

namespace pinfield {

/// A time during which a point moving along `motion` is certified to keep f > margin (outside) and -f > margin (inside),
/// where f is the field of `op`. The rules follow the tree: see the implementation.
sdf::Clearance clearance(const Field& field, int op, const Motion& motion, double duration, double margin, int& evaluations);

struct TreeSweep {
    double time = infinity;         ///< of the first contact
    Vec2 normal{0, 0};
    int leaf = -1;
    double clear_until = infinity;  ///< < duration when the budget ran out
    double start_distance = 0;      ///< lower bound of the centre's distance at the start
};
TreeSweep sweep_tree(const Field& field, int solid, const Motion& motion, double duration, double radius,
                     const ContactBand& band, int& evaluations);

}  // namespace pinfield
