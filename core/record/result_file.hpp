// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "record/atomic_file.hpp"
#include "record/hdf5.hpp"
#include "record/input_table.hpp"
#include "record/provenance.hpp"
#include "record/series.hpp"

namespace flowslide {

/// The result of one run.
struct Result {
  Provenance provenance;
  std::string configuration;        ///< resolved configuration, as text
  std::string configuration_hash;   ///< hash of this text, see hash.hpp
  Series series;
  std::vector<Metric> metrics;
  std::string identity = {};            ///< all else that decides the result: lines "name = value", see RunIdentity
  std::vector<InputTable> inputs = {};  ///< tables that the run has read from files
  /// Parameters of the run, such as a hydraulic conductivity. Readers take them from here, never from a name.
  std::vector<Metric> parameters = {};
  /// Means over fixed windows, one series for each abscissa (time, shear_strain, displacement); see WindowRecord.
  std::vector<Series> windows = {};
};

/// Writes one HDF5 file, whole or not at all. h5py and xarray (group "series") read it without help:
///   /                    attributes: those of Provenance, `configuration_hash`
///   /configuration       text, with attribute `hash`
///   /series/<column>     double, shape (rows); attributes units, long_name, symbol, sign_convention; the axis is a
///                        dimension scale attached to each
///   /metrics/<metric>    double, scalar; attributes units, long_name
///   /identity            text: case, point, engine and contents of input files, which identify the run
///   /inputs/<name>/      the rows of an input file, as in /series; attribute `file`
///   /parameters/<name>   double, scalar; attributes units, long_name
///   /windows/<abscissa>/<column>   as /series, but means over windows; the axis holds the upper ends of the windows
/// A checksum follows the HDF5 content (see sealed_file.hpp); HDF5 ignores it.
/// Throws std::invalid_argument as Series::check and check_metrics, and FileError as write_atomically.
void write_result(const std::filesystem::path& path, const Result& result, IfExists if_exists = IfExists::refuse);

/// Throws FileError if the file is missing, and CorruptFileError if it is not a complete, unaltered file of
/// write_result.
Result read_result(const std::filesystem::path& path);

/// The same below the root of a file that may hold more.
void write_result(hdf5::Group& root, const Result& result);
Result read_result(const hdf5::Group& root);

}  // namespace flowslide
