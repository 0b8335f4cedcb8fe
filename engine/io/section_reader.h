// The sections of a table that are not nodes: inputs and tests.
#pragma once
#include "engine/io/read_context.h"
#include "engine/scene/scene.h"

namespace pinfield {

void read_inputs(ReadContext& context, Scene& scene, const YamlNode& section);

/// After the scene has been read: expectations name its nodes.
void read_tests(ReadContext& context, Scene& scene, const YamlNode& section);

}  // namespace pinfield
