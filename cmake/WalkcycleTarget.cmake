# How a folder of src becomes a target, and what all of them are compiled with.

add_library(walkcycle_warnings INTERFACE)
target_compile_options(walkcycle_warnings INTERFACE -Wall -Wextra -Wshadow -Wconversion)
# GCC 12 sees overlapping, uninitialized and overrun memory inside std::string where there is none (its bugs 105651,
# 105562, 105329; which, depends on the length of the checkout's path);
# clang and the sanitizers look for the real ones.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(walkcycle_warnings INTERFACE -Wno-restrict -Wno-maybe-uninitialized -Wno-array-bounds
        -Wno-stringop-overflow -Wno-stringop-overread)
endif()
if(WALKCYCLE_WERROR)
    target_compile_options(walkcycle_warnings INTERFACE -Werror)
endif()

# The sanitizers go on everything, also on what links to it.
if(WALKCYCLE_SANITIZE)
    add_compile_options(-fsanitize=${WALKCYCLE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${WALKCYCLE_SANITIZE})
    if(WALKCYCLE_SANITIZE MATCHES address)
        add_compile_definitions(WALKCYCLE_ADDRESS_SANITIZER)  # what compilers define themselves differs
    endif()
endif()

# For programs that draw: see KeepLibraries.cpp.
function(walkcycle_keep_libraries program)
    if(WALKCYCLE_SANITIZE)
        target_sources(${program} PRIVATE "${PROJECT_SOURCE_DIR}/cmake/KeepLibraries.cpp")
    endif()
endfunction()

# The standard library's and GLM's headers, compiled once for all of src, or once for all tests with GoogleTest's:
# walkcycle_precompile(TARGET FROM), where FROM is walkcycle_precompiled or tests_precompiled.
set(WALKCYCLE_STEADY_HEADERS <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <optional> <span>
    <stdexcept> <string> <string_view> <unordered_map> <vector> <glm/geometric.hpp> <glm/mat4x4.hpp> <glm/matrix.hpp>
    <glm/gtc/quaternion.hpp>)
function(walkcycle_precompile target from)
    if(WALKCYCLE_PRECOMPILE)
        target_precompile_headers(${target} REUSE_FROM ${from})
        target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)  # ccache wants it
    endif()
endfunction()
function(walkcycle_add_precompiled name)
    if(WALKCYCLE_PRECOMPILE)
        target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
        target_precompile_headers(${name} PRIVATE ${WALKCYCLE_STEADY_HEADERS} ${ARGN})
    endif()
endfunction()
add_library(walkcycle_precompiled OBJECT "${PROJECT_SOURCE_DIR}/cmake/Precompiled.cpp")
target_link_libraries(walkcycle_precompiled PRIVATE walkcycle_warnings glm::glm)
walkcycle_add_precompiled(walkcycle_precompiled)

# What only Walkcycle's own code may include: the private headers, below src.
add_library(walkcycle_private INTERFACE)
target_include_directories(walkcycle_private INTERFACE "${PROJECT_SOURCE_DIR}/src")

# walkcycle_add_library(model DEPENDS walkcycle_animation) makes walkcycle_model of src/model, rooms included: a static
# library that our own code links, whatever WalkcycleLibraries.cmake makes of it for users.
function(walkcycle_add_library folder)
    cmake_parse_arguments(ARG "" "" "DEPENDS;PRIVATE_DEPENDS" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp" "${CMAKE_CURRENT_SOURCE_DIR}/*.h"
        "${PROJECT_SOURCE_DIR}/include/walkcycle/${folder}/*.h")
    add_library(walkcycle_${folder} STATIC ${sources})
    set_target_properties(walkcycle_${folder} PROPERTIES EXPORT_NAME ${folder} LINKER_LANGUAGE CXX)
    target_compile_features(walkcycle_${folder} PUBLIC cxx_std_20)
    target_include_directories(walkcycle_${folder} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_link_libraries(walkcycle_${folder} PUBLIC ${ARG_DEPENDS} PRIVATE ${ARG_PRIVATE_DEPENDS}
        $<BUILD_INTERFACE:walkcycle_private> $<BUILD_INTERFACE:walkcycle_warnings>)
    walkcycle_precompile(walkcycle_${folder} walkcycle_precompiled)
endfunction()
