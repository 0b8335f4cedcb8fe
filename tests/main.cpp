#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>
#include <stdlib.h>  // setenv is not in <cstdlib>

int main(int argc, char* argv[]) {
    // A random law judges the same tables in every run: whether a commit is good must not depend on luck. Who wants others says so in RC_PARAMS
    // (CONTRIBUTING.md).
    setenv("RC_PARAMS", "seed=1", 0);
    return Catch::Session().run(argc, argv);
}
