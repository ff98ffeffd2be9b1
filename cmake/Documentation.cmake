# SPDX-License-Identifier: GPL-2.0-or-later
# The reference of the library: cmake --build build/release --target docs writes build/release/docs/html/index.html.
configure_file(${PROJECT_SOURCE_DIR}/docs/Doxyfile.in ${PROJECT_BINARY_DIR}/docs/Doxyfile @ONLY)
find_program(FLOWSLIDE_DOXYGEN doxygen)
mark_as_advanced(FLOWSLIDE_DOXYGEN)
if(FLOWSLIDE_DOXYGEN)
  add_custom_target(docs COMMAND ${FLOWSLIDE_DOXYGEN} ${PROJECT_BINARY_DIR}/docs/Doxyfile VERBATIM)
else()
  add_custom_target(docs COMMAND ${CMAKE_COMMAND} -E echo "doxygen is missing (packages-full.txt)"
                         COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
endif()
