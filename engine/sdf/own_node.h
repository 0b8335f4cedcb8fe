// A node of a program's own, complete: what its catalog takes. The engine's nodes have the same from units of their own, and packets of
// every instruction set.
#pragma once
#include "engine/sdf/make_kernels.h"

namespace pinfield::sdf {

/// The dispatch table of node template N, with packet kernels of the baseline instruction set.
template <template <class> class N>
const Kernels& kernels_of() {
    static const Kernels kernels = make_kernels<N>();
    return kernels;
}

/// Description and kernels of N together: what a Catalog takes.
template <template <class> class N>
NodeType sdf_node_type() {
    NodeType type = node_type<N<double>>();
    type.kernels = &kernels_of<N>();
    return type;
}

}  // namespace pinfield::sdf
