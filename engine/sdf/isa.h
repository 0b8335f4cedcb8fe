// One function per instruction set that has a translation unit of its own; see packets_avx2.cpp.
#pragma once
#include "engine/sdf/kernels.h"

namespace pinfield::sdf {

/// Writes the packet kernels of the nodes of catalog.h, in its order. Call only; run the kernels only where best_isa() allows.
void fill_packets_avx2(PacketKernels* out);

}  // namespace pinfield::sdf
