// Compiled for AVX2 (no fused multiply-add: every instruction set gives the same bits). Holds nothing but templates over
// Packet<avx2>; a test reads this object's symbols and refuses any that does not carry the instruction set in its name.
#include "engine/sdf/catalog.h"
#include "engine/sdf/isa.h"
#include "engine/sdf/packet_kernels.h"

namespace pinfield::sdf {
namespace {

template <template <class> class... N>
inline void fill_avx2(NodeList<N...>, PacketKernels* out) {
    ((*out++ = packet_kernels<N, Packet<xsimd::avx2>>()), ...);
}

}  // namespace

void fill_packets_avx2(PacketKernels* out) { fill_avx2(Compiled{}, out); }

}  // namespace pinfield::sdf
