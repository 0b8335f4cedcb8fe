// Shapes that the program makes of its own are packed as an author's would be.
#include <catch2/catch.hpp>

#include "engine/reflect/erase.h"
#include "engine/sdf/kernels.h"
#include "engine/sdf/nodes/box.h"
#include "engine/sdf/nodes/circle.h"
#include "engine/sdf/nodes/uneven_capsule.h"
#include "engine/sdf/operations/repeat.h"
#include "engine/sdf/register.h"

using namespace pinfield;

namespace {

template <template <class> class N>
void check_store(const N<double>& node) {
    const NodeType& type = sdf::built_in_type(N<double>::describe().meta.key);
    INFO(type.key());
    std::vector<double> packed = pack(type, values_of(node), type.kernels->derived_count);
    type.kernels->derive(packed.data());
    CHECK(store(node) == packed);
    CHECK(store(load<N<double>>(packed.data())) == packed);
}

}  // namespace

TEST_CASE("a node stored is the node packed by its values, derived ones included") {
    check_store(sdf::Circle<double>{.radius = 0.013});
    check_store(sdf::Box<double>{.size = {0.3, 0.2}, .round = 0.01});
    check_store(sdf::UnevenCapsule<double>{});
    check_store(sdf::Repeat<double>{.count = {3, 5}, .step = {0.1, 0.2}});
}
