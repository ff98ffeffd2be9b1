# SPDX-License-Identifier: GPL-2.0-or-later
# Debian's libliggghts-dev ships headers and a shared library, but neither a .pc file nor a CMake configuration.
# Defines the target LIGGGHTS::LIGGGHTS and LIGGGHTS_VERSION.
find_path(LIGGGHTS_INCLUDE_DIR liggghts/library.h)
find_library(LIGGGHTS_LIBRARY NAMES liggghts)
# The headers name the version of LAMMPS that LIGGGHTS began from; its own stands in the package alone.
execute_process(COMMAND dpkg-query -W -f=\${Version} libliggghts-dev OUTPUT_VARIABLE LIGGGHTS_VERSION ERROR_QUIET)
if(NOT LIGGGHTS_VERSION)
  set(LIGGGHTS_VERSION unknown)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LIGGGHTS REQUIRED_VARS LIGGGHTS_LIBRARY LIGGGHTS_INCLUDE_DIR
                                  REASON_FAILURE_MESSAGE "Install Debian's libliggghts-dev (see packages.txt).")
if(LIGGGHTS_FOUND AND NOT TARGET LIGGGHTS::LIGGGHTS)
  add_library(LIGGGHTS::LIGGGHTS UNKNOWN IMPORTED)
  # Its headers include each other by bare name. SYSTEM keeps their warnings out of our build.
  set_target_properties(LIGGGHTS::LIGGGHTS PROPERTIES
    IMPORTED_LOCATION ${LIGGGHTS_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${LIGGGHTS_INCLUDE_DIR}/liggghts
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES ${LIGGGHTS_INCLUDE_DIR}/liggghts)
endif()
mark_as_advanced(LIGGGHTS_INCLUDE_DIR LIGGGHTS_LIBRARY)
