# What `cmake --install` puts where, so that find_package(walkcycle) and pkg-config find it.
include(CMakePackageConfigHelpers)

set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/walkcycle")

# The targets of one set: what needs no OpenGL (core), or the rest (render).
function(walkcycle_install_set set)
    install(TARGETS ${ARGN} EXPORT walkcycle-${set}
        ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
        LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}")
    install(EXPORT walkcycle-${set} NAMESPACE walkcycle:: FILE walkcycle-${set}-targets.cmake
        DESTINATION "${package_folder}")
endfunction()

set(prefix walkcycle_)
set(shared_core)
set(shared_render)
if(BUILD_SHARED_LIBS)
    set(prefix walkcycle_public_)
    set(shared_core walkcycle_core)
    set(shared_render walkcycle_gl)
endif()
list(TRANSFORM WALKCYCLE_CORE_FOLDERS PREPEND ${prefix} OUTPUT_VARIABLE core_targets)
list(TRANSFORM WALKCYCLE_RENDER_FOLDERS PREPEND ${prefix} OUTPUT_VARIABLE render_targets)
walkcycle_install_set(core ${shared_core} ${core_targets})
set(folders ${WALKCYCLE_CORE_FOLDERS})
if(WALKCYCLE_BUILD_RENDER)
    walkcycle_install_set(render ${shared_render} ${render_targets} walkcycle_walkcycle)
    list(APPEND folders ${WALKCYCLE_RENDER_FOLDERS})
    install(FILES "${PROJECT_SOURCE_DIR}/include/walkcycle/walkcycle.h"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/walkcycle")
endif()

# The public face, and nothing of src.
foreach(folder ${folders})
    if(EXISTS "${PROJECT_SOURCE_DIR}/include/walkcycle/${folder}")
        install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/walkcycle/${folder}"
            DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/walkcycle")
    endif()
endforeach()
install(FILES "${PROJECT_SOURCE_DIR}/include/walkcycle/Export.h"
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/walkcycle")

if(TARGET walkcycle)
    install(TARGETS walkcycle RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
    file(GLOB characters "${PROJECT_SOURCE_DIR}/res/walker*.dae" "${PROJECT_SOURCE_DIR}/res/walker*.png")
    install(FILES ${characters} "${PROJECT_SOURCE_DIR}/res/LICENSE" DESTINATION "${CMAKE_INSTALL_DATADIR}/walkcycle")
endif()
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/walkcycle-config.cmake.in"
    "${PROJECT_BINARY_DIR}/walkcycle-config.cmake" INSTALL_DESTINATION "${package_folder}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/walkcycle-config-version.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/walkcycle-config.cmake" "${PROJECT_BINARY_DIR}/walkcycle-config-version.cmake"
    DESTINATION "${package_folder}")

# pkg-config: walkcycle-loaders without OpenGL, walkcycle for all. A static library needs its own libraries named, too.
set(WALKCYCLE_PC_CORE "tinyxml2 libwebp libturbojpeg libzip libdeflate zlib")
set(WALKCYCLE_PC_RENDER "epoxy egl glfw3")
if(BUILD_SHARED_LIBS)
    set(WALKCYCLE_PC_REQUIRES "Requires.private")
    set(WALKCYCLE_PC_CORE_LIBS "-lwalkcycle")
    set(WALKCYCLE_PC_RENDER_LIBS "-lwalkcycle-render")
    set(WALKCYCLE_PC_ALL_REQUIRES "Requires: walkcycle-loaders\nRequires.private: ${WALKCYCLE_PC_RENDER}")
else()
    set(WALKCYCLE_PC_REQUIRES "Requires")
    set(WALKCYCLE_PC_CORE_LIBS "-lwalkcycle_profiles -lwalkcycle_loaders -lwalkcycle_crowd -lwalkcycle_model -lwalkcycle_io -lwalkcycle_animation -pthread")
    set(WALKCYCLE_PC_RENDER_LIBS "-lwalkcycle_render -lwalkcycle_platform")
    set(WALKCYCLE_PC_ALL_REQUIRES "Requires: walkcycle-loaders ${WALKCYCLE_PC_RENDER}")
endif()
configure_file("${PROJECT_SOURCE_DIR}/cmake/walkcycle-loaders.pc.in" "${PROJECT_BINARY_DIR}/walkcycle-loaders.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/walkcycle-loaders.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
if(WALKCYCLE_BUILD_RENDER)
    configure_file("${PROJECT_SOURCE_DIR}/cmake/walkcycle.pc.in" "${PROJECT_BINARY_DIR}/walkcycle.pc" @ONLY)
    install(FILES "${PROJECT_BINARY_DIR}/walkcycle.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
endif()
