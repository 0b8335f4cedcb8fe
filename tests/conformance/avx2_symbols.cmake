# cmake "-DOBJECTS=basic_shapes_avx2.cpp.o|operations_avx2.cpp.o" -DNM=nm -P avx2_symbols.cmake
#
# The linker keeps one of several equal weak functions. If that one was compiled for AVX2, the whole program dies on a processor without it:
# so the objects may define nothing global but their fill functions and what carries the instruction set in its name.
string(REPLACE "|" ";" objects "${OBJECTS}")
set(count 0)
foreach(object IN LISTS objects)
    execute_process(COMMAND ${NM} --demangle --defined-only --extern-only ${object}
        OUTPUT_VARIABLE listing RESULT_VARIABLE failure)
    if(failure)
        message(FATAL_ERROR "${NM} cannot read ${object}")
    endif()
    string(REPLACE ";" "," listing "${listing}")
    string(REPLACE "\n" ";" lines "${listing}")
    if(NOT listing MATCHES "fill_[a-z_]+_avx2")
        message(FATAL_ERROR "no fill function: is ${object} the right file?")
    endif()
    foreach(line IN LISTS lines)
        if(line STREQUAL "" OR line MATCHES "DW\\.ref\\.")
            continue()
        endif()
        math(EXPR count "${count} + 1")
        if(NOT line MATCHES "avx2")
            message(SEND_ERROR "compiled for AVX2 under a shared name: ${line}")
        endif()
    endforeach()
endforeach()
message(STATUS "${count} symbols, each with its instruction set in its name")
