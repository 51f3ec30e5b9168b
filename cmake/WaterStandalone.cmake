# SPDX-License-Identifier: BSD-3-Clause
# The project of its own: find VTK, build the module, wrap it for Python, install and test it.

# Options ------------------------------------------------------------------------------------------
option(BUILD_SHARED_LIBS "Build shared libraries" ON)
option(WATER_WERROR "Treat compiler warnings as errors" OFF)
option(WATER_WRAP_PYTHON "Build the Python package vtkwater" ON)
option(WATER_BUILD_EXAMPLES "Build the C and C++ examples" ON)
set(WATER_INSTALL_RPATH "" CACHE STRING
  "Where installed libraries look for VTK's; empty: where this VTK is")
option(WATER_RELOCATABLE "Name no folder of this machine in the installed CMake files" OFF)
set(WATER_SANITIZE "" CACHE STRING "Sanitizers for our code and its tests, e.g. address,undefined")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo" FORCE)
endif()
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(WATER_SANITIZE)
  add_compile_options(-fsanitize=${WATER_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${WATER_SANITIZE})
endif()

include(WaterHardening)

include(GNUInstallDirs)
include(CTest) # BUILD_TESTING

# VTK ----------------------------------------------------------------------------------------------
include(WaterModuleFile)
if(NOT BUILD_TESTING)
  set(WATER_TEST_DEPENDS)
endif()
find_package(VTK 9.1 REQUIRED
  COMPONENTS ${WATER_DEPENDS} ${WATER_PRIVATE_DEPENDS}
  OPTIONAL_COMPONENTS ${WATER_OPTIONAL_DEPENDS} ${WATER_TEST_DEPENDS} Python WrappingPythonCore)
message(STATUS "VTK ${VTK_VERSION} in ${VTK_DIR}")

if(WATER_WRAP_PYTHON AND NOT VTK_WRAP_PYTHON)
  message(STATUS "This VTK is not wrapped for Python: no package vtkwater")
  set(WATER_WRAP_PYTHON OFF)
endif()
if(WATER_WRAP_PYTHON)
  # VTK's own search found it already, but keeps the result to itself.
  find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
endif()

# The module ---------------------------------------------------------------------------------------
# One lib/ and one bin/ in the build tree, as after an installation.
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
# An installed library finds a VTK outside of the system's folders (PyPI's wheel, a home folder).
# CMAKE_INSTALL_RPATH_USE_LINK_PATH would not do: it passes over folders inside this project.
get_target_property(water_vtk_library VTK::CommonCore LOCATION)
get_filename_component(water_vtk_library_dir "${water_vtk_library}" DIRECTORY)
if(WATER_INSTALL_RPATH)
  list(APPEND CMAKE_INSTALL_RPATH ${WATER_INSTALL_RPATH})
elseif(NOT water_vtk_library_dir IN_LIST CMAKE_CXX_IMPLICIT_LINK_DIRECTORIES)
  list(APPEND CMAKE_INSTALL_RPATH "${water_vtk_library_dir}")
endif()

vtk_module_scan(
  MODULE_FILES "${PROJECT_SOURCE_DIR}/vtk.module"
  REQUEST_MODULES VTK::RenderingWater
  PROVIDES_MODULES water_modules
  ENABLE_TESTS OFF) # Testing/ is added below, with its own environment

# vtk_module_build gives the module the binary folder CMAKE_BINARY_DIR, which this project already
# has: for the length of the call that name means a folder inside.
set(water_cmake_destination "${CMAKE_INSTALL_LIBDIR}/cmake/vtkWater")
if(SKBUILD) # found with the package's folder in CMAKE_PREFIX_PATH
  set(water_cmake_destination "${CMAKE_INSTALL_LIBDIR}/lib/cmake/vtkWater")
endif()
set(water_binary_dir "${CMAKE_BINARY_DIR}")
set(CMAKE_BINARY_DIR "${water_binary_dir}/module")
set(water_build_package_dir "${CMAKE_BINARY_DIR}/${water_cmake_destination}")
vtk_module_build(
  MODULES ${water_modules}
  PACKAGE vtkWater
  INSTALL_EXPORT vtkWater
  INSTALL_HEADERS ON
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/vtk-water"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  CMAKE_DESTINATION "${water_cmake_destination}"
  HIERARCHY_DESTINATION "${CMAKE_INSTALL_LIBDIR}/vtk/hierarchy/vtkWater")
set(CMAKE_BINARY_DIR "${water_binary_dir}")

include(WaterPackage)
if(WATER_WRAP_PYTHON)
  add_subdirectory(Module/Python)
endif()

# Tests and examples -------------------------------------------------------------------------------
include(WaterTesting) # examples are tests, too
if(BUILD_TESTING)
  add_subdirectory(Testing)
endif()
if(WATER_BUILD_EXAMPLES AND EXISTS "${PROJECT_SOURCE_DIR}/Examples/CMakeLists.txt")
  add_subdirectory(Examples)
endif()

include(WaterDebian)
