// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "run/output_folder.hpp"
#include "run/run_identity.hpp"

namespace flowslide {

/// A run of a case ("point") that is locked for this process.
struct BegunPoint {
  FileLock lock;  ///< to be held until the run ends
  bool complete;  ///< the result of this run exists: nothing is left to do
};

/// Locks the run `point` of a case and records its identity. Throws Refused if another process holds the lock, or if a
/// result or a checkpoint has another identity. Throws CorruptFileError if the result is damaged. With `afresh`,
/// checkpoints and such results are removed instead; a complete result of this identity is kept.
BegunPoint begin_point(const OutputFolder& output, const std::string& point, const RunIdentity& identity, bool afresh);

}  // namespace flowslide
