// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "run/output_folder.hpp"
#include "run/run_identity.hpp"

namespace flowslide {

/// A point that this process alone may work on.
struct BegunPoint {
  FileLock lock;  ///< to be held until the point is over
  bool complete;  ///< its result is there, of this run: nothing is left to do
};

/// Takes the lock of a point and notes the identity that it is begun with. Throws Refused if another process
/// holds the lock, or if there is a result or a checkpoint of another run, and CorruptFileError if the result is
/// damaged. With `afresh`, checkpoints and such a result are removed instead; a complete result of this run is kept.
BegunPoint begin_point(const OutputFolder& output, const std::string& point, const RunIdentity& identity, bool afresh);

}  // namespace flowslide
