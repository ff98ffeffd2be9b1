# SPDX-License-Identifier: GPL-2.0-or-later
# Finds the serial HDF5 library with its high-level part. Defines the target SerialHDF5::hdf5.
# The module FindHDF5 of CMake needs the language C, and beside parallel HDF5 it may find that one, whose header needs
# MPI. This module looks into hdf5/serial first, where Debian installs the serial library beside the parallel one.
find_path(SerialHDF5_INCLUDE_DIR hdf5_hl.h PATH_SUFFIXES hdf5/serial)
find_library(SerialHDF5_LIBRARY NAMES hdf5 hdf5_serial PATH_SUFFIXES hdf5/serial)
find_library(SerialHDF5_HL_LIBRARY NAMES hdf5_hl hdf5_serial_hl PATH_SUFFIXES hdf5/serial)
set(SerialHDF5_IS_SERIAL TRUE)
if(SerialHDF5_INCLUDE_DIR)
  file(STRINGS ${SerialHDF5_INCLUDE_DIR}/H5pubconf.h lines REGEX "define H5_(VERSION|HAVE_PARALLEL) ")
  if(lines MATCHES "H5_VERSION \"([0-9.]+)")
    set(SerialHDF5_VERSION ${CMAKE_MATCH_1})
  endif()
  if(lines MATCHES "H5_HAVE_PARALLEL 1")
    set(SerialHDF5_IS_SERIAL FALSE)
  endif()
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SerialHDF5
  REQUIRED_VARS SerialHDF5_LIBRARY SerialHDF5_HL_LIBRARY SerialHDF5_INCLUDE_DIR SerialHDF5_IS_SERIAL
  VERSION_VAR SerialHDF5_VERSION
  REASON_FAILURE_MESSAGE "Install Debian's libhdf5-dev (see packages.txt), or set CMAKE_PREFIX_PATH to a serial HDF5.")
if(SerialHDF5_FOUND AND NOT TARGET SerialHDF5::hdf5)
  add_library(SerialHDF5::hdf5 INTERFACE IMPORTED)
  target_link_libraries(SerialHDF5::hdf5 INTERFACE ${SerialHDF5_HL_LIBRARY} ${SerialHDF5_LIBRARY})
  target_include_directories(SerialHDF5::hdf5 SYSTEM INTERFACE ${SerialHDF5_INCLUDE_DIR})
endif()
mark_as_advanced(SerialHDF5_INCLUDE_DIR SerialHDF5_LIBRARY SerialHDF5_HL_LIBRARY)
