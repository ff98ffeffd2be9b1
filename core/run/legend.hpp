// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "run/output_folder.hpp"

namespace flowslide {

/// Labels of the curves of a figure, for plots/style.gp: the file legend.txt with a line "point<TAB>label" per curve.
/// It is no table (see table_head), because a label may contain blanks.
class Legend {
 public:
  /// `label` may contain gnuplot's markup.
  void add(const std::string& point, const std::string& label) { text_ += point + "\t" + label + "\n"; }

  /// Writes legend.txt. Without labels it has only its head, and each curve has the name of its run.
  void write(const OutputFolder& output) const;

 private:
  std::string text_ = "# point\tlabel\n";
};

}  // namespace flowslide
