# SPDX-License-Identifier: MIT
# The installed package: find_package(arete COMPONENTS gdal vtk ...) gives arete::core and more.
include(CMakePackageConfigHelpers)

get_property(ARETE_INSTALLED_ADAPTERS GLOBAL PROPERTY ARETE_ADAPTERS)
get_property(ARETE_VTK_COMPONENTS GLOBAL PROPERTY ARETE_VTK_COMPONENTS)
get_property(ARETE_VTK_HAS_EGL GLOBAL PROPERTY ARETE_VTK_HAS_EGL)
list(JOIN ARETE_VTK_COMPONENTS " " ARETE_VTK_COMPONENTS)
set(_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/arete)
configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/areteConfig.cmake.in ${PROJECT_BINARY_DIR}/areteConfig.cmake
  INSTALL_DESTINATION ${_package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/areteConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/areteConfig.cmake ${PROJECT_BINARY_DIR}/areteConfigVersion.cmake
        DESTINATION ${_package_dir})
if("opensubdiv" IN_LIST ARETE_INSTALLED_ADAPTERS)
  install(FILES ${PROJECT_SOURCE_DIR}/cmake/FindOpenSubdiv.cmake DESTINATION ${_package_dir})
endif()
