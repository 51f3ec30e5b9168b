# SPDX-License-Identifier: BSD-3-Clause
# Reads the dependencies out of vtk.module, which is their only list, into
#   WATER_DEPENDS, WATER_PRIVATE_DEPENDS, WATER_OPTIONAL_DEPENDS, WATER_TEST_DEPENDS
# without the VTK::, as find_package(VTK) wants them.
get_filename_component(water_module_file "${CMAKE_CURRENT_LIST_DIR}/../vtk.module" ABSOLUTE)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${water_module_file}")

foreach(section IN ITEMS DEPENDS PRIVATE_DEPENDS OPTIONAL_DEPENDS TEST_DEPENDS)
  set(WATER_${section})
endforeach()
file(STRINGS "${water_module_file}" lines)
foreach(line IN LISTS lines)
  if(line MATCHES "^[A-Z_]+$")
    set(section "${line}")
  elseif(section MATCHES "DEPENDS$" AND line MATCHES "^ *VTK::([A-Za-z0-9]+)$")
    list(APPEND WATER_${section} ${CMAKE_MATCH_1})
  endif()
endforeach()
