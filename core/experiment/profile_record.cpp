// SPDX-License-Identifier: GPL-2.0-or-later
#include "experiment/profile_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "grains/profiles.hpp"
#include "sample/failure.hpp"

namespace flowslide {
namespace {

/// Mean v_x of the layer glued to the top plane, m/s. In a cell that is periodic along z: the velocity of the upper
/// face relative to the bottom.
double top_velocity(const Assembly& assembly) {
  if (assembly.cell.periodic[2]) return assembly.cell.shear_velocity;
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    if (assembly.role[i] != Role::top_layer) continue;
    sum += assembly.velocity[i].x();
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

void add(std::vector<double>& sums, const std::vector<double>& values) {
  sums.resize(values.size(), 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) sums[i] += values[i];
}

void add(ProfileValues& sum, const ProfileValues& snapshot) {
  add(sum.velocity, snapshot.velocity);
  add(sum.shear, snapshot.shear);
  add(sum.normal, snapshot.normal);
  sum.top_velocity += snapshot.top_velocity;
  sum.sample_shear += snapshot.sample_shear;
  sum.sample_normal += snapshot.sample_normal;
}

std::vector<double> over(std::vector<double> values, double divisor) {
  for (double& value : values) value /= divisor;
  return values;
}

bool has_sublayers(const ProfileValues& values, int sublayers) {
  const auto count = static_cast<std::size_t>(sublayers);
  return values.velocity.size() == count && values.shear.size() == count && values.normal.size() == count;
}

/// Whether the sample moves and bears stress, so that the ratios of a profile exist.
bool has_ratios(const ProfileValues& values) {
  return values.top_velocity != 0.0 && values.sample_shear != 0.0 && values.sample_normal != 0.0;
}

/// Appends the three columns of a profile. `prefix` and `number` are those of their names.
void add_columns(Series& series, const char* prefix, std::size_t number, const std::string& at,
                 const ProfileValues& values) {
  const auto name = [&](const char* what) { return fmt::format("{}{}_{}", prefix, what, number); };
  series.columns.push_back({name("velocity"), "<v_x>/v_top", "1", "velocity over that of the top layer" + at,
                            "positive downslope", over(values.velocity, values.top_velocity)});
  series.columns.push_back({name("shear_stress"), "<tau>/tau", "1", "shear stress over that of the sample" + at, "",
                            over(values.shear, values.sample_shear)});
  series.columns.push_back({name("normal_stress"), "<sigma>/sigma", "1", "normal stress over that of the sample" + at,
                            "", over(values.normal, values.sample_normal)});
}

}  // namespace

ProfileRecord::ProfileRecord(ProfilePlan plan) : plan_(std::move(plan)), next_strain_(next_strain()) {}

double ProfileRecord::next_strain() const {
  const bool open = !sums_.empty() && sums_.back().snapshots < plan_.snapshots;
  const std::size_t index = open ? sums_.size() - 1 : sums_.size();
  if (index >= plan_.strains.size()) return std::numeric_limits<double>::infinity();
  const int taken = open ? sums_.back().snapshots : 0;
  return plan_.strain_of(index, taken);
}

void ProfileRecord::take(double strain, const DemSample& sample) {
  if (strain < next_strain_) return;
  if (sums_.empty() || sums_.back().snapshots == plan_.snapshots) sums_.emplace_back();
  ProfileSums& sums = sums_.back();
  const Assembly assembly = sample.assembly();
  const EngineSettings& settings = sample.settings();
  const ContactForces forces = evaluate_contact_forces(assembly, settings.material, settings.time_step);
  const Profiles now = [&] {
    try {
      return profiles(assembly, forces, plan_.sublayers);
    } catch (const std::invalid_argument& empty) {  // a sublayer without solid
      throw NumericalFailure(fmt::format("profiles at a shear strain of {}: {}", strain, empty.what()));
    }
  }();
  const ProfileValues snapshot{now.velocity,          now.shear_stress,      now.normal_stress,
                               top_velocity(assembly), sample.stress().shear, sample.stress().normal};
  if (sums.snapshots == 0) sums.first = snapshot;
  add(sums.sum, snapshot);
  ++sums.snapshots;
  next_strain_ = next_strain();
}

void ProfileRecord::restore(std::vector<ProfileSums> sums) {
  bool fits = sums.size() <= plan_.strains.size();
  for (std::size_t i = 0; i < sums.size() && fits; ++i) {
    const bool last = i + 1 == sums.size();
    fits = has_sublayers(sums[i].sum, plan_.sublayers) && has_sublayers(sums[i].first, plan_.sublayers) &&
           sums[i].snapshots >= 1 && sums[i].snapshots <= plan_.snapshots &&
           (last || sums[i].snapshots == plan_.snapshots);
  }
  if (!fits) throw std::invalid_argument("the profiles are not of this plan: other strains, sublayers or snapshots");
  sums_ = std::move(sums);
  next_strain_ = next_strain();
}

Series ProfileRecord::series() const {
  Series series;
  series.axis = {"relative_height", "z/H", "1", "height over that of the sample", "from the bottom up", {}};
  for (int layer = 0; layer < plan_.sublayers; ++layer) series.axis.values.push_back((layer + 0.5) / plan_.sublayers);
  const bool reads_mean = plan_.read == ProfileReading::mean;
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const auto& [first, sum, snapshots] = sums_[i];
    const bool complete = snapshots == plan_.snapshots;
    if (reads_mean && !complete) break;
    const ProfileValues &read = reads_mean ? sum : first, &other = reads_mean ? first : sum;
    // The loop ends here, because the columns of later profiles are numbered by position.
    if (!has_ratios(read)) break;
    const std::string at = fmt::format(" at a shear strain of {}", plan_.strains[i]);
    add_columns(series, "", i + 1, at, read);
    if (plan_.snapshots == 1 || !complete || !has_ratios(other)) continue;
    add_columns(series, reads_mean ? "snapshot_" : "mean_", i + 1,
                at + (reads_mean ? ", first snapshot" : ", mean of the snapshots"), other);
  }
  return series;
}

double linearity(const Series& profiles, const std::string& column) {
  const std::vector<double>&x = profiles.axis.values, &y = profiles.column(column).values;
  const auto count = static_cast<double>(x.size());
  double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / count;
    mean_y += y[i] / count;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    yy += (y[i] - mean_y) * (y[i] - mean_y);
  }
  return xy * xy / (xx * yy);
}

}  // namespace flowslide
