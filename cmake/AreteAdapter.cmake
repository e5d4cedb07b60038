# SPDX-License-Identifier: MIT
# arete_adapter(name PACKAGE P CONFIG|MODULE DEBIAN "packages" [VERSION V])
# declares the option ARETE_WITH_<NAME> = AUTO | ON | OFF, looks for the host library, and adds
# plugin/<name> when it is there. What is built and what is missing is told at the end.

set_property(GLOBAL PROPERTY ARETE_ADAPTER_REPORT "")
set_property(GLOBAL PROPERTY ARETE_ADAPTERS "")

macro(arete_adapter name)
  cmake_parse_arguments(_adapter "CONFIG;MODULE" "PACKAGE;DEBIAN;VERSION" "" ${ARGN})
  string(TOUPPER ${name} _upper)
  set(ARETE_WITH_${_upper} AUTO CACHE STRING "Build the ${name} adapter: AUTO, ON or OFF")
  set_property(CACHE ARETE_WITH_${_upper} PROPERTY STRINGS AUTO ON OFF)
  set(ARETE_HAVE_${_upper} FALSE)
  if(ARETE_WITH_${_upper} STREQUAL "OFF")
    set(_state "off")
  elseif(NOT EXISTS "${PROJECT_SOURCE_DIR}/plugin/${name}/CMakeLists.txt")
    set(_state "not in this tree")
  else()
    if(_adapter_CONFIG)
      find_package(${_adapter_PACKAGE} ${_adapter_VERSION} CONFIG QUIET)
    else()
      find_package(${_adapter_PACKAGE} ${_adapter_VERSION} MODULE QUIET)
    endif()
    if(${_adapter_PACKAGE}_FOUND)
      set(ARETE_HAVE_${_upper} TRUE)
      set(_state "yes (${_adapter_PACKAGE} ${${_adapter_PACKAGE}_VERSION})")
      add_subdirectory(plugin/${name})
      set_property(GLOBAL APPEND PROPERTY ARETE_ADAPTERS ${name})
    elseif(ARETE_WITH_${_upper} STREQUAL "AUTO")
      set(_state "MISSING ${_adapter_PACKAGE}; on Debian: apt-get install ${_adapter_DEBIAN}")
    else()
      message(FATAL_ERROR "ARETE_WITH_${_upper} is ON but ${_adapter_PACKAGE} was not found; "
                          "on Debian: apt-get install ${_adapter_DEBIAN}")
    endif()
  endif()
  set_property(GLOBAL APPEND PROPERTY ARETE_ADAPTER_REPORT "  ${name}: ${_state}")
endmacro()

function(arete_report_adapters)
  get_property(report GLOBAL PROPERTY ARETE_ADAPTER_REPORT)
  list(JOIN report "\n" lines)
  message(STATUS "arete ${PROJECT_VERSION} adapters:\n${lines}")
endfunction()

# The interface of the shared library changed incompatibly when this number does.
set(ARETE_ABI_VERSION 1)

# arete_library(name SOURCES ... LINK ...): the library arete_<name>, alias arete::<name>, whose
# headers are <its folder>/arete/... Core follows BUILD_SHARED_LIBS; an adapter is always static, so
# that a shared core does not depend on every host library.
function(arete_library name)
  cmake_parse_arguments(_library "" "" "SOURCES;LINK" ${ARGN})
  if(name STREQUAL "core")
    add_library(arete_core ${_library_SOURCES})
    set_target_properties(arete_core PROPERTIES OUTPUT_NAME arete SOVERSION ${ARETE_ABI_VERSION}
                                                VERSION ${ARETE_ABI_VERSION}.${PROJECT_VERSION}
                                                DEFINE_SYMBOL "")
  else()
    add_library(arete_${name} STATIC ${_library_SOURCES})
  endif()
  add_library(arete::${name} ALIAS arete_${name})
  arete_target_options(arete_${name})
  set_target_properties(arete_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(
    arete_${name} PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}>
                         $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(arete_${name} ${_library_LINK})
  install(TARGETS arete_${name} EXPORT arete-${name}-targets
          LIBRARY COMPONENT runtime NAMELINK_COMPONENT development
          ARCHIVE COMPONENT development)
  install(EXPORT arete-${name}-targets NAMESPACE arete::
          DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/arete COMPONENT development)
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/arete DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
          COMPONENT development FILES_MATCHING PATTERN "*.h")
endfunction()
