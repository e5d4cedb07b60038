# SPDX-License-Identifier: MIT
# Build options, and the flags of our own targets (never global, never passed to users).

option(ARETE_BUILD_CLI "Build the program arete" ${PROJECT_IS_TOP_LEVEL})
option(ARETE_BUILD_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(ARETE_BUILD_EXAMPLES "Build the examples" ${PROJECT_IS_TOP_LEVEL})
option(ARETE_BUILD_BENCH "Build the benchmarks" OFF)
option(ARETE_WARNINGS_AS_ERRORS "Treat warnings in our own code as errors" OFF)
set(ARETE_SANITIZE OFF CACHE STRING
    "ON: build with AddressSanitizer and UndefinedBehaviorSanitizer; thread: with ThreadSanitizer")
set_property(CACHE ARETE_SANITIZE PROPERTY STRINGS OFF ON thread)
option(ARETE_COVERAGE "Count which lines of core are run (gcc; see scripts/check-coverage)" OFF)
set(_unity OFF)
if(ARETE_SANITIZE)
  set(_unity ON)
endif()
option(ARETE_UNITY "Compile several files of the adapters, the program and the tests at a time: quicker"
       ${_unity})
option(ARETE_FUZZ "Build libFuzzer programs, tests/fuzz (clang only)" OFF)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
if(PROJECT_IS_TOP_LEVEL)
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
endif()

# What every target of this tree is compiled with.
function(arete_target_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  if(ARETE_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON)
  endif()
  arete_compile_options(${target})
endfunction()

# The flags alone, for targets whose language standard is set elsewhere.
function(arete_compile_options target)
  # Contraction to fused multiply-add changes results between compilers and tilings.
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -ffp-contract=off)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # g++ 12 sees overlaps in std::string concatenation (GCC bug 105651) and uninitialised limbs in
    # Boost's integers, neither of which is there.
    target_compile_options(${target} PRIVATE -Wno-restrict -Wno-maybe-uninitialized)
  endif()
  if(ARETE_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(ARETE_SANITIZE STREQUAL "thread")
    target_compile_options(${target} PRIVATE -fsanitize=thread -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=thread)
  elseif(ARETE_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=all
                           -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
endfunction()

# libFuzzer learns from the branches of this target.
function(arete_fuzzed target)
  if(ARETE_FUZZ)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
endfunction()
