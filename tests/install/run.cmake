# SPDX-License-Identifier: MIT
# run(COMMAND ...): stops with what it printed if it fails; `output` is its standard output.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE _result OUTPUT_VARIABLE _out ERROR_VARIABLE _err
                  OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT _result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${_out}${_err}")
  endif()
  set(output ${_out} PARENT_SCOPE)
endfunction()
