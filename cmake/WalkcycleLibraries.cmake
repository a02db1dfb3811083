# The libraries as users link them: walkcycle::loaders, walkcycle::render, ... and walkcycle::walkcycle for all.
#
# Static, each is the folder's own library. Shared, there are two: libwalkcycle (all that needs no OpenGL) and
# libwalkcycle-render; walkcycle::loaders and the rest then lead to one of them.

set(WALKCYCLE_CORE_FOLDERS animation crowd model io loaders profiles)
set(WALKCYCLE_RENDER_FOLDERS)
if(WALKCYCLE_BUILD_RENDER)
    set(WALKCYCLE_RENDER_FOLDERS platform render)
endif()

# walkcycle_add_shared(TARGET FILE_NAME FOLDERS... DEPENDS ...)
function(walkcycle_add_shared target file_name)
    cmake_parse_arguments(ARG "" "" "FOLDERS;DEPENDS" ${ARGN})
    list(TRANSFORM ARG_FOLDERS REPLACE "(.+)" "$<TARGET_OBJECTS:walkcycle_\\1>" OUTPUT_VARIABLE objects)
    add_library(${target} SHARED ${objects})
    set_target_properties(${target} PROPERTIES OUTPUT_NAME ${file_name} LINKER_LANGUAGE CXX
        EXPORT_NAME ${target} VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    target_compile_features(${target} PUBLIC cxx_std_20)
    target_include_directories(${target} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_link_libraries(${target} ${ARG_DEPENDS})
    target_link_options(${target} PRIVATE -Wl,--no-undefined)
endfunction()

# walkcycle::NAME for users: an alias of `target`, under the name that find_package(walkcycle) gives it, too.
function(walkcycle_publish name target)
    if(NOT BUILD_SHARED_LIBS)
        add_library(walkcycle::${name} ALIAS walkcycle_${name})
        return()
    endif()
    add_library(walkcycle_public_${name} INTERFACE)
    set_target_properties(walkcycle_public_${name} PROPERTIES EXPORT_NAME ${name})
    target_link_libraries(walkcycle_public_${name} INTERFACE ${target})
    add_library(walkcycle::${name} ALIAS walkcycle_public_${name})
endfunction()

if(BUILD_SHARED_LIBS)
    walkcycle_add_shared(walkcycle_core walkcycle FOLDERS ${WALKCYCLE_CORE_FOLDERS} DEPENDS
        PUBLIC glm::glm PRIVATE ${WALKCYCLE_CORE_LIBRARIES})
    if(WALKCYCLE_BUILD_RENDER)
        walkcycle_add_shared(walkcycle_gl walkcycle-render FOLDERS ${WALKCYCLE_RENDER_FOLDERS} DEPENDS
            PUBLIC walkcycle_core PRIVATE ${WALKCYCLE_RENDER_LIBRARIES})
    endif()
endif()
foreach(folder ${WALKCYCLE_CORE_FOLDERS})
    walkcycle_publish(${folder} walkcycle_core)
endforeach()
foreach(folder ${WALKCYCLE_RENDER_FOLDERS})
    walkcycle_publish(${folder} walkcycle_gl)
endforeach()

if(WALKCYCLE_BUILD_RENDER)
    add_library(walkcycle_walkcycle INTERFACE)
    set_target_properties(walkcycle_walkcycle PROPERTIES EXPORT_NAME walkcycle)
    target_link_libraries(walkcycle_walkcycle INTERFACE walkcycle::render walkcycle::platform walkcycle::profiles
        walkcycle::crowd)
    add_library(walkcycle::walkcycle ALIAS walkcycle_walkcycle)
endif()
