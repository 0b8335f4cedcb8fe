# cmake -DOBJECT=packets_avx2.cpp.o -DNM=nm -P avx2_symbols.cmake
#
# The linker keeps one of several equal weak functions. If that one was compiled for AVX2, the whole program dies on a processor without it:
# so the object may define nothing global but the one fill function and what carries the instruction set in its name.
execute_process(COMMAND ${NM} --demangle --defined-only --extern-only ${OBJECT}
    OUTPUT_VARIABLE listing RESULT_VARIABLE failure)
if(failure)
    message(FATAL_ERROR "${NM} cannot read ${OBJECT}")
endif()
string(REPLACE ";" "," listing "${listing}")
string(REPLACE "\n" ";" lines "${listing}")
set(count 0)
foreach(line IN LISTS lines)
    if(line STREQUAL "" OR line MATCHES "DW\\.ref\\.")
        continue()
    endif()
    math(EXPR count "${count} + 1")
    if(NOT line MATCHES "avx2")
        message(SEND_ERROR "compiled for AVX2 under a shared name: ${line}")
    endif()
endforeach()
if(count LESS 10)
    message(FATAL_ERROR "only ${count} symbols: is ${OBJECT} the right file?")
endif()
message(STATUS "${count} symbols, each with its instruction set in its name")
