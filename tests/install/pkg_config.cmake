# SPDX-License-Identifier: MIT
# Installs the build tree, moves the prefix, and builds and runs the consumer with nothing but a
# compiler and pkg-config.
cmake_policy(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE _result OUTPUT_VARIABLE _out ERROR_VARIABLE _err
                  OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT _result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${_out}${_err}")
  endif()
  set(output ${_out} PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/first)
file(RENAME ${WORK}/first ${WORK}/prefix)
file(GLOB_RECURSE _found ${WORK}/prefix/*/arete.pc)
cmake_path(GET _found PARENT_PATH _folder)
set(ENV{PKG_CONFIG_PATH} ${_folder})
run(pkg-config --static --cflags --libs arete)
separate_arguments(_flags UNIX_COMMAND "${output}")
run(${CXX} ${CONSUMER}/consumer.cpp ${_flags} -o ${WORK}/consumer)
cmake_path(GET _folder PARENT_PATH _libraries)
set(ENV{LD_LIBRARY_PATH} ${_libraries})
run(${WORK}/consumer)
run(pkg-config --modversion arete)
if(NOT output STREQUAL VERSION)
  message(FATAL_ERROR "arete.pc says version '${output}', the project ${VERSION}")
endif()
