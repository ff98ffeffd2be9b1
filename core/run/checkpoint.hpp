// SPDX-License-Identifier: GPL-2.0-or-later
// The state of a run between two exchanges. A run that restores this state continues bit for bit.
#pragma once
#include <optional>
#include <vector>

#include "experiment/profile_record.hpp"
#include "experiment/slide_run.hpp"
#include "record/hdf5.hpp"
#include "record/result_file.hpp"

namespace flowslide {

/// State of a slide, except its sample and its rows.
struct SlideCheckpoint {
  SlideState state;
  RowSpacing spacing;                  ///< present spacing of the rows
  double next_time = 0.0;              ///< s, see SlideRecord
  double next_strain = 0.0;            ///< see SlideRecord
  std::vector<ProfileSums> profiles;   ///< complete and incomplete
  Series complete_profiles = {};       ///< as at the end of the run, for preliminary plots; may have no columns
  ExchangeRecord exchanges{};          ///< sums from which metrics are computed
};

/// Grains at one time, for a picture.
struct Shot {
  double time = 0.0;    ///< s
  double strain = 0.0;  ///< gamma
  Assembly assembly;
};

/// State of a run. It contains no random generator: after the preparation a run uses no random numbers.
struct Checkpoint {
  Result partial_result;                 ///< incomplete result: the rows up to now and what determines them
  double share_done = 0.0;               ///< estimated fraction of the run that is done, 0 to 1
  SampleState sample;
  std::optional<SlideCheckpoint> slide;  ///< empty for an element test, whose state is that of its last row
  std::vector<Shot> shots;
  Series measured = {};  ///< of an element test, see ShearTestRecord; otherwise without columns
};

/// Writes a checkpoint below `root`. The incomplete result is written as by write_result, so that readers of results
/// can read it. The group /checkpoint holds the rest: sample/numbers, sample/grains (see write_assembly), slide with
/// profiles and exchanges, shots, measured. Throws std::invalid_argument as write_result.
void write_checkpoint(hdf5::Group& root, const Checkpoint& checkpoint);

/// Reads a checkpoint back, bit for bit. Throws CorruptFileError if it is incomplete, or if a number or grain is not
/// finite.
Checkpoint read_checkpoint(const hdf5::Group& root);

}  // namespace flowslide
