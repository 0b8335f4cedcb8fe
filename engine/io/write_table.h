// A scene as canonical text: the form `pinfield format` prints.
#pragma once
#include <string>

#include "engine/scene/scene.h"

namespace pinfield {

/// Bare SI numbers, defaults left out, one line a node where it has no children. Reading it back gives the same scene,
/// except that fields at their defaults count as not given. Never meant to replace an author's file: it has no
/// comments.
std::string write_table(const Scene& scene);

}  // namespace pinfield
