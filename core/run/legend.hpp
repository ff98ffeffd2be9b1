// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "run/output_folder.hpp"

namespace flowslide {

/// Labels of the curves of a figure, for plots/style.gp: the table legend.dat with a line "point<TAB>label" per curve.
class Legend {
 public:
  /// `label` may contain gnuplot's markup.
  void add(const std::string& point, const std::string& label) { text_ += point + "\t" + label + "\n"; }

  /// Writes legend.dat. Without labels it has only its header, and each curve has the name of its run.
  void write(const OutputFolder& output) const;

 private:
  std::string text_ = "# point\tlabel\n";
};

}  // namespace flowslide
