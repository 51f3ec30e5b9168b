# SPDX-License-Identifier: BSD-3-Clause
# The package for Debian and Ubuntu, by cpack: script/package configures for it and makes it.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME vtkwater)
set(CPACK_PACKAGE_CONTACT "The vtkWater contributors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Water surfaces for VTK that reflect their scene")
set(CPACK_PACKAGING_INSTALL_PREFIX "${CMAKE_INSTALL_PREFIX}")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${PROJECT_BINARY_DIR}/lib")
# Python's side of VTK, and what our off-screen window loads at run time
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3-vtk9, python3-numpy, libegl1, libegl-mesa0, libgl1-mesa-dri")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-pil, python3-tqdm")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libvtk9-dev")
include(CPack)
