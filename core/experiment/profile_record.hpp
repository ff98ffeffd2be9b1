// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "record/series.hpp"
#include "sample/dem_sample.hpp"

namespace flowslide {

/// When profiles over the height of a sample are taken (Fig. 10).
struct ProfilePlan {
  int sublayers = 10;
  int snapshots = 1;             ///< whose mean a profile is: the few grains of a sublayer are noise
  double window = 0.0;           ///< that the snapshots are spread over, as a share of the strain where it begins
  std::vector<double> strains;   ///< shear strains of the layer at which the windows begin, growing; may be none
};

/// One profile as far as its snapshots have been taken: sums over them, values per sublayer.
struct ProfileSums {
  std::vector<double> velocity, shear, normal;  ///< m/s, Pa, Pa
  double top_velocity = 0.0, sample_shear = 0.0, sample_normal = 0.0;
  int snapshots = 0;
};

/// Profiles of one slide: column <what>_<i> of `series` belongs to the i-th strain, from 1, over the relative height
/// z/H from 0 at the bottom to 1 at the top. Each is the sum of its snapshots over the sum of what it is a share of:
///   velocity_<i>       <v_x> over the velocity of the top layer
///   shear_stress_<i>   <tau> over tau of the sample
///   normal_stress_<i>  <sigma> over sigma of the sample
class ProfileRecord {
 public:
  explicit ProfileRecord(ProfilePlan plan);

  /// Takes a snapshot of the sample if one is due at this strain of the layer, and is cheap if not. The velocity of the
  /// top layer is that of its grains, or of the upper face in a cell that is periodic along z. Throws NumericalFailure
  /// if a sublayer holds no solid.
  void take(double strain, const DemSample& sample);
  /// Those profiles that have all their snapshots, up to the first of a sample that stands still or bears no stress.
  Series series() const;

  /// What has been taken, to be kept, and going on from there. Throws std::invalid_argument for sums that are not of
  /// this plan.
  const std::vector<ProfileSums>& sums() const { return sums_; }
  void restore(std::vector<ProfileSums> sums);

 private:
  double next_strain() const;

  ProfilePlan plan_;
  std::vector<ProfileSums> sums_;
  double next_strain_;
};

/// R^2, the coefficient of determination, of the straight line that fits a column best over the axis.
double linearity(const Series& profiles, const std::string& column);

}  // namespace flowslide
