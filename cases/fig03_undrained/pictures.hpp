// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <optional>
#include <vector>

#include "run/checkpoint.hpp"
#include "run/output_folder.hpp"

namespace flowslide {

/// What Fig. 2 shows: the sample before shear and at a strain, for gnuplot, and a series for ParaView in between.
class Pictures {
 public:
  /// Without a strain nothing is kept and nothing written.
  explicit Pictures(std::optional<double> strain) : strain_(strain) {}

  /// Keeps the assembly if a picture is due at this strain.
  void take(double time, double strain, const Assembly& assembly);
  /// Writes fig02_before.dat and fig02_during.dat, the tables of the sample (see write_sample_tables), and <name>.pvd
  /// with its .vtp files.
  void write(const OutputFolder& output, const std::string& name) const;

  /// What has been kept, for a checkpoint, and going on from there.
  const std::vector<Shot>& shots() const { return shots_; }
  void restore(const std::vector<Shot>& shots) { shots_ = shots; }

 private:
  std::optional<double> strain_;
  std::vector<Shot> shots_;
};

}  // namespace flowslide
