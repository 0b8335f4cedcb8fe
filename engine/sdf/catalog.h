// THE list of shapes and operations. To add one: write its header, name it here, give it a scene in scenes/nodes/.
#pragma once
#include "engine/sdf/nodes/box.h"
#include "engine/sdf/nodes/circle.h"
#include "engine/sdf/operations/complement.h"
#include "engine/sdf/operations/mirror.h"
#include "engine/sdf/operations/union.h"

namespace pinfield::sdf {

template <template <class> class... N>
struct NodeList {
    static constexpr int size = sizeof...(N);
};

using BuiltIn = NodeList<Circle, Box, Union, Complement, Mirror>;

}  // namespace pinfield::sdf
