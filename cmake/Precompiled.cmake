# The third-party headers that nearly every unit reads, parsed once: Eigen alone costs each unit most of a second. A target opts in by
# pinfield_precompiled(<target> engine|tests); what it includes is unchanged, and -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds without.
add_library(pinfield_precompiled_engine OBJECT ${CMAKE_CURRENT_LIST_DIR}/precompiled.cpp)
target_link_libraries(pinfield_precompiled_engine PRIVATE pinfield_options pinfield_warnings Eigen3::Eigen fmt::fmt tl::expected)
target_precompile_headers(pinfield_precompiled_engine PRIVATE
    <algorithm> <array> <cmath> <cstdint> <functional> <map> <memory> <optional> <span> <string> <string_view> <tuple> <utility> <variant> <vector>
    <Eigen/Core> <fmt/format.h> <tl/expected.hpp>)

if(PINFIELD_TESTS)
    add_library(pinfield_precompiled_tests OBJECT ${CMAKE_CURRENT_LIST_DIR}/precompiled.cpp)
    target_link_libraries(pinfield_precompiled_tests PRIVATE
        pinfield_options pinfield_warnings Eigen3::Eigen fmt::fmt tl::expected Catch2::Catch2)
    target_precompile_headers(pinfield_precompiled_tests PRIVATE
        <algorithm> <array> <cmath> <cstdint> <functional> <map> <memory> <optional> <span> <string> <string_view> <tuple> <utility> <variant> <vector>
        <Eigen/Core> <fmt/format.h> <tl/expected.hpp> <catch2/catch.hpp>)
endif()

function(pinfield_precompiled target set)
    target_precompile_headers(${target} REUSE_FROM pinfield_precompiled_${set})
endfunction()
