// What of a scene stands in files that the table includes: it is changed there, as other tables may include them, too.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "engine/scene/scene.h"

namespace pinfield {

/// Of the children of a node (or, for none, the top level), of the materials and of the inputs: how many. They come before the table's own.
int included_children(const Scene& scene, NodeId parent);
int included_materials(const Scene& scene);
int included_inputs(const Scene& scene);

/// For somebody who looks at the table's own text: "line 3", or "parts/walls.yaml:3".
std::string line_in_table(const Scene& scene, const Place& place);

// Why something is not changed, or nothing.
std::optional<std::string> why_elsewhere(const Scene& scene, std::string_view name, const Place& place);
/// Nothing is put before what is included, of which there are so many.
std::optional<std::string> why_before_included(int index, int included);
/// Something in another file goes by this name of a material or an input, which a change of the name here would leave behind.
std::optional<std::string> why_named_elsewhere(const Scene& scene, const std::string& name, Meaning sort);

}  // namespace pinfield
