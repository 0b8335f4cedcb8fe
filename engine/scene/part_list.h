// THE list of parts: a header and a name each. Only catalog.cpp reads it; whoever works with one part includes that part's header.
#pragma once
#include "engine/scene/parts/bumper.h"
#include "engine/scene/parts/domain.h"
#include "engine/scene/parts/drain.h"
#include "engine/scene/parts/flipper.h"
#include "engine/scene/parts/group.h"
#include "engine/scene/parts/plunger.h"
#include "engine/scene/parts/spawn.h"

namespace pinfield {

template <class... P>
struct PartList {};

using BuiltInParts = PartList<parts::Group, parts::Domain, parts::Flipper, parts::Bumper, parts::Plunger, parts::Drain, parts::Spawn>;

}  // namespace pinfield
