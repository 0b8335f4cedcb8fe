# A rebuild after switching branches or presets costs nothing when ccache is there, and neither does a fresh clone: paths are told to it
# relative to the project. Without ccache nothing changes.
find_program(PINFIELD_CCACHE ccache)
mark_as_advanced(PINFIELD_CCACHE)
if(PINFIELD_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER
        ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${PINFIELD_CCACHE})
endif()
