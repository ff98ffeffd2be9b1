// SPDX-License-Identifier: GPL-2.0-or-later
#include "run/legend.hpp"

#include "record/atomic_file.hpp"

namespace flowslide {

void Legend::write(const OutputFolder& output) const { write_atomically(output.file("legend.txt"), text_); }

}  // namespace flowslide
