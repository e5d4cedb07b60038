# SPDX-License-Identifier: MIT
# The VTK pipelines. They are run by tests/plugin/vtk/filters on a real terrain.
function(arete_vtk_example name)
  set(modules ${ARGN})
  find_package(VTK 9.1 REQUIRED COMPONENTS ${modules})
  list(TRANSFORM modules PREPEND VTK::)
  add_executable(example_${name} ${name}.cpp)
  arete_target_options(example_${name})
  # VTK's type macros leave a semicolon too many in the headers of its classes.
  target_compile_options(example_${name} PRIVATE -Wno-pedantic)
  target_link_libraries(example_${name} PRIVATE Arete::Filters ${modules})
  vtk_module_autoinit(TARGETS example_${name} MODULES ${modules})
endfunction()

arete_vtk_example(vtk_refine CommonCore CommonExecutionModel IOXML)
find_package(VTK 9.1 QUIET COMPONENTS ParallelMPI IOParallelXML)
if(TARGET VTK::ParallelMPI AND TARGET VTK::IOParallelXML)
  arete_vtk_example(vtk_refine_mpi CommonCore CommonExecutionModel IOXML IOParallelXML ParallelMPI)
endif()

if(ARETE_BUILD_TESTS AND TARGET arete_cli AND ARETE_HAVE_GDAL)
  include(${PROJECT_SOURCE_DIR}/tests/plugin/vtk/filters/pipelines.cmake)
endif()
