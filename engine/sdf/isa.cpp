#include "engine/sdf/kernels.h"

namespace pinfield::sdf {

Isa best_isa() {
#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
    if (__builtin_cpu_supports("avx2")) return Isa::avx2;
#endif
    return Isa::sse2;
}

}  // namespace pinfield::sdf
