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

/// One finished run.
struct Result {
  Provenance provenance;
  std::string configuration;        ///< resolved, as text
  std::string configuration_hash;   ///< of that text, see hash.hpp
  Series series;
  std::vector<Metric> metrics;
  std::string identity = {};            ///< what else decides the result: lines "name = value", see RunIdentity
  std::vector<InputTable> inputs = {};  ///< tables that the run has read from files
  /// What the run was given, such as a hydraulic conductivity: it is read from here, never from a name.
  std::vector<Metric> parameters = {};
  /// Means over fixed windows, one series for each abscissa (time, shear_strain, displacement): see WindowRecord.
  std::vector<Series> windows = {};
};

/// Writes one HDF5 file, whole or not at all, for h5py and xarray (group "series") to read unaided:
///   /                    attributes: those of Provenance, `configuration_hash`
///   /configuration       text, with attribute `hash`
///   /series/<column>     double, shape (rows); attributes units, long_name, symbol, sign_convention; the axis is a
///                        dimension scale attached to each
///   /metrics/<metric>    double, scalar; attributes units, long_name
///   /identity            text: case, point, engine and contents of input files, with which the result is recognized
///   /inputs/<name>/      the rows of an input file, as in /series; attribute `file`
///   /parameters/<name>   likewise
///   /windows/<abscissa>/<column>   as /series, of means over windows; the axis holds their upper ends
/// and behind the HDF5 content its checksum (see sealed_file.hpp), which HDF5 ignores.
/// Throws std::invalid_argument for a series or metric that must not be written, and FileError as write_atomically.
void write_result(const std::filesystem::path& path, const Result& result, IfExists if_exists = IfExists::refuse);

/// Throws FileError if the file is missing, CorruptFileError if it is not, whole and unaltered, what write_result made.
Result read_result(const std::filesystem::path& path);

/// The same as parts of a file that holds more, below its root.
void write_result(hdf5::Group& root, const Result& result);
Result read_result(const hdf5::Group& root);

}  // namespace flowslide
