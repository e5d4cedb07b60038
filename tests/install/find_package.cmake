# SPDX-License-Identifier: MIT
# Installs the build tree into a prefix of its own, moves the prefix (it must be relocatable), and
# builds and runs a project that knows nothing but find_package(arete).
cmake_policy(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/first)
file(RENAME ${WORK}/first ${WORK}/prefix)
run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${WORK}/build -G ${GENERATOR}
    -DCMAKE_PREFIX_PATH=${WORK}/prefix "-DCOMPONENTS=${COMPONENTS}" -DCMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer)
if(NOT PROGRAM)
  return()
endif()
run(${WORK}/prefix/bin/arete --version)
# It finds its data wherever it was moved.
if("gdal" IN_LIST COMPONENTS AND "opensubdiv" IN_LIST COMPONENTS)
  run(${WORK}/prefix/bin/arete validate --levels 1)
endif()
