// The tables that File > New offers, as actions.
#pragma once
#include <string>

#include "engine/io/starters.h"

namespace pinfield::editor {

/// "new.classic"
inline std::string action_of(const Starter& starter) { return std::string("new.").append(starter.key); }

}  // namespace pinfield::editor
