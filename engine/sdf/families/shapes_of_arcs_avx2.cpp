#include "engine/sdf/families/shapes_of_arcs.h"
#include "engine/sdf/packet_kernels.h"

namespace pinfield::sdf {

void fill_shapes_of_arcs_avx2(PacketKernels* out) { fill_packets<Packet<xsimd::avx2>>(ShapesOfArcs{}, out); }

}  // namespace pinfield::sdf
