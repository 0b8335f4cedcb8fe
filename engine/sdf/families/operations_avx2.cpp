#include "engine/sdf/families/operations.h"
#include "engine/sdf/packet_kernels.h"

namespace pinfield::sdf {

void fill_operations_avx2(PacketKernels* out) { fill_packets<Packet<xsimd::avx2>>(Operations{}, out); }

}  // namespace pinfield::sdf
