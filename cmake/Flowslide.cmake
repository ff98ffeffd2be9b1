# SPDX-License-Identifier: GPL-2.0-or-later
# What every target of the project shares: warnings, sanitizers, and one function per kind of target.

add_library(flowslide_options INTERFACE)
set(warnings -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
target_compile_options(flowslide_options INTERFACE "$<BUILD_INTERFACE:${warnings}>")
# No contraction into fused multiply-adds: results shall not depend on what the compiler found to fuse. That holds for
# what the headers make in a project that uses the library, too.
target_compile_options(flowslide_options INTERFACE -ffp-contract=off)
target_compile_features(flowslide_options INTERFACE cxx_std_20)
target_include_directories(flowslide_options INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/core>
                                                       $<INSTALL_INTERFACE:include>)
if(FLOWSLIDE_WERROR)
  target_compile_options(flowslide_options INTERFACE -Werror)
endif()
if(FLOWSLIDE_SANITIZE)
  target_compile_options(flowslide_options INTERFACE -fsanitize=${FLOWSLIDE_SANITIZE} -fno-sanitize-recover=undefined
                         -fno-omit-frame-pointer)
  target_link_options(flowslide_options INTERFACE -fsanitize=${FLOWSLIDE_SANITIZE})
endif()

# Headers that most files include: precompiled, once for the libraries and programs, once for the tests. Half of the
# compile time was parsing these. Every file still names what it uses: the preset dev precompiles nothing and compiles
# each source alone.
set(flowslide_common_headers <algorithm> <array> <cmath> <filesystem> <functional> <map> <string> <vector> <fmt/format.h>
    <Eigen/Geometry>)

# flowslide_unity(<targets>...): compiles up to 10 sources of a target as one. Names that two sources give to different
# things in the same namespace meet there: rename one, or give a test a namespace named after its file.
function(flowslide_unity)
  if(FLOWSLIDE_UNITY)
    set_target_properties(${ARGN} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 10)
  endif()
endfunction()

# flowslide_library(<folder of core> [DEPENDS <targets>...] [EXCEPT <files>...]): every other .cpp of that folder (not of
# its sub-folders).
function(flowslide_library name)
  cmake_parse_arguments(ARG "" "" "DEPENDS;EXCEPT" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/core/${name}/*.cpp)
  list(TRANSFORM ARG_EXCEPT PREPEND ${PROJECT_SOURCE_DIR}/core/${name}/)
  list(REMOVE_ITEM sources ${ARG_EXCEPT})
  string(REPLACE "/" "_" target flowslide_${name})
  if(sources)
    add_library(${target} STATIC ${sources})
    target_link_libraries(${target} PUBLIC flowslide_options ${ARG_DEPENDS})
  else()
    add_library(${target} INTERFACE)
    target_link_libraries(${target} INTERFACE flowslide_options ${ARG_DEPENDS})
  endif()
  set_property(GLOBAL APPEND PROPERTY flowslide_libraries ${target})
  set_property(GLOBAL APPEND PROPERTY flowslide_folders ${name})
endfunction()
