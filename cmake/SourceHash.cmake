# SPDX-License-Identifier: GPL-2.0-or-later
# A hash of the sources that decide a result, made when the build is configured. It changes with every change of the
# code, and not with comments, line breaks or indentation.

# source_code_of(<variable> <file>): the words, strings and signs of a file, without comments, joined by blanks.
function(source_code_of variable file)
  file(READ ${file} text)
  # A list of CMake splits at semicolons, but not within brackets or behind a backslash: these stand as other characters.
  string(ASCII 1 semicolon)
  string(ASCII 2 escape)
  string(REPLACE ";" "${semicolon}" text "${text}")
  string(REPLACE "\\" "${escape}" text "${text}")
  string(REPLACE "[" "<:" text "${text}")
  string(REPLACE "]" ":>" text "${text}")
  set(comment "//[^\n]*|/\\*[^*]*\\*+([^/*][^*]*\\*+)*/")
  set(string "\"[^\"${escape}]*(${escape}.[^\"${escape}]*)*\"")
  set(character "'[^'${escape}]*(${escape}.[^'${escape}]*)*'")
  set(word "[A-Za-z0-9_][A-Za-z0-9_']*")  # digit separators too
  string(REGEX MATCHALL "${comment}|${string}|${character}|${word}|[^ \t\r\n]" tokens "${text}")
  list(FILTER tokens EXCLUDE REGEX "^/[/*]")
  list(JOIN tokens " " code)
  set(${variable} "${code}" PARENT_SCOPE)
endfunction()

# sources_with_includes(<variable> <root> <files>...): these files below <root>, the files below it that they include,
# the .cpp files beside these headers, and so on. Sorted; names of files that are not there are left out, and files that
# match the regular expression in source_hash_except, if it is set.
function(sources_with_includes variable root)
  set(pending ${ARGN})
  set(found "")
  while(pending)
    list(POP_FRONT pending file)
    if(file IN_LIST found OR NOT EXISTS ${root}/${file})
      continue()
    endif()
    if(source_hash_except AND file MATCHES "${source_hash_except}")
      continue()
    endif()
    list(APPEND found ${file})
    string(REGEX REPLACE "\\.hpp$" ".cpp" partner ${file})
    list(APPEND pending ${partner})
    file(STRINGS ${root}/${file} lines REGEX "^[ \t]*#[ \t]*include[ \t]*\"")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^[^\"]*\"([^\"]*)\".*" "\\1" included "${line}")
      list(APPEND pending ${included})
    endforeach()
  endwhile()
  list(SORT found)
  set(${variable} ${found} PARENT_SCOPE)
endfunction()

# hash_of_sources(<variable> <root> <flags> <files>...): 16 hexadecimal digits of the code of these files, of all that
# they include, and of <flags>, the options of the compiler that may change a result.
function(hash_of_sources variable root flags)
  sources_with_includes(files ${root} ${ARGN})
  set(all "${flags}")
  foreach(file IN LISTS files)
    source_code_of(code ${root}/${file})
    string(APPEND all "\n${code}")
  endforeach()
  string(SHA256 hash "${all}")
  string(SUBSTRING ${hash} 0 16 hash)
  set(${variable} ${hash} PARENT_SCOPE)
endfunction()

# flowslide_source_hash(<variable> <files or patterns below core>... [EXCEPT <regular expression>] [FLAGS <options>...]):
# the same for this project, without the files that match the expression, and with options of the compiler for these
# files alone. An edit of one of the files, or a new one that a pattern matches,
# configures the build anew.
function(flowslide_source_hash variable)
  cmake_parse_arguments(ARG "" "EXCEPT" "FLAGS" ${ARGN})
  set(source_hash_except "${ARG_EXCEPT}")
  set(root ${PROJECT_SOURCE_DIR}/core)
  list(TRANSFORM ARG_UNPARSED_ARGUMENTS PREPEND ${root}/ OUTPUT_VARIABLE patterns)
  file(GLOB roots CONFIGURE_DEPENDS RELATIVE ${root} ${patterns})
  sources_with_includes(files ${root} ${roots})
  list(TRANSFORM files PREPEND ${root}/ OUTPUT_VARIABLE paths)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${paths})
  get_target_property(options flowslide_options INTERFACE_COMPILE_OPTIONS)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  string(REGEX MATCHALL "-Ofast|-m?f[a-z-]*(math|fp|fma|round)[a-z=-]*" flags
         "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} ${options} ${ARG_FLAGS}")
  hash_of_sources(hash ${root} "${flags}" ${files})
  set(${variable} ${hash} PARENT_SCOPE)
endfunction()
