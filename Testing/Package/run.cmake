# SPDX-License-Identifier: BSD-3-Clause
# run(<command>...) runs, shows the output and stops the script when it fails. The output is then in
# run_output, where expect(<regex>) looks.
function(run)
  string(REPLACE ";" " " line "${ARGV}")
  message(STATUS "${line}")
  execute_process(COMMAND ${ARGV}
    OUTPUT_VARIABLE output
    ERROR_VARIABLE output
    RESULT_VARIABLE result)
  message("${output}")
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed (${result}): ${line}")
  endif()
  set(run_output "${output}" PARENT_SCOPE)
endfunction()

function(expect regex)
  if(NOT run_output MATCHES "${regex}")
    message(FATAL_ERROR "expected in the output above: ${regex}")
  endif()
endfunction()
