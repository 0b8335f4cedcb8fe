#include "engine/sdf/register.h"

#include <vector>

#include "engine/sdf/catalog.h"
#include "engine/sdf/isa.h"
#include "engine/sdf/make_kernels.h"

namespace pinfield::sdf {
namespace {

template <template <class> class... N>
std::vector<NodeType> all_types(NodeList<N...>) {
    std::vector<NodeType> types;
    (types.push_back(sdf_node_type<N>()), ...);
    return types;
}

/// The built-in kernels completed with those of the wider instruction sets.
template <template <class> class... N>
const std::array<Kernels, sizeof...(N)>& all_kernels(NodeList<N...>) {
    static const std::array<Kernels, sizeof...(N)> kernels = [] {
        std::array<Kernels, sizeof...(N)> out{kernels_of<N>()...};
        std::array<PacketKernels, sizeof...(N)> avx2{};
        fill_packets_avx2(avx2.data());
        for (std::size_t i = 0; i < out.size(); ++i) out[i].packets[static_cast<std::size_t>(Isa::avx2)] = avx2[i];
        return out;
    }();
    return kernels;
}

}  // namespace

void add_built_in(Catalogue& catalogue) {
    std::vector<NodeType> types = all_types(BuiltIn{});
    for (std::size_t i = 0; i < types.size(); ++i) {
        types[i].kernels = &all_kernels(Compiled{})[i];
        catalogue.add(std::move(types[i]));
    }
}

const Kernels& boundary_kernels() { return all_kernels(Compiled{}).back(); }

}  // namespace pinfield::sdf
