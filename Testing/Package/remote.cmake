# SPDX-License-Identifier: BSD-3-Clause
# Builds this tree as a remote module. VTK's sources are not at hand, so Remote/CMakeLists.txt here
# stands for VTK's: it scans and builds what lies in its Remote/ with the same calls.
include("${CMAKE_CURRENT_LIST_DIR}/run.cmake")

get_filename_component(source_dir "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
file(REMOVE_RECURSE "${WORK_DIR}")
file(COPY "${CMAKE_CURRENT_LIST_DIR}/Remote/CMakeLists.txt" DESTINATION "${WORK_DIR}/source")
foreach(part IN ITEMS CMakeLists.txt vtk.module cmake Module Testing) # without build folders
  file(COPY "${source_dir}/${part}" DESTINATION "${WORK_DIR}/source/Remote/Water")
endforeach()

# Does it build, and does it link? Nothing of it runs, so it is built in the fastest way: not optimised, and many
# files at a time.
run("${CMAKE_COMMAND}" -S "${WORK_DIR}/source" -B "${WORK_DIR}/build" -G "${GENERATOR}"
  "-DCMAKE_BUILD_TYPE=" "-DCMAKE_UNITY_BUILD=ON" "-DCMAKE_UNITY_BUILD_BATCH_SIZE=24"
  "-DVTK_DIR=${VTK_DIR}" "-DPython3_EXECUTABLE=${PYTHON}")
# Our Testing/ was taken in by that; building it a second time would show no more.
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/build" --target water_module)
if(NOT EXISTS "${WORK_DIR}/build/lib/libvtkRenderingWater.so")
  message(FATAL_ERROR "no library was built")
endif()
