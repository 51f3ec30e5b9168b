# SPDX-License-Identifier: BSD-3-Clause
# water_embed_glsl(<headers> <file.glsl>... [SHARED <file.glsl>...]): makes vtkWaterX.h out of each vtkWaterX.glsl, anew
# whenever that changes, in the current binary folder. The header declares the text as
#   static const char* const vtkWaterX
# and vtkWaterGLSL.h, which includes all of them. The shared files
# are embedded as well, and a line
#   #include "vtkWaterY.glsl"
# in another one becomes the text of a shared file.
# <headers> receives the names of the headers, to be listed as sources.
#
# The same file is run by the build (cmake -P) with INPUT, OUTPUT and SHARED, and then does the work.

if(CMAKE_SCRIPT_MODE_FILE)
  get_filename_component(name "${INPUT}" NAME_WE)
  file(READ "${INPUT}" text)
  foreach(include IN LISTS SHARED)
    get_filename_component(included "${include}" NAME)
    string(FIND "${text}" "#include \"${included}\"" place)
    if(NOT place EQUAL -1)
      file(READ "${include}" part)
      string(REPLACE "#include \"${included}\"\n" "${part}" text "${text}")
    endif()
  endforeach()
  if(text MATCHES "#include[^\n]*")
    message(FATAL_ERROR "${INPUT}: ${CMAKE_MATCH_0}: no such file among the shaders")
  endif()
  # MSVC takes at most 16,380 bytes in one literal, and 65,535 in neighbours, which the compiler joins.
  string(LENGTH "${text}" rest)
  if(rest GREATER 65000)
    message(FATAL_ERROR "${INPUT} has ${rest} bytes with its includes; at most 65000 fit into a C++ literal of MSVC")
  endif()
  set(literals)
  while(rest GREATER 0)
    string(SUBSTRING "${text}" 0 16000 piece) # ASCII: characters are bytes
    string(APPEND literals "\n  R\"glsl(${piece})glsl\"")
    string(LENGTH "${piece}" taken)
    string(SUBSTRING "${text}" ${taken} -1 text)
    string(LENGTH "${text}" rest)
  endwhile()
  file(WRITE "${OUTPUT}" "// Made from ${name}.glsl; do not edit.
#ifndef ${name}_h
#define ${name}_h
static const char* const ${name} =${literals};
#endif
")
  return()
endif()

set(water_embed_script "${CMAKE_CURRENT_LIST_FILE}")

function(water_embed_glsl headers)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SHARED")
  list(TRANSFORM arg_SHARED PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/" OUTPUT_VARIABLE shared)
  set(made)
  set(all)
  foreach(file IN LISTS arg_UNPARSED_ARGUMENTS arg_SHARED)
    get_filename_component(name "${file}" NAME_WE)
    set(input "${CMAKE_CURRENT_SOURCE_DIR}/${file}")
    set(output "${CMAKE_CURRENT_BINARY_DIR}/${name}.h")
    add_custom_command(OUTPUT "${output}"
      COMMAND "${CMAKE_COMMAND}" "-DINPUT=${input}" "-DOUTPUT=${output}"
        "-DSHARED=${shared}" -P "${water_embed_script}"
      DEPENDS "${input}" ${shared} "${water_embed_script}"
      COMMENT "Embedding ${file}"
      VERBATIM)
    list(APPEND made "${output}")
    string(APPEND all "#include \"${name}.h\"\n")
  endforeach()
  set(output "${CMAKE_CURRENT_BINARY_DIR}/vtkWaterGLSL.h")
  file(GENERATE OUTPUT "${output}" CONTENT
    "// Made from the list of shaders; do not edit.\n#ifndef vtkWaterGLSL_h\n#define vtkWaterGLSL_h\n${all}#endif\n")
  list(APPEND made "${output}")
  set(${headers} "${made}" PARENT_SCOPE)
endfunction()
