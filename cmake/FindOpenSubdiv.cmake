# SPDX-License-Identifier: MIT
# OpenSubdiv::osdCPU. Debian's own OpenSubdivConfig.cmake names static libraries that the package
# does not hold and is a hard error even with QUIET, hence this module.
find_path(OpenSubdiv_INCLUDE_DIR opensubdiv/far/topologyRefiner.h)
find_library(OpenSubdiv_LIBRARY osdCPU)
if(OpenSubdiv_INCLUDE_DIR AND EXISTS "${OpenSubdiv_INCLUDE_DIR}/opensubdiv/version.h")
  file(STRINGS "${OpenSubdiv_INCLUDE_DIR}/opensubdiv/version.h" _osd_version
       REGEX "#define OPENSUBDIV_VERSION_NUMBER")
  string(REGEX REPLACE ".* ([0-9])([0-9][0-9])([0-9][0-9])$" "\\1.\\2.\\3" OpenSubdiv_VERSION
                       "${_osd_version}")
  string(REGEX REPLACE "\\.0([0-9])" ".\\1" OpenSubdiv_VERSION "${OpenSubdiv_VERSION}")
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenSubdiv
  REQUIRED_VARS OpenSubdiv_LIBRARY OpenSubdiv_INCLUDE_DIR VERSION_VAR OpenSubdiv_VERSION)
if(OpenSubdiv_FOUND AND NOT TARGET OpenSubdiv::osdCPU)
  add_library(OpenSubdiv::osdCPU UNKNOWN IMPORTED)
  set_target_properties(OpenSubdiv::osdCPU PROPERTIES
    IMPORTED_LOCATION "${OpenSubdiv_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${OpenSubdiv_INCLUDE_DIR}")
endif()
mark_as_advanced(OpenSubdiv_INCLUDE_DIR OpenSubdiv_LIBRARY)
