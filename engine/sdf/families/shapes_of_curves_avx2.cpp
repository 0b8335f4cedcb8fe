#include "engine/sdf/families/shapes_of_curves.h"
#include "engine/sdf/packet_kernels.h"

namespace pinfield::sdf {

void fill_shapes_of_curves_avx2(PacketKernels* out) { fill_packets<Packet<xsimd::avx2>>(ShapesOfCurves{}, out); }

}  // namespace pinfield::sdf
