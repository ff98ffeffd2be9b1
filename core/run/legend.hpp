// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "run/output_folder.hpp"

namespace flowslide {

/// Labels of the curves of a figure, for plots/style.gp: the file legend.txt, a line "point<TAB>label" for each. It is no
/// table (see table_head): a label may hold blanks.
class Legend {
 public:
  /// `label` may hold gnuplot's mark-up.
  void add(const std::string& point, const std::string& label) { text_ += point + "\t" + label + "\n"; }

  /// Without labels the file has its head alone: each curve has the name of its point.
  void write(const OutputFolder& output) const;

 private:
  std::string text_ = "# point\tlabel\n";
};

}  // namespace flowslide
