// Time of impact of a ball against a whole Field standing still: the static table, or a mover seen from its own frame.
#pragma once
#include <vector>

#include "engine/core/at.h"
#include "engine/physics/sweep_pieces.h"

namespace pinfield {

/// What a ball meets.
struct FieldHit {
    double time = infinity;   ///< of the contact; when none, infinity
    Vec2 normal{0, 0};        ///< unit, out of the solid
    double concave_radius = 0;        ///< radius of a concave arc met from inside, else 0
    int solid = -1, leaf = -1;
    int piece = -1;           ///< of a lowered solid
};

struct FieldSweep {
    FieldHit hit;
    double clear_until = infinity;  ///< < duration when the budget ran out before a hit was certified
    double free_path = 0;           ///< metres from the start that need no further query; 0 unless asked for
};

/// A surface within reach of a ball.
struct Touch {
    Vec2 normal{0, 0};
    double gap = 0;  ///< metres between ball and surface
    double concave_radius = 0;
    int solid = -1, leaf = -1, piece = -1;
};

struct SweepStats {
    std::int64_t sweeps = 0, capped = 0, evaluations = 0;
    int most_evaluations = 0;
};

/// A piece or a tree of a field, and the least distance of a point to it, metres.
struct Neighbour {
    double distance = 0;
    int entry = 0;  ///< of the field's hierarchy
};

/// What lies around a ball, so that most of its sweeps need no search (Verlet, "Computer experiments on classical fluids",
/// 1967). It holds for one field, and spares time without changing a bit of what is found.
struct Neighbours {
    Vec2 around{0, 0};
    double reach = -1;            ///< metres: everything nearer than this is listed
    std::vector<Neighbour> list;  ///< nearest first
};

/// A Field made ready for sweeping. Keeps a pointer to it.
class SweptField {
public:
    explicit SweptField(const Field& field);

    /// First contact within `duration`. `reach` is how far around the path it looks (at least the ball's way): the free path
    /// it can grant. A ball that moves little from one sweep to the next brings its `near`.
    FieldSweep sweep(const Motion& motion, double duration, double radius, const ContactBand& band, LayerMask layers,
                     double reach, SweepStats& stats, Neighbours* near = nullptr) const;
    /// All surfaces whose gap to a ball at p is at most `skin`, in order of solid and piece.
    void touching(const Vec2& p, double radius, double skin, LayerMask layers, std::vector<Touch>& out) const;
    const Field& field() const { return *field_; }
    const std::vector<SweepPiece>& pieces() const { return pieces_; }

private:
    /// Makes `near` hold everything within `needed` of p; false when that is too much for a list.
    bool gather(const Vec2& p, double needed, double radius, Neighbours& near) const;
    double least_distance(int entry, const Vec2& p) const;
    bool in_layers(int solid, LayerMask layers) const {
        return (at(field_->solids, solid).layers & layers) != 0;
    }

    const Field* field_;
    std::vector<SweepPiece> pieces_;
};

}  // namespace pinfield
