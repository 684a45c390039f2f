# One static library a source folder, one test program beside it.
include(GoogleTest)
enable_testing()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

find_program(CCACHE ccache)
if(CCACHE)
  # Without these, and without -fpch-preprocess, ccache passes by every file that uses a precompiled header.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
endif()

# GCC 12 warns of overlapping and of endless copies in std::string's own operator+ (GCC bugs 105329 and 105651), the
# latter where the string's header was precompiled: the three warnings that it comes as are off.
add_library(drc_options INTERFACE)
target_compile_options(drc_options INTERFACE -march=${DRC_MARCH} -Wall -Wextra -Wpedantic -Wshadow
                       -Wnon-virtual-dtor -Werror -fno-math-errno -fno-trapping-math)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(drc_options INTERFACE -Wno-restrict -Wno-stringop-overflow -Wno-array-bounds -fpch-preprocess)
endif()
target_include_directories(drc_options INTERFACE ${CMAKE_CURRENT_SOURCE_DIR}/src)
target_compile_definitions(drc_options INTERFACE DRC_VERSION="${PROJECT_VERSION}")
if(DRC_SANITIZE)
  target_compile_options(drc_options INTERFACE -fsanitize=${DRC_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(drc_options INTERFACE -fsanitize=${DRC_SANITIZE})
  if(DRC_SANITIZE MATCHES "thread")
    # Boost.Asio's fences, which the sanitizer does not see, stand beside mutexes, which it does.
    target_compile_options(drc_options INTERFACE -Wno-tsan)
  endif()
endif()

# What most files include, and what most of the time that they take to compile goes to: compiled once. Headers full of
# inline functions (CLI11, JSON) do not belong here: what is precompiled is worked through in every file. The debug preset
# does without, and so finds files that forget to include what they use.
set(DRC_COMMON_HEADERS <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory> <numeric> <optional>
    <span> <string> <string_view> <variant> <vector> <fmt/core.h> <Imath/ImathColor.h> <Imath/ImathMatrix.h>
    <Imath/ImathVec.h>)

# drc_test_program(NAME SOURCES... LIBS...): one program of tests. -O1 because the loops that take long are the
# libraries'.
function(drc_test_program name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBS;DEFINITIONS")
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LIBS} GTest::gmock GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE DRC_SOURCE_DIR="${CMAKE_SOURCE_DIR}" ${arg_DEFINITIONS})
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  if(DRC_FIRST_TEST_PROGRAM)
    target_precompile_headers(${name} REUSE_FROM ${DRC_FIRST_TEST_PROGRAM})
  else()
    target_precompile_headers(${name} PRIVATE ${DRC_COMMON_HEADERS} <filesystem> <fstream> <random> <fmt/format.h>
                              <gmock/gmock.h> <gtest/gtest.h>)
    set(DRC_FIRST_TEST_PROGRAM ${name} CACHE INTERNAL "")
  endif()
  string(REPLACE "_tests" "" label ${name})
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
                       PROPERTIES LABELS ${label})
endfunction()

set(DRC_LIBRARIES_SO_FAR "" CACHE INTERNAL "")
set(DRC_FIRST_LIBRARY "" CACHE INTERNAL "")
set(DRC_FIRST_TEST_PROGRAM "" CACHE INTERNAL "")

# drc_library(NAME): the sources in src/NAME and its folders, linked to the libraries declared before it.
# SEPARATE: files are not compiled together where DRC_UNITY is on, because names of their unnamed namespaces are the same.
function(drc_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "SEPARATE" "" "")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/src/${name}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "(_test|/main|/processor_check)\\.cpp$")
  # The thread sanitizer has loops of its own: it does not understand oneTBB's.
  if(DRC_SANITIZE MATCHES "thread")
    list(FILTER sources EXCLUDE REGEX "/base/parallel\\.cpp$")
  else()
    list(FILTER sources EXCLUDE REGEX "/base/parallel_sanitized\\.cpp$")
  endif()
  file(GLOB_RECURSE test_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/src/${name}/*_test.cpp)
  if(sources)
    add_library(drc_${name} STATIC ${sources})
    if(DRC_UNITY AND NOT arg_SEPARATE)
      set_target_properties(drc_${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
      # Types of unnamed namespaces in a named type are as good as in a file of their own.
      target_compile_options(drc_${name} PRIVATE -Wno-subobject-linkage)
    endif()
    target_link_libraries(drc_${name} PUBLIC drc_options ${DRC_LIBRARIES_SO_FAR})
    if(DRC_FIRST_LIBRARY)
      target_precompile_headers(drc_${name} REUSE_FROM ${DRC_FIRST_LIBRARY})
    else()
      target_precompile_headers(drc_${name} PRIVATE ${DRC_COMMON_HEADERS})
      set(DRC_FIRST_LIBRARY drc_${name} CACHE INTERNAL "")
    endif()
  else()
    add_library(drc_${name} INTERFACE)
    target_link_libraries(drc_${name} INTERFACE drc_options ${DRC_LIBRARIES_SO_FAR})
  endif()
  set(DRC_LIBRARIES_SO_FAR drc_${name} ${DRC_LIBRARIES_SO_FAR} CACHE INTERNAL "")
  if(DRC_BUILD_TESTS AND test_sources)
    drc_test_program(${name}_tests SOURCES ${test_sources} LIBS drc_${name})
  endif()
endfunction()

# drc_link(NAME LIBS...): third-party libraries of a folder.
function(drc_link name)
  get_target_property(type drc_${name} TYPE)
  if(type STREQUAL "INTERFACE_LIBRARY")
    target_link_libraries(drc_${name} INTERFACE ${ARGN})
  else()
    target_link_libraries(drc_${name} PUBLIC ${ARGN})
  endif()
endfunction()
