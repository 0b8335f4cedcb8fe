# A rebuild after switching branches or presets costs nothing when ccache is there; without it nothing changes.
find_program(PINFIELD_CCACHE ccache)
mark_as_advanced(PINFIELD_CCACHE)
if(PINFIELD_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${PINFIELD_CCACHE})
endif()
