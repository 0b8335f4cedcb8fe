// Commands and options as a script that completes them in a shell.
#pragma once
#include <string>

#include "engine/cli/arguments.h"

namespace pinfield::cli {

/// For bash 4.4 and later, of a program of this name with subcommands: names of commands and options, words that an option takes, files where
/// it takes some. It defines the function _<name>. Made of what --help is made of, so the two cannot differ.
std::string bash_completion(const CommandForm& program);

}  // namespace pinfield::cli
