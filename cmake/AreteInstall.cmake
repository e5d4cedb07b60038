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
        DESTINATION ${_package_dir} COMPONENT development)
if("opensubdiv" IN_LIST ARETE_INSTALLED_ADAPTERS)
  install(FILES ${PROJECT_SOURCE_DIR}/cmake/FindOpenSubdiv.cmake
          DESTINATION ${_package_dir} COMPONENT development)
endif()

# pkg-config knows core alone: the adapters' host libraries mostly have no .pc files.
get_target_property(_core_type arete_core TYPE)
if(_core_type STREQUAL "STATIC_LIBRARY")
  set(ARETE_PC_REQUIRES "Requires: tbb")
else()
  # The headers use oneTBB nowhere, so that a user of the shared library need not link it.
  set(ARETE_PC_REQUIRES "Requires.private: tbb")
endif()
file(RELATIVE_PATH ARETE_PC_UP /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(${PROJECT_SOURCE_DIR}/cmake/arete.pc.in ${PROJECT_BINARY_DIR}/arete.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/arete.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
        COMPONENT development)

# The manual and the completion are written by the program itself, so they say what it does.
if(ARETE_BUILD_CLI AND NOT CMAKE_CROSSCOMPILING)
  set(_manual ${PROJECT_BINARY_DIR}/manual)
  file(MAKE_DIRECTORY ${_manual}/man ${_manual}/bash-completion)
  set(_run)
  if(ARETE_SANITIZE)
    # Libraries of the program keep memory to the end; what leaks of ours is asked by the tests.
    set(_run ${CMAKE_COMMAND} -E env ASAN_OPTIONS=detect_leaks=0)
  endif()
  add_custom_command(
    OUTPUT ${_manual}/man/arete.1 ${_manual}/bash-completion/arete
    COMMAND ${_run} $<TARGET_FILE:arete_cli> generate man ${_manual}/man
    COMMAND ${_run} $<TARGET_FILE:arete_cli> generate bash-completion ${_manual}/bash-completion
    DEPENDS arete_cli VERBATIM)
  add_custom_target(arete_manual ALL DEPENDS ${_manual}/man/arete.1)
  install(DIRECTORY ${_manual}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
  install(FILES ${_manual}/bash-completion/arete
          DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/bash-completion/completions COMPONENT program)
endif()
