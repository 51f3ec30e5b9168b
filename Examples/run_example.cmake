# SPDX-License-Identifier: BSD-3-Clause
# Runs an example as a test:
#   cmake -DPICTURE=<file> -DLEAST_BYTES=<n> -P run_example.cmake -- <command>...
#     it must end with 0 and leave a picture that is not blank: a PNG of one colour, or of a gradient
#     background alone, stays far below the size asked for
#   cmake -DERROR=<text> -P run_example.cmake -- <command>...
#     it must say the text and end with an exit code of its own: not 0, and no crash
#   cmake -DSAYS=<text> -P run_example.cmake -- <command>...
#     it must say the text and end with 0, and leave no file called --help
set(command)
set(is_command FALSE)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(i RANGE ${last})
  if(is_command)
    list(APPEND command "${CMAKE_ARGV${i}}")
  elseif(CMAKE_ARGV${i} STREQUAL "--")
    set(is_command TRUE)
  endif()
endforeach()

if(PICTURE)
  file(REMOVE "${PICTURE}") # of an earlier run
endif()
execute_process(COMMAND ${command} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
message("${output}")

if(ERROR)
  if(NOT result MATCHES "^[12]$")
    message(FATAL_ERROR "Exit code ${result}; it should be 1 or 2")
  endif()
  if(NOT output MATCHES "${ERROR}")
    message(FATAL_ERROR "It did not say: ${ERROR}")
  endif()
  return()
endif()

if(NOT result STREQUAL "0")
  message(FATAL_ERROR "Exit code ${result}; it should be 0")
endif()
if(SAYS)
  if(NOT output MATCHES "${SAYS}")
    message(FATAL_ERROR "It did not say: ${SAYS}")
  endif()
  if(EXISTS "${CMAKE_CURRENT_BINARY_DIR}/--help")
    message(FATAL_ERROR "It made a file --help")
  endif()
  return()
endif()
if(NOT EXISTS "${PICTURE}")
  message(FATAL_ERROR "No picture ${PICTURE}")
endif()
file(SIZE "${PICTURE}" bytes)
if(bytes LESS LEAST_BYTES)
  message(FATAL_ERROR "${PICTURE} has ${bytes} bytes, less than ${LEAST_BYTES}: it looks blank")
endif()
message("${PICTURE}: ${bytes} bytes")
