# Puts the GLSL files of shaders/ into the library as strings, so that the program runs from any directory.
# This file is used twice: included, it defines the function below, which adds a build step to a target; run by that step
# as a script (cmake -DINPUTS=... -DOUTPUT=... -P), it writes the C++ file.

function(walkcycle_embed_shaders target)
    file(GLOB shaders CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/shaders/*.glsl")
    set(output "${CMAKE_CURRENT_BINARY_DIR}/EmbeddedShaders.cpp")
    string(REPLACE ";" "|" inputs "${shaders}")
    add_custom_command(OUTPUT "${output}"
        COMMAND ${CMAKE_COMMAND} "-DINPUTS=${inputs}" "-DOUTPUT=${output}" -P "${CMAKE_CURRENT_SOURCE_DIR}/EmbedShaders.cmake"
        DEPENDS ${shaders} "${CMAKE_CURRENT_SOURCE_DIR}/EmbedShaders.cmake"
        VERBATIM)
    target_sources(${target} PRIVATE "${output}")
endfunction()

if(CMAKE_SCRIPT_MODE_FILE)
    string(REPLACE "|" ";" inputs "${INPUTS}")
    set(text "#include \"render/ShaderSource.h\"\n\nnamespace walkcycle {\n\n")
    string(APPEND text "std::string_view shaderSource(std::string_view name) {\n")
    foreach(input ${inputs})
        get_filename_component(name "${input}" NAME_WE)
        file(READ "${input}" source)
        string(APPEND text "    if (name == \"${name}\") return R\"glsl(${source})glsl\";\n")
    endforeach()
    string(APPEND text "    return {};\n}\n\n}  // namespace walkcycle\n")
    file(WRITE "${OUTPUT}" "${text}")
endif()
