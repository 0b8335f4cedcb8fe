#include "engine/sdf/families/shapes_of_lines.h"
#include "engine/sdf/packet_kernels.h"

namespace pinfield::sdf {

void fill_shapes_of_lines_avx2(PacketKernels* out) { fill_packets<Packet<xsimd::avx2>>(ShapesOfLines{}, out); }

}  // namespace pinfield::sdf
