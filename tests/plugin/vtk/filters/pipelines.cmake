# SPDX-License-Identifier: MIT
# Runs the examples as a user would; included by examples/, where their targets are.
set(folder ${CMAKE_CURRENT_BINARY_DIR}/pipelines)
file(MAKE_DIRECTORY ${folder})
set(dem ${PROJECT_SOURCE_DIR}/data/jacksboro_srtm3.tif)
set(compare /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/compare_pieces.py)

function(pipeline_test name)
  cmake_parse_arguments(_test "" "SETUP;REQUIRED" "COMMAND" ${ARGN})
  add_test(NAME vtk_pipelines.${name} COMMAND ${_test_COMMAND} WORKING_DIRECTORY ${folder})
  set_tests_properties(vtk_pipelines.${name} PROPERTIES TIMEOUT 120)
  if(_test_SETUP)
    set_tests_properties(vtk_pipelines.${name} PROPERTIES FIXTURES_SETUP ${_test_SETUP})
  endif()
  if(_test_REQUIRED)
    set_tests_properties(vtk_pipelines.${name} PROPERTIES FIXTURES_REQUIRED "${_test_REQUIRED}")
  endif()
endfunction()

pipeline_test(terrain SETUP vtk_terrain
              COMMAND arete_cli refine ${dem} dem.vti --scheme gentle --levels 0 --overwrite)
pipeline_test(cpp REQUIRED vtk_terrain COMMAND example_vtk_refine dem.vti surface.vtp)

if(ARETE_HAVE_VTK_PYTHON)
  pipeline_test(python REQUIRED vtk_terrain SETUP vtk_python
                COMMAND ${CMAKE_COMMAND} -E env
                        PYTHONPATH=${PROJECT_BINARY_DIR}/${ARETE_PYTHON_DIR} /usr/bin/python3
                        ${PROJECT_SOURCE_DIR}/examples/vtk_refine.py dem.vti python.vti gentle)
endif()

find_program(MPIEXEC mpiexec)
if(MPIEXEC AND TARGET example_vtk_refine_mpi)
  set(outputs)
  foreach(ranks 1 2 3 4)
    pipeline_test(mpi_${ranks} REQUIRED vtk_terrain SETUP vtk_ranks
                  COMMAND timeout 100 ${MPIEXEC} --allow-run-as-root --oversubscribe -n ${ranks}
                          $<TARGET_FILE:example_vtk_refine_mpi> dem.vti ranks-${ranks}.pvti
                          dubuc-deslauriers:points=6 3)
    set_tests_properties(vtk_pipelines.mpi_${ranks} PROPERTIES PROCESSORS 2)
    list(APPEND outputs ranks-${ranks}.pvti)
  endforeach()
  # More pieces than ranks: each makes and writes its own one after the other.
  pipeline_test(mpi_many_pieces REQUIRED vtk_terrain SETUP vtk_ranks
                COMMAND timeout 100 ${MPIEXEC} --allow-run-as-root --oversubscribe -n 2
                        $<TARGET_FILE:example_vtk_refine_mpi> dem.vti many.pvti
                        dubuc-deslauriers:points=6 3 5)
  # One rank is the whole: a single piece.
  pipeline_test(ranks_are_bit_identical REQUIRED vtk_ranks
                COMMAND ${compare} ranks-1.pvti ${outputs} many.pvti)
  # The program's rows run the other way, so its sums along y are taken in the opposite order.
  pipeline_test(program REQUIRED vtk_terrain SETUP vtk_ranks
                COMMAND arete_cli refine ${dem} program.vti --scheme dubuc-deslauriers:points=6
                        --levels 3 --overwrite)
  pipeline_test(as_the_program REQUIRED vtk_ranks
                COMMAND ${compare} --within 0.001 program.vti ranks-4.pvti)
endif()
