# SPDX-License-Identifier: BSD-3-Clause
# The package of the plugin for Debian and Ubuntu, by cpack: script/paraview --package makes it. It has all that
# it needs beside ParaView: the plugin, its representations, and the module built against ParaView's VTK.
set(water_series "${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}")
math(EXPR water_next "${ParaView_VERSION_MINOR} + 1")
set(water_folder "lib/${CMAKE_LIBRARY_ARCHITECTURE}/paraview-${water_series}/plugins/Water")
install(TARGETS Water WaterRepresentations
  LIBRARY DESTINATION "${water_folder}" COMPONENT debian EXCLUDE_FROM_ALL)
install(FILES $<TARGET_FILE:VTK::RenderingWater>
  DESTINATION "${water_folder}" COMPONENT debian EXCLUDE_FROM_ALL)
install(FILES "${CMAKE_CURRENT_SOURCE_DIR}/../LICENSE" RENAME copyright
  DESTINATION share/doc/vtkwater-paraview COMPONENT debian EXCLUDE_FROM_ALL)

set(CPACK_GENERATOR DEB)
set(CPACK_INSTALL_CMAKE_PROJECTS "${CMAKE_BINARY_DIR};${PROJECT_NAME};debian;/")
set(CPACK_PACKAGE_NAME vtkwater-paraview)
set(CPACK_PACKAGE_CONTACT "The vtkWater contributors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Water surfaces for ParaView that reflect the view's scene")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_DEPENDS
  "paraview (>= ${water_series}), paraview (<< ${ParaView_VERSION_MAJOR}.${water_next}~), libc6, libstdc++6")
if(NOT EXISTS "${ParaView_DIR}/vtk") # from 6.1 on, Debian's ParaView has no VTK of its own
  string(APPEND CPACK_DEBIAN_PACKAGE_DEPENDS ", libvtk${VTK_MAJOR_VERSION}.${VTK_MINOR_VERSION}")
endif()
include(CPack)
