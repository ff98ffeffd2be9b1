// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/replicates.hpp"

#include <fmt/format.h>

#include <map>

#include "configuration/error.hpp"
#include "configuration/tables.hpp"
#include "record/result_file.hpp"

namespace flowslide {

void refuse_equal_recipes(const Configuration& configuration,
                          const std::vector<std::vector<SampleSpecification>>& samples) {
  std::map<std::string, std::size_t> first;  // name and recipe of a sample -> its first replicate
  for (std::size_t replicate = 0; replicate < samples.size(); ++replicate)
    for (const SampleSpecification& sample : samples[replicate]) {
      const auto [known, is_new] = first.emplace(sample.name + "\n" + sample.recipe.text(), replicate);
      if (!is_new)
        throw ConfigurationError(fmt::format(
            "{}: replicates {} and {} of the sample \"{}\" are the same: both start from seed {} and preparation "
            "friction "
            "{}; give sample.{}.seed_offsets one number for each replicate, all of them different",
            configuration.place_of(with_like(configuration, "sample", sample.name)), known->second + 1, replicate + 1,
            sample.name, sample.recipe.packing.seed, sample.recipe.preparation_friction, sample.name));
    }
}

void refuse_equal_samples(const std::vector<Provenance>& results) {
  std::map<std::string, const Provenance*> first;
  for (const Provenance& result : results) {
    const std::size_t blank = result.sample.find(' ');
    if (blank == std::string::npos) continue;  // a closed-form sample
    const Provenance& known = *first.emplace(result.sample, &result).first->second;
    if (known.replicate == result.replicate) continue;
    const std::string table = result.sample.substr(0, blank);
    throw ConfigurationError(fmt::format(
        "{} and {} are no replicates: they have the same sample \"{}\", because the search for its void ratio "
        "increased the seed of one to that of the other; set sample.{}.seed_offsets to numbers farther apart, such as "
        "[0, 1000, 2000]",
        known.point, result.point, table, table));
  }
}

void refuse_sample_of_others(const Provenance& own, const std::string& configuration_hash,
                             const std::filesystem::path& folder, const std::vector<std::string>& points) {
  for (const std::string& point : points) {
    const auto file = folder / (point + ".h5");
    if (point == own.point || !std::filesystem::exists(file)) continue;
    Result other;
    try {
      other = read_result(file);
    } catch (const FileError&) {
      continue;
    }
    if (other.configuration_hash == configuration_hash) refuse_equal_samples({other.provenance, own});
  }
}

}  // namespace flowslide
