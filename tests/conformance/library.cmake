# pinfield_conformance: the laws every shape and operation obeys, as a library for whoever writes one (check.h). It belongs to no layer,
# and needs no test framework; built only when something links it.
add_library(pinfield_conformance STATIC EXCLUDE_FROM_ALL)
foreach(source brute_force check enclosure laws laws_of_enclosures laws_of_fields laws_of_kernels laws_of_likeness laws_of_outlines packets
        parameters subject)
    target_sources(pinfield_conformance PRIVATE ${CMAKE_CURRENT_LIST_DIR}/${source}.cpp)
endforeach()
target_link_libraries(pinfield_conformance
    PUBLIC pinfield_options pinfield_core pinfield_reflect pinfield_sdf
    PRIVATE pinfield_warnings)
pinfield_precompiled(pinfield_conformance engine)
