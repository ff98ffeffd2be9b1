// SPDX-License-Identifier: GPL-2.0-or-later
// Where a point stands between two exchanges: all that it goes on from, bit for bit.
#pragma once
#include <optional>
#include <vector>

#include "experiment/profile_record.hpp"
#include "experiment/slide_run.hpp"
#include "record/hdf5.hpp"
#include "record/result_file.hpp"

namespace flowslide {

/// What a slide has besides its sample and its rows.
struct SlideCheckpoint {
  SlideState state;
  RowSpacing spacing;                  ///< of the rows, as it is now
  double next_time = 0.0;              ///< see SlideRecord
  double next_strain = 0.0;
  std::vector<ProfileSums> profiles;   ///< begun and complete
  Series complete_profiles = {};       ///< as at the end of a run, for who looks on; without columns if there are none
  ExchangeRecord exchanges{};          ///< what metrics are made of, so far
};

/// Grains at a moment, for a picture.
struct Shot {
  double time = 0.0;    ///< s
  double strain = 0.0;  ///< gamma
  Assembly assembly;
};

/// There are no random streams to keep: after its preparation nothing in a run is drawn.
struct Checkpoint {
  Result so_far;                         ///< rows, and what determines them: a result that is not complete
  double share_done = 0.0;               ///< about, 0 to 1
  SampleState sample;
  std::optional<SlideCheckpoint> slide;  ///< of a slide; an element test stands at the last of its rows
  std::vector<Shot> shots;
  Series measured = {};  ///< of an element test, see ShearTestRecord; else without columns
};

/// Writes it below `root`: as write_result does, so that what reads results reads the rows so far as well, and
/// /checkpoint with the rest: sample/numbers, sample/grains (see write_assembly), slide, profiles, exchanges, shots,
/// measured.
/// Throws std::invalid_argument as write_result.
void write_checkpoint(hdf5::Group& root, const Checkpoint& checkpoint);

/// Reads it back, bit for bit. Throws CorruptFileError if it is not, whole and with finite grains, what was written.
Checkpoint read_checkpoint(const hdf5::Group& root);

}  // namespace flowslide
