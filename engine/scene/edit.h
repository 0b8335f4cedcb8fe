// An edit of the scene as a value, and its inverse.
#pragma once
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/scene/scene.h"

namespace pinfield {

/// Sets one field of one node (or record) to a value; `is_explicit` says whether the author's text is to say it.
struct Edit {
    NodeId node;
    int field = 0;  ///< index into the node type's fields
    Value value;
    bool is_explicit = true;
};

/// Why an edit cannot be applied (range, kind, contract, an id that is taken, a material that there is none of), or nothing: what
/// validate() would say of the scene with it.
std::optional<std::string> why_invalid(const Scene& scene, const Edit& edit);

/// Applies an edit that why_invalid() lets pass and returns the edit that undoes it, bit for bit.
Edit apply(Scene& scene, const Edit& edit);

}  // namespace pinfield
