# SPDX-License-Identifier: GPL-2.0-or-later
# cmake --install: the core libraries with their headers and a CMake package (see README, "Use as a library").
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(installed GLOBAL PROPERTY flowslide_libraries)
foreach(library ${installed} flowslide_options)
  string(REGEX REPLACE "^flowslide_" "" name ${library})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${name})
endforeach()
install(TARGETS ${installed} flowslide_options EXPORT flowslideTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY core/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/flowslide FILES_MATCHING PATTERN "*.hpp"
        PATTERN isa EXCLUDE)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/flowslide)
install(EXPORT flowslideTargets NAMESPACE flowslide:: DESTINATION ${package})
configure_package_config_file(cmake/flowslideConfig.cmake.in ${PROJECT_BINARY_DIR}/flowslideConfig.cmake
                              INSTALL_DESTINATION ${package})
# Before 1.0 any minor version may change the headers.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/flowslideConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/flowslideConfig.cmake ${PROJECT_BINARY_DIR}/flowslideConfigVersion.cmake
              cmake/FindLIGGGHTS.cmake DESTINATION ${package})
install(FILES LICENSE README.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
