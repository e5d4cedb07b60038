# SPDX-License-Identifier: MIT
# Builds the VTK module in this folder against the VTK that was found, and wraps it for Python where
# VTK is wrapped. Included by plugin/vtk.
set(BUILD_SHARED_LIBS ON)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
vtk_module_scan(MODULE_FILES ${CMAKE_CURRENT_LIST_DIR}/vtk.module
                PROVIDES_MODULES _arete_modules WANT_BY_DEFAULT ON ENABLE_TESTS OFF)
vtk_module_build(MODULES ${_arete_modules} PACKAGE AreteVTK INSTALL_EXPORT AreteVTK
                 CMAKE_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/AreteVTK
                 HEADERS_COMPONENT vtk TARGETS_COMPONENT vtk
                 INSTALL_HEADERS ON HEADERS_DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/AreteVTK
                 LIBRARY_NAME_SUFFIX "" VERSION ${PROJECT_VERSION} SOVERSION 0)

# Python modules are loaded into an interpreter that knows nothing of sanitizers.
find_package(Python3 QUIET COMPONENTS Interpreter Development)
find_package(VTK 9.1 QUIET COMPONENTS CommonCore WrappingPythonCore Python)
set(ARETE_HAVE_VTK_PYTHON FALSE)
if(TARGET VTK::WrappingPythonCore AND Python3_FOUND AND NOT ARETE_SANITIZE)
  set(ARETE_HAVE_VTK_PYTHON TRUE)
  set(ARETE_PYTHON_DIR lib/python3/dist-packages)
  vtk_module_wrap_python(MODULES ${_arete_modules} PYTHON_PACKAGE aretevtk
                         MODULE_DESTINATION ${ARETE_PYTHON_DIR}
                         CMAKE_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/AreteVTK
                         COMPONENT vtk INSTALL_HEADERS OFF LIBRARY_DESTINATION ${CMAKE_INSTALL_LIBDIR}
                         TARGET AreteVTK::python)
else()
  message(STATUS "arete vtk: filters are not wrapped for Python")
endif()
set(ARETE_HAVE_VTK_PYTHON ${ARETE_HAVE_VTK_PYTHON} PARENT_SCOPE)
set(ARETE_PYTHON_DIR "${ARETE_PYTHON_DIR}" PARENT_SCOPE)

# vtk_module_build installs targets and properties, but no package file.
include(CMakePackageConfigHelpers)
get_target_property(_core_type arete_core TYPE)
set(ARETE_CORE_IS_SHARED FALSE)
if(_core_type STREQUAL "SHARED_LIBRARY")
  set(ARETE_CORE_IS_SHARED TRUE)
endif()
configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/AreteVTKConfig.cmake.in ${PROJECT_BINARY_DIR}/AreteVTKConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/AreteVTK)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/AreteVTKConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/AreteVTKConfig.cmake
              ${PROJECT_BINARY_DIR}/AreteVTKConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/AreteVTK COMPONENT vtk)
