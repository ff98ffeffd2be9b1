# SPDX-License-Identifier: GPL-2.0-or-later
# Writes the file `tests` for ctest: one test per point of the case, which runs it, then one per claim. `points` and
# `claims` are those to be tested; when they are empty, all that `program --list --json` says, without the points that are
# for a figure alone.

set(options "")
set(name paper.${case})
if(engine)
  set(options --engine ${engine})
  set(name paper.${engine}.${case})
endif()
execute_process(COMMAND ${program} ${options} --list --json OUTPUT_VARIABLE listing RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "${program} --list --json ended with ${code}")
endif()

# listed(<variable> <array> [<member>...]): of each element of an array of the listing, the element or its member.
function(listed variable array)
  set(all "")
  string(JSON count LENGTH "${listing}" ${array})
  math(EXPR last "${count} - 1")
  foreach(i RANGE ${last})
    string(JSON element GET "${listing}" ${array} ${i} ${ARGN})
    list(APPEND all ${element})
  endforeach()
  set(${variable} ${all} PARENT_SCOPE)
endfunction()

if(NOT claims)
  listed(claims claims)
endif()
listed(names points name)
listed(seconds points predicted_seconds)
if(NOT points)
  listed(figure_only points figure_only)
  foreach(name_of_point is_figure_only IN ZIP_LISTS names figure_only)
    if(NOT is_figure_only)
      list(APPEND points ${name_of_point})
    endif()
  endforeach()
endif()

# append_test(<name> <properties> <command>...)
set(text "")
function(append_test test properties)
  list(JOIN ARGN "]==] [==[" words)
  set(text "${text}add_test([==[${test}]==] [==[${words}]==])
set_tests_properties([==[${test}]==] PROPERTIES LABELS ${label} ${properties})
" PARENT_SCOPE)
endfunction()

foreach(point ${points})
  list(FIND names ${point} index)
  list(GET seconds ${index} cost)  # ctest starts the longest first, lest a core wait for the last
  append_test(${name}.run.${point} "ENVIRONMENT [==[${environment}]==] FIXTURES_REQUIRED paper_clean \
FIXTURES_SETUP ${name}_points TIMEOUT 600 COST ${cost}" ${program} ${options} --output ${output} --point ${point})
endforeach()
# Exit code 4 says that a claim is not met: which, its own test tells.
append_test(${name}.evaluate "FIXTURES_REQUIRED ${name}_points FIXTURES_SETUP ${name}_claims"
            ${CMAKE_COMMAND} -D program=${program} -D output=${output} -D engine=${engine}
            -P ${CMAKE_CURRENT_LIST_DIR}/evaluate.cmake)
foreach(id ${claims})
  append_test(${name}.${id} "FIXTURES_REQUIRED ${name}_claims"
              ${CMAKE_COMMAND} -D file=${output}/claims.json -D id=${id} -P ${CMAKE_CURRENT_LIST_DIR}/claim.cmake)
endforeach()
if(label STREQUAL paper-liggghts)
  set(text "if(CTEST_CONFIGURATION_TYPE STREQUAL liggghts)\n${text}endif()\n")
endif()
file(WRITE ${tests} "${text}")
