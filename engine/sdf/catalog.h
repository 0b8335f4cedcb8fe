// THE list of shapes and operations: nine families, each a list in families/<family>.h. To add one: write its header, name it in the
// list of its family, give it a scene in scenes/nodes/. Every family is compiled in two units of its own, made from families/*.in, and
// this header includes no node: touching a shape recompiles its family, not the catalog.
#pragma once
#include <vector>

#include "engine/reflect/node_type.h"
#include "engine/sdf/kernels.h"

namespace pinfield::sdf {

/// Appends the family's node types, and their kernels but for what the function below fills in, in the order of its list.
using AddFamily = void(std::vector<NodeType>& types, std::vector<Kernels>& kernels);
AddFamily add_basic_shapes, add_basic_figures, add_boxes_and_triangles, add_shapes_of_lines, add_sectors_and_lenses,
    add_shapes_of_arcs, add_beziers_and_conics, add_shapes_of_curves, add_operations;

/// Writes the family's packet kernels for AVX2, in the order of its list. Run them only where best_isa() allows.
using FillPackets = void(PacketKernels* out);
FillPackets fill_basic_shapes_avx2, fill_basic_figures_avx2, fill_boxes_and_triangles_avx2, fill_shapes_of_lines_avx2,
    fill_sectors_and_lenses_avx2, fill_shapes_of_arcs_avx2, fill_beziers_and_conics_avx2, fill_shapes_of_curves_avx2,
    fill_operations_avx2;

struct Family {
    AddFamily* add;
    FillPackets* fill_avx2;
};
/// In the order of the catalog.
inline constexpr Family families[] = {
    {add_basic_shapes, fill_basic_shapes_avx2},
    {add_basic_figures, fill_basic_figures_avx2},
    {add_boxes_and_triangles, fill_boxes_and_triangles_avx2},
    {add_shapes_of_lines, fill_shapes_of_lines_avx2},
    {add_sectors_and_lenses, fill_sectors_and_lenses_avx2},
    {add_shapes_of_arcs, fill_shapes_of_arcs_avx2},
    {add_beziers_and_conics, fill_beziers_and_conics_avx2},
    {add_shapes_of_curves, fill_shapes_of_curves_avx2},
    {add_operations, fill_operations_avx2},
};

}  // namespace pinfield::sdf
