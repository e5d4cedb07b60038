# SPDX-License-Identifier: MIT
# Builds and runs a project that takes arete in by add_subdirectory.
cmake_policy(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${WORK})
# Not optimised, several files at once: it is built anew each time.
run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${WORK} -G ${GENERATOR} -DARETE=${SOURCE}
    -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 -DCMAKE_UNITY_BUILD=ON)
run(${CMAKE_COMMAND} --build ${WORK} --target consumer)
run(${WORK}/consumer)
if(EXISTS ${WORK}/bin/arete)
  message(FATAL_ERROR "the program was built for a project that only takes the library")
endif()
