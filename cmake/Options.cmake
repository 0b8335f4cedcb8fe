# How Pinfield's own code is compiled. Interface targets, so that nothing leaks into global flags.

add_library(pinfield_options INTERFACE)
target_compile_features(pinfield_options INTERFACE cxx_std_20)
target_include_directories(pinfield_options INTERFACE ${PROJECT_SOURCE_DIR})

# A fused multiply-add rounds once where a multiply and an add round twice, and each compiler fuses where it likes.
# A recorded game must replay to the same bits from every compiler and every processor, so nothing is fused.
target_compile_options(pinfield_options INTERFACE -ffp-contract=off)

# The bodies of tests and the reading of a command line need not be fast themselves: a quarter of their compile time (engine/DECISIONS.md 34).
add_library(pinfield_test_options INTERFACE)
target_compile_options(pinfield_test_options INTERFACE $<$<CONFIG:Release>:-O1>)

# Bounds checks in the standard library, where the build is for finding mistakes and not for speed.
target_compile_definitions(pinfield_options INTERFACE $<$<CONFIG:Debug>:_GLIBCXX_ASSERTIONS>)

if(PINFIELD_SANITIZE)
    set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_compile_options(pinfield_options INTERFACE ${sanitizers} -O1)
    target_link_options(pinfield_options INTERFACE ${sanitizers})
endif()

if(PINFIELD_TIDY)
    find_program(PINFIELD_CLANG_TIDY NAMES clang-tidy-14 clang-tidy REQUIRED)
    set(CMAKE_CXX_CLANG_TIDY ${PINFIELD_CLANG_TIDY})
endif()

add_library(pinfield_warnings INTERFACE)
target_compile_options(pinfield_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion
    $<$<BOOL:${PINFIELD_DEVELOPER}>:-Werror>)
# GCC 12 takes the short-string branches of std::string for copies that overlap or overflow once they are inlined (its bug 105651); a
# precompiled header no longer counts as the system's, where such warnings are muted.
target_compile_options(pinfield_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-stringop-overflow>)

if(PINFIELD_SANITIZE)
    # gcc's own manual warns that this warning errs in instrumented code; it does so in the standard library's <regex>.
    target_compile_options(pinfield_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()
