// From the FILE of a command line to a table fit for use.
#pragma once
#include <string>
#include <vector>

#include "engine/io/load_table.h"
#include "engine/program/program.h"

namespace pinfield::cli {

/// All diagnostics, each as people read them, in the order of the text.
std::string text_of(const Diagnostics& diagnostics, const Sources& sources);

struct Table {
    Scene scene;
    ProgramPtr program;
};

/// Reads and compiles. Stops the command with exit 3 when the file cannot be read, with exit 1 and its diagnostics when it is
/// wrong; warnings go to stderr. Stops, too, where an output would take the place of a file that the table includes.
Table open_table(const std::string& path, const std::vector<std::string>& outputs = {});

/// What `eval` and the events print for a node: its id or path; "table" for what comes from the table's size.
std::string name_of(const Scene& scene, NodeId node);

}  // namespace pinfield::cli
