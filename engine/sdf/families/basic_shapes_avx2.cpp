#include "engine/sdf/families/basic_shapes.h"
#include "engine/sdf/packet_kernels.h"

namespace pinfield::sdf {

void fill_basic_shapes_avx2(PacketKernels* out) { fill_packets<Packet<xsimd::avx2>>(BasicShapes{}, out); }

}  // namespace pinfield::sdf
