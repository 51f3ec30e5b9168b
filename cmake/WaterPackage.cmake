# SPDX-License-Identifier: BSD-3-Clause
# The CMake package vtkWater, for the build tree and for the installation:
#   find_package(vtkWater)                   VTK::RenderingWater (finds VTK as well)
#   find_package(vtkWater COMPONENTS Core)   vtkWater::Core, plain C, no VTK needed
# and for the core alone a file for pkg-config, vtkwater-core.
# vtk_module_build has made the part about VTK::RenderingWater already.
include(CMakePackageConfigHelpers)

# The core's symbols are hidden in the module's library; C programs link this archive.
add_library(water_core_archive STATIC $<TARGET_OBJECTS:water_core>)
set_target_properties(water_core_archive PROPERTIES
  OUTPUT_NAME water_core
  EXPORT_NAME Core
  LINKER_LANGUAGE C)
get_target_property(water_core_rooms water_core INTERFACE_INCLUDE_DIRECTORIES)
target_include_directories(water_core_archive INTERFACE
  "${water_core_rooms}" # quoted: one expression, for the build tree alone, with a list in it
  "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/vtk-water>")
if(UNIX)
  target_link_libraries(water_core_archive INTERFACE m)
endif()
add_library(vtkWater::Core ALIAS water_core_archive)
install(TARGETS water_core_archive EXPORT vtkWaterCore
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development)
install(EXPORT vtkWaterCore NAMESPACE vtkWater:: FILE vtkWater-core-targets.cmake
  DESTINATION "${water_cmake_destination}" COMPONENT development)
export(EXPORT vtkWaterCore NAMESPACE vtkWater::
  FILE "${water_build_package_dir}/vtkWater-core-targets.cmake")

set(water_vtk_components ${WATER_DEPENDS} ${WATER_PRIVATE_DEPENDS})
foreach(component IN LISTS WATER_OPTIONAL_DEPENDS)
  if(TARGET VTK::${component})
    list(APPEND water_vtk_components ${component})
  endif()
endforeach()
string(REPLACE ";" " " water_vtk_component_names "${water_vtk_components}")
set(water_vtk_hint "\n    HINTS \"${VTK_DIR}\"")
if(SKBUILD OR WATER_RELOCATABLE) # goes to other machines
  set(water_vtk_hint)
endif()
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/vtkWaterConfig.cmake.in"
  "${water_build_package_dir}/vtkWaterConfig.cmake"
  INSTALL_DESTINATION "${water_cmake_destination}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${water_build_package_dir}/vtkWaterConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${water_build_package_dir}/vtkWaterConfig.cmake"
  "${water_build_package_dir}/vtkWaterConfigVersion.cmake"
  DESTINATION "${water_cmake_destination}" COMPONENT development)
file(RELATIVE_PATH water_pc_to_prefix
  "/prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/prefix")
configure_file("${PROJECT_SOURCE_DIR}/cmake/vtkwater-core.pc.in"
  "${water_build_package_dir}/vtkwater-core.pc" @ONLY)
install(FILES "${water_build_package_dir}/vtkwater-core.pc"
  DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT development)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/licenses/vtkWater" COMPONENT licenses)

# So that an example's own CMakeLists.txt, which begins with find_package(vtkWater), also builds as
# a part of this project.
set(vtkWater_DIR "${water_build_package_dir}")
