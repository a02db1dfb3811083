# What `cmake --install` puts where, so that find_package(walkcycle) finds it.
include(CMakePackageConfigHelpers)

set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/walkcycle")
foreach(folder animation model io loaders profiles platform render export walkcycle)
    if(TARGET walkcycle_${folder})
        install(TARGETS walkcycle_${folder} EXPORT walkcycle ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
        set(header_folder "${CMAKE_INSTALL_INCLUDEDIR}/walkcycle/${folder}")
        if(folder STREQUAL walkcycle)
            set(header_folder "${CMAKE_INSTALL_INCLUDEDIR}/walkcycle")
        endif()
        install(DIRECTORY "${PROJECT_SOURCE_DIR}/src/${folder}/" DESTINATION "${header_folder}"
            FILES_MATCHING PATTERN "*.h" PATTERN "*.inc" PATTERN shaders EXCLUDE)
    endif()
endforeach()
if(TARGET walkcycle)
    install(TARGETS walkcycle RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
endif()
file(GLOB characters "${PROJECT_SOURCE_DIR}/res/walker*.dae" "${PROJECT_SOURCE_DIR}/res/walker*.png")
install(FILES ${characters} DESTINATION "${CMAKE_INSTALL_DATADIR}/walkcycle")
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}")

install(EXPORT walkcycle NAMESPACE walkcycle:: FILE walkcycle-targets.cmake DESTINATION "${package_folder}")
configure_package_config_file(cmake/walkcycle-config.cmake.in "${PROJECT_BINARY_DIR}/walkcycle-config.cmake"
    INSTALL_DESTINATION "${package_folder}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/walkcycle-config-version.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/walkcycle-config.cmake" "${PROJECT_BINARY_DIR}/walkcycle-config-version.cmake"
    DESTINATION "${package_folder}")
