// What makes one scene of another, as edits.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/scene/edit.h"

namespace pinfield {

/// The author's text of a node that is put in, as Insert::text; empty: there is none.
using TextOfNode = std::function<std::string(NodeId)>;

/// Edits, one after the other, that make `from` say what `to` says. Nodes are the same where they have the same id. Fails where no order of
/// them is known in which each leaves a sound scene.
Result<std::vector<Edit>> edits_between(const Scene& from, const Scene& to, const TextOfNode& text_of = {});

}  // namespace pinfield
