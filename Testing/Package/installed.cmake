# SPDX-License-Identifier: BSD-3-Clause
# Installs the build tree into an empty prefix, then builds and runs a project that knows only that
# prefix and VTK.
include("${CMAKE_CURRENT_LIST_DIR}/run.cmake")

set(prefix "${WORK_DIR}/prefix")
file(REMOVE_RECURSE "${WORK_DIR}")
file(MAKE_DIRECTORY "${WORK_DIR}")

run("${CMAKE_COMMAND}" --install "${BINARY_DIR}" --prefix "${prefix}")
run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/Consumer" -B "${WORK_DIR}/consumer"
  -G "${GENERATOR}" "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}"
  "-DCMAKE_PREFIX_PATH=${prefix}" "-DVTK_DIR=${VTK_DIR}" "-DPython3_EXECUTABLE=${PYTHON}")
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/consumer" --config "${BUILD_TYPE}")

# Each header alone, as it comes.
if(EACH_HEADER)
  run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/Headers" -B "${WORK_DIR}/headers"
    -G "${GENERATOR}" "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}" "-DHEADERS_PREFIX=${prefix}"
    "-DCMAKE_PREFIX_PATH=${prefix}" "-DVTK_DIR=${VTK_DIR}" "-DPython3_EXECUTABLE=${PYTHON}")
  expect("headers: [1-9][0-9], [1-9][0-9] of them C's")
  string(REGEX MATCH "headers: [^\n]*" headers "${run_output}")
  run("${CMAKE_COMMAND}" --build "${WORK_DIR}/headers" --config "${BUILD_TYPE}")
  message("${headers}: each compiles alone")
else()
  message("headers: not each alone; the build tree with WATER_TESTS_ONCE does that")
endif()

# The CMake files know the prefix and VTK, and nothing of where we were built.
get_filename_component(source_dir "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
file(GLOB_RECURSE cmake_files "${prefix}/*.cmake" "${prefix}/*.pc")
if(NOT cmake_files)
  message(FATAL_ERROR "no CMake files were installed")
endif()
foreach(file IN LISTS cmake_files)
  file(READ "${file}" text)
  foreach(ours IN ITEMS "${source_dir}/Module" "${source_dir}/;" "${source_dir};" "${source_dir}\"" "${BINARY_DIR}/")
    string(FIND "${text}" "${ours}" at) # all of the tree would be too much: VTK may lie in it, in build/sdk
    if(NOT at EQUAL -1)
      message(FATAL_ERROR "${file} names a folder of ours: ${ours}")
    endif()
  endforeach()
endforeach()

# From here on nothing of the build tree may help.
set(ENV{LD_LIBRARY_PATH} "")
set(ENV{PYTHONPATH} "${prefix}/${PYTHON_DESTINATION}")
if(DEFINED ENV{VTK_AUTOLOAD_PATH})
  set(ENV{VTK_AUTOLOAD_PATH} "${prefix}/lib/vtkwater-plugins")
endif()

run("${WORK_DIR}/consumer/consumer_c")
expect("plan: rendered, box drawn, texture [1-9][0-9]* x [1-9]")
run("${WORK_DIR}/consumer/consumer_cxx")
expect("level 2")
expect("mirror rendered 1")
if(PYTHON)
  run("${PYTHON}" "${CMAKE_CURRENT_LIST_DIR}/Consumer/consumer.py")
  expect("vtkwater [0-9.]+ level 0")
endif()

# The core by pkg-config, and the example in C as a project of its own.
find_program(PKG_CONFIG pkg-config)
find_program(C_COMPILER cc)
file(GLOB_RECURSE pc "${prefix}/*/vtkwater-core.pc")
if(PKG_CONFIG AND C_COMPILER)
  get_filename_component(pc_dir "${pc}" DIRECTORY)
  set(ENV{PKG_CONFIG_PATH} "${pc_dir}")
  run("${PKG_CONFIG}" --modversion vtkwater-core)
  expect("^[0-9]+\\.[0-9]+\\.[0-9]+\n$")
  run(sh -c "'${C_COMPILER}' '${CMAKE_CURRENT_LIST_DIR}/Consumer/consumer.c' -o '${WORK_DIR}/consumer_pc' \
    $('${PKG_CONFIG}' --cflags --libs vtkwater-core)")
  run("${WORK_DIR}/consumer_pc")
  expect("plan: rendered, box drawn")
else()
  message("pkg-config or cc is not here: vtkwater-core.pc is not tried")
endif()
run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/../../Examples/C/FirstWater" -B "${WORK_DIR}/example_c"
  -G "${GENERATOR}" "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}" "-DCMAKE_PREFIX_PATH=${prefix}" "-DVTK_DIR=${VTK_DIR}"
  "-DPython3_EXECUTABLE=${PYTHON}")
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/example_c" --config "${BUILD_TYPE}")
run("${WORK_DIR}/example_c/FirstWaterC" "${WORK_DIR}/first_water.ppm")
expect("reflection rendered, 1 mesh reflected")
