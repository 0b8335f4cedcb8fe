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
    list(TRANSFORM LAYER_USES PREPEND pinfield_)

    set(target pinfield_${name})
    if(LAYER_SOURCES)
        add_library(${target} STATIC ${LAYER_SOURCES})
        target_link_libraries(${target}
            PUBLIC pinfield_options ${LAYER_USES} ${LAYER_LIBRARIES}
            PRIVATE pinfield_warnings ${LAYER_PRIVATE_LIBRARIES})
        pinfield_precompiled(${target} engine)
    else()
        add_library(${target} INTERFACE)
        target_link_libraries(${target} INTERFACE pinfield_options ${LAYER_USES} ${LAYER_LIBRARIES})
    endif()
endfunction()
