# The third-party headers that nearly every unit reads, parsed once: Eigen alone costs each unit most of a second. A target opts in by
# pinfield_precompiled(<target> engine|tests); what it includes is unchanged, and -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds without.
set(precompiled_headers
    <algorithm> <array> <cmath> <cstdint> <functional> <map> <memory> <optional> <span> <string> <string_view> <tuple> <utility> <variant>
    <vector> <Eigen/Core> <fmt/format.h> <tl/expected.hpp>)

function(pinfield_precompile set library header)
    set(target pinfield_precompiled_${set})
    add_library(${target} OBJECT EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
    target_link_libraries(${target} PRIVATE pinfield_options pinfield_warnings Eigen3::Eigen fmt::fmt tl::expected ${library})
    target_precompile_headers(${target} PRIVATE ${precompiled_headers} ${header})
endfunction()

pinfield_precompile(engine "" "")
if(PINFIELD_TESTS)
    pinfield_precompile(tests Catch2::Catch2 <catch2/catch.hpp>)
    target_link_libraries(pinfield_precompiled_tests PRIVATE pinfield_test_options)
endif()

function(pinfield_precompiled target set)
    target_precompile_headers(${target} REUSE_FROM pinfield_precompiled_${set})
endfunction()
