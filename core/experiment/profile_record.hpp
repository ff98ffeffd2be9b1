// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "grains/choice.hpp"
#include "record/series.hpp"
#include "sample/dem_sample.hpp"

namespace flowslide {

/// What claims and figures read of several snapshots: their mean, or the first of them, as the paper does.
enum class ProfileReading { mean, first_snapshot };

template <>
struct ChoiceNames<ProfileReading> {
  static constexpr const char* what = "reading of a profile";
  static constexpr std::array names{"mean", "first snapshot"};
};

/// When profiles over the height of a sample are taken (Fig. 10). A profile is a mean over several snapshots, because a
/// sublayer has few grains and one snapshot is noisy.
struct ProfilePlan {
  int sublayers = 10;            ///< number of sublayers over the height
  int snapshots = 1;             ///< snapshots per profile, >= 1
  double window = 0.0;           ///< the snapshots are spread over the strain `window` times the first strain
  std::vector<double> strains;   ///< shear strain of the first snapshot of each profile, increasing; empty: no profile
  ProfileReading read = ProfileReading::mean;

  /// Shear strain of snapshot `number` (from 0) of a profile, and of its last snapshot.
  double strain_of(std::size_t profile, int number) const {
    return strains[profile] * (1.0 + window * number / snapshots);
  }
  double last_strain(std::size_t profile) const { return strain_of(profile, snapshots - 1); }
};

/// One snapshot of the sublayers and of the sample, or a sum of snapshots. Vectors of shape (sublayers), from the
/// bottom up.
struct ProfileValues {
  std::vector<double> velocity, shear, normal;  ///< m/s, Pa, Pa
  double top_velocity = 0.0, sample_shear = 0.0, sample_normal = 0.0;

  bool operator==(const ProfileValues&) const = default;
};

/// The snapshots of one profile so far.
struct ProfileSums {
  ProfileValues first, sum;  ///< the first snapshot, and the sum of all
  int snapshots = 0;
};

/// Profiles of one slide over the relative height z/H, from 0 at the bottom to 1 at the top. The columns of `series`
/// for the i-th strain (from 1) are ratios of sums over the snapshots that are read:
///   velocity_<i>       <v_x> of the sublayer / velocity of the top layer
///   shear_stress_<i>   <tau> of the sublayer / tau of the sample
///   normal_stress_<i>  <sigma> of the sublayer / sigma of the sample
/// If a profile has several snapshots, the same columns of what is not read follow, with the prefix "snapshot_" (the
/// first snapshot) or "mean_" (the mean of all).
class ProfileRecord {
 public:
  explicit ProfileRecord(ProfilePlan plan);

  /// Takes a snapshot if one is due at this shear strain of the layer; otherwise returns at once. The velocity of the
  /// top layer is the mean of its grains. In a cell that is periodic along z it is the velocity of the upper face.
  /// Throws NumericalFailure if a sublayer contains no solid.
  void take(double strain, const DemSample& sample);
  /// The profiles so far: with ProfileReading::mean the complete ones, otherwise those with a first snapshot; the mean
  /// stands beside it once it is complete. What is read of a sample that does not move or bears no stress has no
  /// ratios. This profile and all later ones are left out; the columns of what is not read are left out where they have
  /// no ratios.
  Series series() const;

  /// The state for a checkpoint. `restore` continues from it and throws std::invalid_argument if it does not fit this
  /// plan.
  const std::vector<ProfileSums>& sums() const { return sums_; }
  void restore(std::vector<ProfileSums> sums);

 private:
  double next_strain() const;

  ProfilePlan plan_;
  std::vector<ProfileSums> sums_;
  double next_strain_;
};

/// Coefficient of determination R^2 of the least-squares line through a column over the axis.
double linearity(const Series& profiles, const std::string& column);

}  // namespace flowslide
