# Every third party, as Debian 12 packages it (cmake/packages.txt). A layer links only those its row of the layer table names.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(tl-expected REQUIRED)
find_package(xsimd REQUIRED)
set_target_properties(xsimd PROPERTIES INTERFACE_LINK_LIBRARIES "")  # Debian's names xtl: not needed, often not there
find_package(yaml-cpp REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)

# libstb-dev and libimgui-dev ship no CMake packages: give them targets like the others.
find_path(STB_INCLUDE_DIR stb/stb_image_write.h REQUIRED)
find_library(STB_LIBRARY stb REQUIRED)
add_library(stb INTERFACE IMPORTED)
target_include_directories(stb INTERFACE ${STB_INCLUDE_DIR})
target_link_libraries(stb INTERFACE ${STB_LIBRARY})

if(PINFIELD_EDITOR)
    find_package(glfw3 3.3 REQUIRED)
    set(OpenGL_GL_PREFERENCE GLVND)
    find_package(OpenGL REQUIRED)
    find_package(Freetype REQUIRED)
    find_path(IMGUI_INCLUDE_DIR imgui.h PATH_SUFFIXES imgui REQUIRED)
    find_library(IMGUI_LIBRARY imgui REQUIRED)
    add_library(imgui INTERFACE IMPORTED)
    target_include_directories(imgui INTERFACE ${IMGUI_INCLUDE_DIR} ${IMGUI_INCLUDE_DIR}/backends)
    target_link_libraries(imgui INTERFACE ${IMGUI_LIBRARY} stb Freetype::Freetype glfw OpenGL::GL ${CMAKE_DL_LIBS})
endif()

if(PINFIELD_TESTS)
    find_package(Catch2 2.13 REQUIRED)
    find_package(rapidcheck REQUIRED)
    include(Catch)
endif()
