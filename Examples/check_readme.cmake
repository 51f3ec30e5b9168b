# SPDX-License-Identifier: BSD-3-Clause
# The code in README.md is that of the examples, word for word:
#   cmake -DREADME=<README.md> -P check_readme.cmake -- <example>...
# From an example counts what stands between "README: from here" and "README: to here", without the
# indentation of its first line.
file(READ "${README}" readme)
set(is_example FALSE)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(i RANGE ${last})
  if(is_example)
    file(READ "${CMAKE_ARGV${i}}" text)
    if(NOT text MATCHES "README: from here\n(.*)\n[^\n]*README: to here")
      message(FATAL_ERROR "${CMAKE_ARGV${i}} marks nothing for the README")
    endif()
    set(code "${CMAKE_MATCH_1}")
    if(code MATCHES "^( +)")
      string(REPLACE "\n${CMAKE_MATCH_1}" "\n" code "\n${code}")
    endif()
    string(FIND "${readme}" "${code}\n```" position)
    if(position EQUAL -1)
      message(FATAL_ERROR "README.md does not hold this code of ${CMAKE_ARGV${i}}:\n${code}")
    endif()
  elseif(CMAKE_ARGV${i} STREQUAL "--")
    set(is_example TRUE)
  endif()
endforeach()
