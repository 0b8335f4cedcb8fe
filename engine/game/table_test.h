// An entry of a table's `tests:`, run.
#pragma once
#include <string>
#include <vector>

#include "engine/program/program.h"
#include "engine/scene/scene.h"

namespace pinfield {

struct TestFailure {
    Place where;
    std::string message;
};

/// Plays the table as the test says, from its start, and tells what was not as expected; nothing: it passed. Drained balls come back to
/// their spawns as in a game; those that the test launched do not. A test whose launches cannot start fails, whatever it expects.
std::vector<TestFailure> run_table_test(const ProgramPtr& program, const Scene& scene, const TableTest& test);

}  // namespace pinfield
