// For processors without AVX2: the kernels stay empty and the baseline's are used.
#include "engine/sdf/catalog.h"

namespace pinfield::sdf {

void fill_basic_shapes_avx2(PacketKernels*) {}
void fill_basic_figures_avx2(PacketKernels*) {}
void fill_boxes_and_triangles_avx2(PacketKernels*) {}
void fill_shapes_of_lines_avx2(PacketKernels*) {}
void fill_sectors_and_lenses_avx2(PacketKernels*) {}
void fill_shapes_of_arcs_avx2(PacketKernels*) {}
void fill_beziers_and_conics_avx2(PacketKernels*) {}
void fill_shapes_of_curves_avx2(PacketKernels*) {}
void fill_operations_avx2(PacketKernels*) {}

}  // namespace pinfield::sdf
