// For processors without AVX2: the kernels stay empty and the baseline's are used.
#include "engine/sdf/isa.h"

namespace pinfield::sdf {

void fill_packets_avx2(PacketKernels*) {}

}  // namespace pinfield::sdf
