# pinfield_layer(<name>
#                [SOURCES file...]      its .cpp files, listed one by one
#                [USES layer...]        the layers its row of the layer table allows
#                [LIBRARIES target...]  third parties its headers show to those above
#                [PRIVATE_LIBRARIES target...])  third parties that stay inside its .cpp files
#
# Makes the library pinfield_<name>: static, or header-only when it has no sources.
function(pinfield_layer name)
    cmake_parse_arguments(PARSE_ARGV 1 LAYER "" "" "SOURCES;USES;LIBRARIES;PRIVATE_LIBRARIES")
    if(LAYER_UNPARSED_ARGUMENTS)
        message(FATAL_ERROR "pinfield_layer(${name}): what is '${LAYER_UNPARSED_ARGUMENTS}'?")
    endif()
    pinfield_existing(sources ${LAYER_SOURCES})
    list(TRANSFORM LAYER_USES PREPEND pinfield_)

    set(target pinfield_${name})
    if(sources)
        add_library(${target} STATIC ${sources})
        target_link_libraries(${target}
            PUBLIC pinfield_options ${LAYER_USES} ${LAYER_LIBRARIES}
            PRIVATE pinfield_warnings ${LAYER_PRIVATE_LIBRARIES})
    else()
        add_library(${target} INTERFACE)
        target_link_libraries(${target} INTERFACE pinfield_options ${LAYER_USES} ${LAYER_LIBRARIES})
    endif()
endfunction()

# Scaffolding while the layers are being written: leaves out listed files that are not there yet (configure again when they are).
function(pinfield_existing result)
    set(present)
    foreach(file IN LISTS ARGN)
        if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${file})
            list(APPEND present ${file})
        else()
            message(STATUS "not written yet: ${CMAKE_CURRENT_SOURCE_DIR}/${file}")
        endif()
    endforeach()
    set(${result} ${present} PARENT_SCOPE)
endfunction()
