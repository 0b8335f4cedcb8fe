# pinfield_conformance: the laws every shape and operation obeys, as a library for whoever writes one (check.h). It belongs to no layer,
# and needs no test framework; built only when something links it.
add_library(pinfield_conformance STATIC EXCLUDE_FROM_ALL)
foreach(source brute_force check laws laws_of_enclosures laws_of_fields laws_of_kernels laws_of_likeness laws_of_outlines packets
        parameters parametric_outlines subject subject_enclosure witness)
    target_sources(pinfield_conformance PRIVATE ${CMAKE_CURRENT_LIST_DIR}/${source}.cpp)
endforeach()

# The enclosures of all nodes, a unit for each family of engine/sdf/families/.
get_property(families GLOBAL PROPERTY pinfield_families)
set(add_functions "")
foreach(family IN LISTS families)
    get_property(Family GLOBAL PROPERTY pinfield_list_of_${family})
    set(source ${PROJECT_BINARY_DIR}/conformance/${family}_enclosures.cpp)
    configure_file(${CMAKE_CURRENT_LIST_DIR}/family_enclosures.cpp.in ${source} @ONLY)
    target_sources(pinfield_conformance PRIVATE ${source})
    list(APPEND add_functions add_${family}_enclosures)
endforeach()
list(JOIN add_functions ", " add_functions)
configure_file(${CMAKE_CURRENT_LIST_DIR}/all_enclosures.cpp.in ${PROJECT_BINARY_DIR}/conformance/all_enclosures.cpp @ONLY)
target_sources(pinfield_conformance PRIVATE ${PROJECT_BINARY_DIR}/conformance/all_enclosures.cpp)

target_link_libraries(pinfield_conformance
    PUBLIC pinfield_options pinfield_core pinfield_reflect pinfield_sdf
    PRIVATE pinfield_warnings)
pinfield_precompiled(pinfield_conformance engine)
