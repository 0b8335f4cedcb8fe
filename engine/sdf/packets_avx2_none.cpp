// For processors without AVX2: the kernels stay empty and the baseline's are used.
#include "engine/sdf/catalog.h"

namespace pinfield::sdf {

void fill_basic_shapes_avx2(PacketKernels*) {}
void fill_shapes_of_lines_avx2(PacketKernels*) {}
void fill_shapes_of_arcs_avx2(PacketKernels*) {}
void fill_shapes_of_curves_avx2(PacketKernels*) {}
void fill_operations_avx2(PacketKernels*) {}

}  // namespace pinfield::sdf
