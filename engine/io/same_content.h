// Do two scenes say the same?
#pragma once
#include "engine/scene/scene.h"

namespace pinfield {

/// In every section: same nodes, order, types, values bit for bit, inputs, tests; places in the text and ids do not count.
bool same_content(const Scene& a, const Scene& b);

}  // namespace pinfield
