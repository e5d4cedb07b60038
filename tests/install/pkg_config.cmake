# SPDX-License-Identifier: MIT
# Installs the build tree, moves the prefix, and builds and runs the consumer with nothing but a
# compiler and pkg-config.
cmake_policy(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

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
