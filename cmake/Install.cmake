# SPDX-License-Identifier: GPL-2.0-or-later
# cmake --install: the core libraries with their headers and a CMake package (see docs/library.md).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(folders GLOBAL PROPERTY flowslide_folders)
get_property(installed GLOBAL PROPERTY flowslide_libraries)
foreach(library ${installed} flowslide_options)
  string(REGEX REPLACE "^flowslide_" "" name ${library})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${name})
  list(APPEND FLOWSLIDE_COMPONENTS ${name})
endforeach()
list(REMOVE_ITEM FLOWSLIDE_COMPONENTS options)
install(TARGETS ${installed} flowslide_options EXPORT flowslideTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})

# The rules act in their order: the first makes the headers that the second installs.
set(headers ${PROJECT_BINARY_DIR}/installed_headers)
install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\" -D \"source=${PROJECT_SOURCE_DIR}/core\"
  -D \"output=${headers}\" -D \"folders=${folders}\" -P \"${PROJECT_SOURCE_DIR}/cmake/InstallHeaders.cmake\"
  COMMAND_ERROR_IS_FATAL ANY)")
install(DIRECTORY ${headers}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/flowslide)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/flowslide)
install(EXPORT flowslideTargets NAMESPACE flowslide:: DESTINATION ${package})
configure_package_config_file(cmake/flowslideConfig.cmake.in ${PROJECT_BINARY_DIR}/flowslideConfig.cmake
                              INSTALL_DESTINATION ${package})
# Before 1.0 any minor version may change the headers.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/flowslideConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/flowslideConfig.cmake ${PROJECT_BINARY_DIR}/flowslideConfigVersion.cmake
              cmake/FindLIGGGHTS.cmake cmake/FindSerialHDF5.cmake DESTINATION ${package})
install(FILES LICENSE README.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES docs/library.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)  # README.md names it
