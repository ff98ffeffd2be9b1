// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/remarks.hpp"

#include <fmt/format.h>

#include <set>

#include "configuration/tables.hpp"
#include "input/read_samples.hpp"
#include "sample/closed_form.hpp"

namespace flowslide {
namespace {

void remark_on_other_samples(const Configuration& configuration, const std::string& engine,
                             std::vector<std::string>& remarks) {
  for (const std::string& name : closed_form_sample_names())
    if (name != engine && configuration.is_users(name))
      remarks.push_back(fmt::format("{}: not used: engine = \"{}\" does not read [{}]; engine = \"{}\" does",
                                    configuration.place_of({name}), engine, name, name));
}

void remark_on_seeds(const Configuration& configuration, std::vector<std::string>& remarks) {
  if (!configuration.is_users("sample")) return;
  const auto replicates = static_cast<std::size_t>(configuration.integer("replicates", Range::between(1, 100)));
  std::set<std::string> seen;  // samples that are `like` another one may share its list
  for (const std::string& name : configuration.subtables("sample")) {
    const std::string key = Tables(configuration, with_like(configuration, "sample", name)).key("seed_offsets");
    if (!configuration.is_users(key) || !seen.insert(key).second) continue;
    const std::size_t given = configuration.integers(key).size();
    if (given >= replicates) continue;
    remarks.push_back(fmt::format("{}: {} for {} replicates: replicate {} gets {}, each further one {} more; give one "
                                  "for each replicate to choose them",
                                  configuration.place_of({key}),
                                  given == 1 ? "one number" : fmt::format("{} numbers", given), replicates, given + 1,
                                  given * seeds_per_replicate, seeds_per_replicate));
  }
}

}  // namespace

std::vector<std::string> remarks_on(const Configuration& configuration, const std::string& engine) {
  const Configuration copy = configuration;  // what is read here shall not count as read by the case
  std::vector<std::string> remarks;
  remark_on_other_samples(copy, engine, remarks);
  if (!is_closed_form(engine)) remark_on_seeds(copy, remarks);
  return remarks;
}

}  // namespace flowslide
