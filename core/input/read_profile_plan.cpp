// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/read_profile_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace flowslide {

ProfilePlan read_profile_plan(const Configuration& configuration, const std::string& strains_key) {
  ProfilePlan plan;
  configuration.accept("profiles", "no run has profile_strains");
  if (!configuration.has(strains_key)) return plan;
  plan.strains = configuration.numbers(strains_key, Range::not_negative());
  if (std::adjacent_find(plan.strains.begin(), plan.strains.end(), std::greater_equal<>()) != plan.strains.end())
    configuration.refuse(strains_key, "does not increase", "sort the strains and give each once");
  plan.sublayers = static_cast<int>(configuration.integer("profiles.sublayers", Range::between(2, 1000)));
  plan.snapshots = static_cast<int>(configuration.integer("profiles.snapshots", Range::between(1, 100000)));
  plan.window = configuration.number("profiles.window", Range::not_negative());
  if (const std::string key = "profiles.read"; configuration.has(key))
    plan.read = choice_of<ProfileReading>(configuration.text(key, choice_names<ProfileReading>()));
  for (std::size_t i = 1; i < plan.strains.size(); ++i)
    if (const double last = plan.last_strain(i - 1); last >= plan.strains[i])
      configuration.refuse(strains_key,
                           fmt::format("has {} before the last snapshot of the profile of {}, at {}", plan.strains[i],
                                       plan.strains[i - 1], last),
                           "give strains that are farther apart, or a smaller profiles.window");
  return plan;
}

}  // namespace flowslide
