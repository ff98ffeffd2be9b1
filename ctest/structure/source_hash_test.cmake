# SPDX-License-Identifier: GPL-2.0-or-later
# cmake -P source_hash_test.cmake: tests which changes of the sources change their hash.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../../cmake/SourceHash.cmake)

string(RANDOM LENGTH 12 name)
set(room ${CMAKE_CURRENT_BINARY_DIR}/source_hash_${name})
set(failures 0)

set(law [[
// The law.
#pragma once
#include "grains/constant.hpp"
constexpr int steps = 10'000;  // digit separators are no characters
inline double force(double overlap, const double* a) { return stiffness * overlap - a[1] * 0.5; }
inline const char* link() { return "https://example.org"; }
]])

# write(<law> <constant.hpp> <constant.cpp>): a tree of three sources.
function(write law header source)
  file(WRITE ${room}/dem/law.hpp "${law}")
  file(WRITE ${room}/grains/constant.hpp "${header}")
  file(WRITE ${room}/grains/constant.cpp "${source}")
  file(WRITE ${room}/grains/other.cpp "int other;")
endfunction()

# expect(<same|other> <what>): whether the tree, as it is now, has the hash of the first one.
function(expect wanted what)
  hash_of_sources(now ${room} "${flags}" dem/law.hpp)
  set(found other)
  if(now STREQUAL first)
    set(found same)
  endif()
  if(NOT found STREQUAL wanted)
    message("${what}: the hash is the ${found}, expected the ${wanted}")
    math(EXPR failures "${failures} + 1")
    set(failures ${failures} PARENT_SCOPE)
  endif()
endfunction()

# changed(<variable> <from> <to>): the law with one change, which must be one.
function(changed variable from to)
  string(REPLACE "${from}" "${to}" text "${law}")
  if(text STREQUAL law)
    message(FATAL_ERROR "the law has no '${from}'")
  endif()
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

set(header "extern const double stiffness;")
set(source "#include \"grains/constant.hpp\"\nconst double stiffness = 2.0;")
set(flags "")
write("${law}" "${header}" "${source}")
hash_of_sources(first ${room} "" dem/law.hpp)
if(NOT first MATCHES "^[0-9a-f]+$")
  message(FATAL_ERROR "no hash: ${first}")
endif()

changed(text "// The law." "/* Another; word [ on \\ it. */")
write("${text}" "${header}" "${source}")
expect(same "another comment")
changed(text " - a[1] * 0.5" "\n    -   a[1]*0.5 /* half */ ")
write("${text}" "${header}" "${source}")
expect(same "other line breaks and blanks")
changed(text "0.5" "0.25")
write("${text}" "${header}" "${source}")
expect(other "another constant")
changed(text "10'000" "20'000")
write("${text}" "${header}" "${source}")
expect(other "another number with digit separators")
changed(text "example.org" "example.com")
write("${text}" "${header}" "${source}")
expect(other "a text that holds two slashes")
changed(text "a[1]" "a[2]")
write("${text}" "${header}" "${source}")
expect(other "another index")
changed(text "int steps" "intsteps")
write("${text}" "${header}" "${source}")
expect(other "two words joined")
write("${law}" "${header} extern int more;" "${source}")
expect(other "another header that is included")
write("${law}" "${header}" "#include \"grains/constant.hpp\"\nconst double stiffness = 2.1;")
expect(other "another source beside a header that is included")
write("${law}" "${header}" "${source}")
file(WRITE ${room}/grains/other.cpp "int another;")
expect(same "another file that is not included")
set(flags "-ffast-math")
expect(other "another option of the compiler")
set(flags "")

set(source_hash_except "^grains/")
hash_of_sources(first ${room} "" dem/law.hpp)
write("${law}" "${header}" "#include \"grains/constant.hpp\"\nconst double stiffness = 2.2;")
expect(same "another source that is left out")
changed(text "0.5" "0.25")
write("${text}" "${header}" "${source}")
expect(other "another constant, with some sources left out")

file(REMOVE_RECURSE ${room})
if(failures)
  message(FATAL_ERROR "${failures} failures")
endif()
