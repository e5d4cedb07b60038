# SPDX-License-Identifier: MIT
# Debian packages by CPack: libarete1, libarete-dev, arete and, where they are built, arete-vtk and
# meshlab-arete. `scripts/make-packages` configures for it (preset `package`) and runs CPack.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME arete)
set(CPACK_PACKAGE_VENDOR "The arete authors")
set(CPACK_PACKAGE_CONTACT "The arete authors <arete@users.noreply.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL runtime development program)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Libraries that no installed package holds, or that lie where the loader does not look: our own, which
# the packages name themselves, and MeshLab's.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/core)
if(ARETE_MESHLAB_LIBRARY)
  get_filename_component(_meshlab_folder ${ARETE_MESHLAB_LIBRARY} DIRECTORY)
  list(APPEND CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${_meshlab_folder})
endif()
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)

# arete_package(component package section "summary" DEPENDS ...)
function(arete_package component package section summary)
  cmake_parse_arguments(_package "" "" "DEPENDS" ${ARGN})
  string(TOUPPER ${component} upper)
  list(JOIN _package_DEPENDS ", " depends)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${summary}" PARENT_SCOPE)
endfunction()

set(_same "(= ${PROJECT_VERSION})")
arete_package(runtime libarete${ARETE_ABI_VERSION} libs
              "Parametric subdivision for terrain: shared library")
# Static adapters name their host libraries only when they are linked, so those are suggestions.
arete_package(development libarete-dev libdevel
              "Parametric subdivision for terrain: headers and static adapters"
              DEPENDS "libarete${ARETE_ABI_VERSION} ${_same}" libboost-dev libtbb-dev libeigen3-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "libgdal-dev, libvtk9-dev, libopenmesh-dev")
arete_package(program arete science
              "Parametric subdivision for terrain: the program"
              DEPENDS "libarete${ARETE_ABI_VERSION} ${_same}")
if(ARETE_HAVE_VTK)
  # Of its own, so that the library asks for no VTK.
  list(APPEND CPACK_COMPONENTS_ALL vtk)
  arete_package(vtk arete-vtk science
                "Parametric subdivision for terrain: filters for VTK, in C++ and Python"
                DEPENDS "libarete${ARETE_ABI_VERSION} ${_same}")
  set(CPACK_DEBIAN_VTK_PACKAGE_SUGGESTS "libarete-dev, libvtk9-dev, python3-vtk9")
endif()
if(TARGET filter_arete)
  list(APPEND CPACK_COMPONENTS_ALL meshlab)
  # The plugin is made for one release of MeshLab and must not meet another.
  arete_package(meshlab meshlab-arete graphics
                "Parametric subdivision for terrain: filters for MeshLab"
                DEPENDS "libarete${ARETE_ABI_VERSION} ${_same}" "meshlab (>= 2020.09)"
                        "meshlab (<< 2021)")
endif()

foreach(_component runtime development program vtk meshlab)
  if(_component IN_LIST CPACK_COMPONENTS_ALL)
    string(TOUPPER ${_component} _upper)
    install(FILES ${PROJECT_SOURCE_DIR}/cmake/debian-copyright
            DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/${CPACK_DEBIAN_${_upper}_PACKAGE_NAME}
            RENAME copyright COMPONENT ${_component})
  endif()
endforeach()

include(CPack)
