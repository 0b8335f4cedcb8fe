// The runtime form of a table: flat, immutable, anonymous. compile.h makes it from a Scene, patch.h changes one parameter,
// evaluate.h asks it for distances, raster.h for pictures, and physics plays on it.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/core/id.h"
#include "engine/program/bvh.h"
#include "engine/program/parts.h"
#include "engine/sdf/kernels.h"

namespace pinfield {

class Catalog;

/// Bit i: the i-th layer of Program::layers; bit 0 is the ground layer, where balls start.
using LayerMask = std::uint32_t;
inline constexpr LayerMask ground_layer = 1;

/// One shape or operation. Values and positions are in the Field's frame, metres; a kernel works in the op's local frame,
/// so what goes in is divided by `scale` and what comes out is multiplied by it.
struct Op {
    const sdf::Kernels* kernels = nullptr;
    int params = 0;       ///< offset of its packed block in Field::params
    int param_count = 0;
    int first_link = 0;   ///< its children: Field::links[first_link ... + child_count), each an op before this one
    int child_count = 0;
    int first_image = 0;  ///< of an images op: Field::images[first_image ... + image_count)
    int image_count = 0;
    Similarity local_from_field;
    double scale = 1;     ///< of the local frame, in metres per local metre
    Box2 bounds;          ///< of the solid, in the Field's frame
    Exactness exactness;
    NodeId origin;        ///< the scene node it was compiled from
    int material = 0;     ///< index into Program::materials
};

/// A member of the implicit union that a Field is.
struct Solid {
    int root = 0;         ///< op
    Box2 bounds;
    NodeId origin;        ///< its scene node
    int part = -1;        ///< index into Program::parts, or -1
    LayerMask layers = ground_layer;
    bool visible = true;
    bool is_domain = false;  ///< what lies outside the space where balls may be
    bool lowered = false; ///< its boundary is known as pieces: the distance is right on both sides
    double fit_error = 0; ///< metres that pieces stray at most from the zero lines they were fitted to: > 0 where some were
    double horizon = infinity;  ///< metres from the origin within which the pieces are all there: for solids without end
    int first_piece = 0;  ///< Field::pieces[first_piece ... + piece_count)
    int piece_count = 0;
};

/// A piece of the true boundary of a lowered solid, in the Field's frame.
struct BoundaryPiece {
    sdf::Piece piece;
    int solid = 0;
    int leaf = 0;         ///< the op whose outline it comes from: decides material and attribution
    LayerMask layers = ground_layer;  ///< of its solid
};

/// An implicit union of solids in one frame: the whole static table, one mover, or the region of one sensor.
struct Field {
    std::vector<Op> ops;               ///< post-order
    std::vector<int> links;
    std::vector<Similarity> images;    ///< field_from_field: where an image of the child lies, isometries
    std::vector<double> params;
    std::vector<Solid> solids;
    std::vector<BoundaryPiece> pieces;
    Bvh bvh;  ///< over pieces (entry i < pieces.size()) and tree solids (entry - pieces.size() = index into tree_solids)
    std::vector<int> tree_solids;      ///< solids that were not lowered
    double horizon = infinity;         ///< the least of the solids'
};

/// A solid with one degree of freedom q: it turns by q radians about `pivot`, or slides by q metres along `axis`. Where it then stands says
/// pose.h.
struct Mover {
    /// In the mover's frame: origin at the pivot, x axis along the part's own (its turn is not in the shapes but in the motion),
    /// metres. The part's scale and mirroring are in the shapes. At q = 0 world = pivot + rotation(cosine, sine) * p.
    Field field;
    int part = 0;       ///< index into Program::parts
    Vec2 pivot{0, 0};   ///< world
    double cosine = 1, sine = 0;  ///< of the part's turn in the world: mover frame -> world at q = 0
    double handedness = 1;        ///< -1 when the part's frame is mirrored: angles turn the other way
    bool slides = false;          ///< or turns
    Vec2 axis{0, 1};              ///< world, unit; of one that slides
    double bounding_radius = 0;  ///< largest distance of its solid from the pivot, metres
};

struct Sensor {
    Field field;  ///< in the world's frame
    int part = 0;
};

struct Program {
    std::shared_ptr<const Catalog> catalog;  ///< whose types the parts are of
    Field fixed;  ///< static solids, domain included, in the world's frame
    std::vector<Mover> movers;
    std::vector<Sensor> sensors;
    std::vector<Part> parts;
    std::vector<MaterialRecord> materials;  ///< [0] is the default one
    std::vector<std::string> inputs;
    std::vector<std::string> layers;  ///< [0] is the ground layer
    PhysicsRecord physics;
    Vec2 size{0, 0};  ///< of the table, metres
    std::string name;
};

using ProgramPtr = std::shared_ptr<const Program>;

}  // namespace pinfield
