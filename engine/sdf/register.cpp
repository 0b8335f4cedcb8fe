#include "engine/sdf/register.h"

#include <algorithm>
#include <cassert>

#include "engine/core/at.h"
#include "engine/sdf/catalog.h"

namespace pinfield::sdf {
namespace {

/// Every node of the families, and last the found outline, with all their kernels.
struct BuiltIn {
    std::vector<NodeType> types;
    std::vector<Kernels> kernels;
};

BuiltIn all_families() {
    BuiltIn out;
    for (const Family& family : families()) {
        const std::size_t first = out.kernels.size();
        family.add(out.types, out.kernels);
        const std::size_t count = out.kernels.size() - first;
        if (!family.fill_avx2) continue;
        std::vector<PacketKernels> avx2(count);
        family.fill_avx2(avx2.data());
        for (std::size_t i = 0; i < count; ++i) at(out.kernels[first + i].packets, Isa::avx2) = avx2[i];
    }
    for (std::size_t i = 0; i < out.types.size(); ++i) out.types[i].kernels = &out.kernels[i];
    return out;
}

const BuiltIn& built_in() {
    static const BuiltIn all = all_families();
    return all;
}

}  // namespace

void add_built_in(Catalog& catalog) {
    const std::vector<NodeType>& types = built_in().types;
    for (std::size_t i = 0; i + 1 < types.size(); ++i) catalog.add(types[i]);
}

const NodeType& built_in_type(std::string_view key) {
    const std::vector<NodeType>& types = built_in().types;
    const auto found = std::find_if(types.begin(), types.end(), [&](const NodeType& type) { return type.key() == key; });
    assert(found != types.end() && "a built-in part is made of built-in shapes");
    return *found;
}

const Kernels& found_outline_kernels() { return built_in().kernels.back(); }

}  // namespace pinfield::sdf
