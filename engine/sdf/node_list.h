// Node templates by name, as one type.
#pragma once

namespace pinfield::sdf {

template <template <class> class... N>
struct NodeList {};

}  // namespace pinfield::sdf
