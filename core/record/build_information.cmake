# SPDX-License-Identifier: GPL-2.0-or-later
# This file has two uses. core/CMakeLists.txt includes it after flowslide_library(record): it then adds a target that
# runs on each build. The target runs it as a script (cmake -P): it then writes record/build_values.hpp if its content
# changed.
if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(build_values_folder ${PROJECT_BINARY_DIR}/generated)
  get_target_property(options flowslide_options INTERFACE_COMPILE_OPTIONS)
  list(JOIN options " " options)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} ${options}" flags)
  add_custom_target(flowslide_build_values
    COMMAND ${CMAKE_COMMAND} -D "source=${PROJECT_SOURCE_DIR}"
            -D "output=${build_values_folder}/record/build_values.hpp"
            -D "code_version=${PROJECT_VERSION}" -D "compiler=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
            -D "compiler_flags=${flags}" -D "build_type=${CMAKE_BUILD_TYPE}" -P ${CMAKE_CURRENT_LIST_FILE}
    BYPRODUCTS ${build_values_folder}/record/build_values.hpp
    COMMENT "" VERBATIM)
  add_dependencies(flowslide_record flowslide_build_values)
  target_include_directories(flowslide_record PRIVATE ${build_values_folder})
  return()
endif()

# ask_git(<output> <failure> <arguments>...): the output of git in the source. On an error, <failure> holds the first
# line of git's message. The checkout may belong to another user, for example in a container. Git then refuses to read
# it, because settings of a repository can start programs. A build runs the CMake files of the source anyway, so this
# check protects nothing here and is switched off.
function(ask_git output failure)
  execute_process(COMMAND ${git} -c safe.directory=* -C ${source} --no-optional-locks ${ARGN} OUTPUT_VARIABLE answer
                  ERROR_VARIABLE complaint RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(${output} "${answer}" PARENT_SCOPE)
  set(${failure} "" PARENT_SCOPE)
  if(failed)
    string(REGEX MATCH "[^\n]*" complaint "${complaint}")
    set(${failure} "git says: ${complaint}" PARENT_SCOPE)
  endif()
endfunction()

set(git_revision unknown)
set(why "")
find_program(git git)
# The folder above a source archive may be another repository. Only a .git in the root of the source counts.
if(NOT EXISTS ${source}/.git)
  set(git_state "unknown: the source is no git checkout")
else()
  if(git)
    ask_git(revision why rev-parse HEAD)
  else()
    set(why "git is not installed")
  endif()
  if(why STREQUAL "")
    set(git_revision ${revision})
    ask_git(changes why status --porcelain)
  endif()
  if(NOT why STREQUAL "")
    set(git_state "unknown: ${why}")
    message(WARNING "results of this build cannot tell the revision of their source: ${why}")
  elseif(changes STREQUAL "")
    set(git_state clean)
  else()
    set(git_state dirty)
  endif()
endif()

# The paper is the first reference, and each reference begins with "- type:". Only a DOI within the first one counts.
set(paper_doi unknown)
if(EXISTS ${source}/CITATION.cff)
  file(READ ${source}/CITATION.cff citation)
  string(REGEX MATCH "\nreferences:.*" references "${citation}")
  string(FIND "${references}" "- type:" first)
  if(first GREATER_EQUAL 0)
    math(EXPR first "${first} + 7")
    string(SUBSTRING "${references}" ${first} -1 references)
  endif()
  string(FIND "${references}" "- type:" next)
  string(SUBSTRING "${references}" 0 ${next} paper)
  if(paper MATCHES "\n +doi: *[\"']?([^\"' \n]+)")
    set(paper_doi ${CMAKE_MATCH_1})
  endif()
endif()

set(text "// Made by core/record/build_information.cmake on each build.\n#pragma once\n")
string(APPEND text "namespace flowslide::build_information {\n")
foreach(name code_version git_revision git_state compiler compiler_flags build_type paper_doi)
  string(REPLACE "\\" "\\\\" value "${${name}}")
  string(REPLACE "\"" "\\\"" value "${value}")
  string(APPEND text "inline constexpr const char* ${name} = \"${value}\";\n")
endforeach()
string(APPEND text "}\n")
set(old "")
if(EXISTS ${output})
  file(READ ${output} old)
endif()
if(NOT text STREQUAL old)
  file(WRITE ${output} "${text}")
endif()
