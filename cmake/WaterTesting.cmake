# SPDX-License-Identifier: BSD-3-Clause
# How a test is run: functions for Testing/ and Examples/.
#
#   water_add_test(NAME <name> COMMAND <command>... [LABELS <label>...] [TIMEOUT <seconds>]
#     [PROPERTIES <property> <value>...] [ALL_WINDOWS | NO_WINDOW] [LARGE_PICTURES])
#   water_add_cxx_tests(TestA.cxx ... [LABELS <label>...] [QUICK TestA ...] [ONCE TestA ...] [WINDOWS TestA ...]
#     [ALONE TestA ...])
#   water_add_python_tests(TestA.py ... [LABELS <label>...] [QUICK TestA ...] [ONCE TestA ...] [WINDOWS TestA ...]
#     [LARGE TestA ...])
#
# A test that renders is run under its own name in the first off-screen window that this VTK has. All windows
# render with the same rasteriser, so another one shows nothing new to most tests. WINDOWS (ALL_WINDOWS) names
# those that judge what depends on a window: contexts, the functions of GL, the state of GL, faults of a
# driver, what the pass leaves behind, and one picture. They are run in the other windows, too, as <name>-EGL
# with the label egl. WATER_TEST_ALL_WINDOWS=ON runs all tests in all windows. NO_WINDOW: it does not render.
#
# QUICK names those that `script/test --quick` runs, in the first window: they get the label quick.
#
# ONCE names those that judge formulas, shaders and our own Python. All build trees render with the same rasteriser, so a
# second VTK shows nothing new: WATER_TESTS_ONCE=OFF leaves them out of its build tree. The other tests there find
# WATER_TESTS_ONCE=0 in their environment, and may leave out what the first VTK has shown of the test itself.
#
# ALONE names those that are judged by their time. Nothing runs beside them.
#
# LARGE_PICTURES (LARGE): Mesa's llvmpipe compiles every shader by LLVM. For small pictures that takes most of a test's time,
# and half of it without LLVM's optimiser, which is off then (GALLIVM_PERF=nopt). For large ones it would take longer.
#
# Every test finds in its environment: our library and Python package, VTK_DATA_ROOT (Testing/Data),
# VTK_BASELINE_ROOT and WATER_TEST_OUTPUT, a folder for what it writes. In COMMAND, the word
# {output} stands for that folder.

if("${VTK_MAJOR_VERSION}.${VTK_MINOR_VERSION}" VERSION_LESS 9.4) # VTK_VERSION: not in VTK's build
  set(water_windows Own) # VTK has GLX only: the plugin gives it our EGL window
else()
  find_library(WATER_OSMESA_LIBRARY NAMES OSMesa libOSMesa.so.8 libOSMesa.so.6
    DOC "VTK loads it by itself; Mesa 25.1 was the first without")
  mark_as_advanced(WATER_OSMESA_LIBRARY)
  set(water_windows EGL)
  if(WATER_OSMESA_LIBRARY)
    set(water_windows OSMesa EGL)
  endif()
endif()
set(WATER_TEST_WINDOWS "${water_windows}" CACHE STRING
  "Off-screen windows the tests are run with: Own (VTK < 9.4), OSMesa, EGL")
option(WATER_TEST_ALL_WINDOWS "Run all tests in all windows, and not only those that depend on a window" OFF)
option(WATER_TESTS_ONCE "Add the tests of formulas and shaders; of several build trees one is enough" ON)
set(WATER_TEST_PREFIX "" CACHE STRING
  "Put before the tests' names, to tell build trees apart in one ctest run")

set(water_cmake_dir "${CMAKE_CURRENT_LIST_DIR}")
set(water_test_dir "${CMAKE_CURRENT_LIST_DIR}/../Testing")
get_filename_component(water_test_dir "${water_test_dir}" ABSOLUTE)
set(water_test_output "${CMAKE_BINARY_DIR}/Testing/Temporary")

# What VTK's own tests are failed by: errors in the log, a GL state that VTK knows nothing of (builds
# without NDEBUG look), leaks, pictures.
set(water_fail_regex
  "(^|\n)ERROR: " "ERR\\|" "Error in cache state" "instances? still around" "Failed Image Test" "ImageNotFound")

function(water_test_environment result window output)
  set(environment
    "DISPLAY=" # a window on a screen would differ with the screen
    "VTK_TESTING=1" # VTK switches antialiasing off
    "VTK_DATA_ROOT=${water_test_dir}/Data"
    "VTK_BASELINE_ROOT=${water_test_dir}/Data/Baseline"
    "WATER_TEST_OUTPUT=${output}"
    "LD_LIBRARY_PATH=${CMAKE_BINARY_DIR}/lib:$ENV{LD_LIBRARY_PATH}"
    "PYTHONPATH=${CMAKE_BINARY_DIR}/${WATER_PYTHON_DESTINATION}"
    "PYTHONDONTWRITEBYTECODE=1"
    "PYTEST_DISABLE_PLUGIN_AUTOLOAD=1" # nobody else's fixtures
    "OPENBLAS_NUM_THREADS=1") # numpy's: other tests have the other processors
  if(NOT WATER_TESTS_ONCE)
    list(APPEND environment "WATER_TESTS_ONCE=0")
  endif()
  if(window STREQUAL "Own")
    list(APPEND environment "VTK_AUTOLOAD_PATH=${CMAKE_BINARY_DIR}/lib/vtkwater-plugins")
  elseif(window STREQUAL "OSMesa")
    list(APPEND environment "VTK_DEFAULT_OPENGL_WINDOW=vtkOSOpenGLRenderWindow")
  else()
    list(APPEND environment "VTK_DEFAULT_OPENGL_WINDOW=vtk${window}RenderWindow")
  endif()
  set(${result} "${environment}" PARENT_SCOPE)
endfunction()

# What a test needs when our library is built with sanitizers. A Python does not link their runtime:
# it is loaded before all else, with the library that throws exceptions. Leaks are looked for in C++
# alone, as Python leaves much behind at its end; TestWaterLeaks counts what ours would be.
function(water_sanitizer_environment result command)
  set(environment
    "LSAN_OPTIONS=suppressions=${water_cmake_dir}/lsan.supp:print_suppressions=0"
    "TSAN_OPTIONS=suppressions=${water_cmake_dir}/tsan.supp:print_suppressions=0"
    "UBSAN_OPTIONS=print_stacktrace=1")
  if(WATER_WRAP_PYTHON AND "${Python3_EXECUTABLE}" IN_LIST command)
    if(WATER_SANITIZE MATCHES "thread")
      set(runtime libtsan.so)
    else()
      set(runtime libasan.so)
    endif()
    set(preload)
    foreach(library IN ITEMS ${runtime} libstdc++.so.6)
      execute_process(COMMAND "${CMAKE_CXX_COMPILER}" "-print-file-name=${library}"
        OUTPUT_VARIABLE path OUTPUT_STRIP_TRAILING_WHITESPACE)
      get_filename_component(path "${path}" REALPATH)
      list(APPEND preload "${path}")
    endforeach()
    string(REPLACE ";" ":" preload "${preload}")
    list(APPEND environment "LD_PRELOAD=${preload}" "ASAN_OPTIONS=detect_leaks=0")
  endif()
  set(${result} "${environment}" PARENT_SCOPE)
endfunction()

function(water_add_test)
  cmake_parse_arguments(PARSE_ARGV 0 arg "ALL_WINDOWS;NO_WINDOW;LARGE_PICTURES" "NAME;TIMEOUT" "COMMAND;LABELS;PROPERTIES")
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_NAME OR NOT arg_COMMAND)
    message(FATAL_ERROR "water_add_test(${ARGN}): wants NAME and COMMAND")
  endif()
  if(NOT BUILD_TESTING)
    return()
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 120)
  endif()
  if(WATER_SANITIZE)
    math(EXPR arg_TIMEOUT "10 * ${arg_TIMEOUT}") # what is looked for is reports, not hurry
  endif()

  list(GET WATER_TEST_WINDOWS 0 first_window)
  foreach(window IN LISTS WATER_TEST_WINDOWS)
    set(suffix "")
    if(NOT window STREQUAL first_window)
      if(NOT WATER_TEST_ALL_WINDOWS AND NOT arg_ALL_WINDOWS)
        break()
      endif()
      set(suffix "-${window}")
      string(TOLOWER ${window} window_label)
      list(APPEND arg_LABELS ${window_label})
      list(REMOVE_ITEM arg_LABELS quick)
    endif()
    set(name "${WATER_TEST_PREFIX}${arg_NAME}${suffix}")
    set(output "${water_test_output}${suffix}")
    file(MAKE_DIRECTORY "${output}")
    string(REPLACE "{output}" "${output}" command "${arg_COMMAND}")
    water_test_environment(environment ${window} "${output}")
    if(NOT arg_LARGE_PICTURES)
      list(APPEND environment "GALLIVM_PERF=nopt")
    endif()
    if(WATER_SANITIZE)
      water_sanitizer_environment(sanitizers "${command}")
      list(APPEND environment ${sanitizers})
    endif()

    add_test(NAME "${name}" COMMAND ${command})
    set_tests_properties("${name}" PROPERTIES
      ENVIRONMENT "${environment}"
      FAIL_REGULAR_EXPRESSION "${water_fail_regex}"
      LABELS "${arg_LABELS}"
      SKIP_RETURN_CODE 125
      SKIP_REGULAR_EXPRESSION "No module named '?(numpy|PIL|pytest|pyvista|netCDF4)" # the reason, in Python's words
      TIMEOUT ${arg_TIMEOUT}
      ${arg_PROPERTIES})
    if(arg_NO_WINDOW)
      break()
    endif()
  endforeach()
endfunction()

# The labels of one of the tests that QUICK is given for.
function(water_labels result test labels quick)
  if(test IN_LIST quick)
    list(APPEND labels quick)
  endif()
  set(${result} "${labels}" PARENT_SCOPE)
endfunction()

# The word ALL_WINDOWS for one of the tests that WINDOWS is given for.
function(water_all_windows result test windows)
  set(${result} "")
  if(test IN_LIST windows)
    set(${result} ALL_WINDOWS)
  endif()
  set(${result} "${${result}}" PARENT_SCOPE)
endfunction()

# A name in QUICK, ONCE or WINDOWS that is no test (any more) would be left out without a word.
function(water_check_names word names sources)
  foreach(test IN LISTS names)
    if(NOT "${test}.cxx" IN_LIST sources AND NOT "${test}.py" IN_LIST sources)
      message(FATAL_ERROR "${word} names ${test}, which is none of these tests")
    endif()
  endforeach()
endfunction()

# One executable for all files, in VTK's manner: TestA.cxx holds int TestA(int argc, char* argv[]).
# -V is always given: a picture without a baseline fails and is not passed over.
function(water_add_cxx_tests)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "TIMEOUT" "LABELS;QUICK;ONCE;WINDOWS;ALONE")
  water_check_names(QUICK "${arg_QUICK}" "${arg_UNPARSED_ARGUMENTS}")
  water_check_names(WINDOWS "${arg_WINDOWS}" "${arg_UNPARSED_ARGUMENTS}")
  water_check_names(ALONE "${arg_ALONE}" "${arg_UNPARSED_ARGUMENTS}")
  set(driver vtkRenderingWaterCxxTests)
  list(APPEND CMAKE_MODULE_PATH "${VTK_DIR}") # VTK's own build has its CMake files there already
  include(vtkTestingDriver) # what main does before a test
  create_test_sourcelist(sources ${driver}.cxx ${arg_UNPARSED_ARGUMENTS}
    EXTRA_INCLUDE vtkTestDriver.h)
  add_executable(${driver} ${sources})
  list(TRANSFORM WATER_DEPENDS PREPEND VTK:: OUTPUT_VARIABLE libraries)
  list(TRANSFORM WATER_TEST_DEPENDS PREPEND VTK:: OUTPUT_VARIABLE test_libraries)
  target_link_libraries(${driver} PRIVATE VTK::RenderingWater ${libraries} ${test_libraries})
  vtk_module_autoinit(TARGETS ${driver} MODULES VTK::RenderingWater ${libraries} ${test_libraries})
  target_compile_definitions(${driver} PRIVATE VTK_DEPRECATION_LEVEL=0) # see Module/CMakeLists.txt
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(${driver} PRIVATE -Wall -Wextra)
  endif()

  water_check_names(ONCE "${arg_ONCE}" "${arg_UNPARSED_ARGUMENTS}")
  foreach(source IN LISTS arg_UNPARSED_ARGUMENTS)
    get_filename_component(test "${source}" NAME_WE)
    if(test IN_LIST arg_ONCE AND NOT WATER_TESTS_ONCE)
      continue()
    endif()
    water_labels(labels ${test} "cxx;${arg_LABELS}" "${arg_QUICK}")
    water_all_windows(all_windows ${test} "${arg_WINDOWS}")
    set(properties)
    if(test IN_LIST arg_ALONE)
      set(properties PROPERTIES RUN_SERIAL ON)
    endif()
    water_add_test(NAME ${test} ${all_windows} ${properties}
      COMMAND ${driver} ${test}
        -D "${water_test_dir}/Data" -T "{output}" -V "${water_test_dir}/Data/Baseline/${test}.png"
      LABELS ${labels}
      TIMEOUT "${arg_TIMEOUT}")
  endforeach()
endfunction()

# Each file is a pytest file for the Python that VTK is wrapped for (Testing/Python/conftest.py). Output
# is not captured: what VTK writes into it counts, too.
function(water_add_python_tests)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "TIMEOUT" "LABELS;QUICK;ONCE;WINDOWS;LARGE")
  water_check_names(QUICK "${arg_QUICK}" "${arg_UNPARSED_ARGUMENTS}")
  water_check_names(WINDOWS "${arg_WINDOWS}" "${arg_UNPARSED_ARGUMENTS}")
  water_check_names(ONCE "${arg_ONCE}" "${arg_UNPARSED_ARGUMENTS}")
  water_check_names(LARGE "${arg_LARGE}" "${arg_UNPARSED_ARGUMENTS}")
  foreach(source IN LISTS arg_UNPARSED_ARGUMENTS)
    get_filename_component(test "${source}" NAME_WE)
    if(test IN_LIST arg_ONCE AND NOT WATER_TESTS_ONCE)
      continue()
    endif()
    water_labels(labels ${test} "python;${arg_LABELS}" "${arg_QUICK}")
    water_all_windows(all_windows ${test} "${arg_WINDOWS}")
    set(large_pictures)
    if(test IN_LIST arg_LARGE)
      set(large_pictures LARGE_PICTURES)
    endif()
    water_add_test(NAME ${test} ${all_windows} ${large_pictures}
      COMMAND "${Python3_EXECUTABLE}" -m pytest -s -q -p no:cacheprovider
        "${CMAKE_CURRENT_SOURCE_DIR}/${source}"
      LABELS ${labels}
      TIMEOUT "${arg_TIMEOUT}")
  endforeach()
endfunction()
