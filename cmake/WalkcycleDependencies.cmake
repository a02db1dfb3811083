# What Walkcycle stands on, found once (scripts/packages has the names of Debian's packages).

find_package(glm REQUIRED)
find_package(tinyxml2 REQUIRED)
find_package(ZLIB REQUIRED)
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(WEBP REQUIRED IMPORTED_TARGET libwebp)
pkg_check_modules(TURBOJPEG REQUIRED IMPORTED_TARGET libturbojpeg)
pkg_check_modules(DEFLATE REQUIRED IMPORTED_TARGET libdeflate)
pkg_check_modules(LIBZIP REQUIRED IMPORTED_TARGET libzip)
find_path(STB_INCLUDE_DIR stb_image.h PATH_SUFFIXES stb REQUIRED)
set(WALKCYCLE_CORE_LIBRARIES tinyxml2::tinyxml2 ZLIB::ZLIB PkgConfig::WEBP PkgConfig::TURBOJPEG PkgConfig::LIBZIP
    PkgConfig::DEFLATE Threads::Threads)

if(WALKCYCLE_BUILD_RENDER)
    pkg_check_modules(EPOXY REQUIRED IMPORTED_TARGET epoxy)
    pkg_check_modules(EGL REQUIRED IMPORTED_TARGET egl)
    find_package(glfw3 3.3 REQUIRED)
    set(WALKCYCLE_RENDER_LIBRARIES PkgConfig::EPOXY PkgConfig::EGL glfw)
endif()

if(WALKCYCLE_BUILD_APP)
    find_package(CLI11 REQUIRED)
    find_package(nlohmann_json REQUIRED)
endif()
