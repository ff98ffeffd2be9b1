// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/read_samples.hpp"

#include <fmt/format.h>

#include <set>

#include "configuration/error.hpp"
#include "input/read_fields.hpp"
#include "sample/health.hpp"

namespace flowslide {
namespace {

/// Bounds the memory of a packing: a mistyped lattice is refused before it is allocated.
constexpr std::int64_t most_grains = 10'000'000;

LatticePacking read_packing(const Configuration& configuration, const TableNames& tables) {
  const Tables table(configuration, tables);
  LatticePacking packing;
  read_fields(table, packing, {"spacing", "jitter", "seed"});
  const auto& counts = packing.counts;
  if (const std::int64_t grains = std::int64_t{counts[0]} * counts[1] * counts[2]; grains > most_grains)
    table.refuse("lattice", fmt::format("gives {} grains, and {} are allowed", grains, most_grains),
                 "choose a smaller lattice");
  if (packing.largest_diameter < packing.smallest_diameter)
    table.refuse("largest_diameter", fmt::format("is below packing.smallest_diameter, {} m", packing.smallest_diameter),
                 "change one of them");
  packing.seed = static_cast<std::uint64_t>(configuration.integer("seed", Range::between(0, 1e9)));
  return packing;
}

/// Reads the stages of the preparation in which drag acts: a list of stage numbers from 1 to 4.
std::array<bool, 4> read_drag_stages(const Tables& table) {
  std::array<bool, 4> acts{};
  for (const std::int64_t stage : table.integers("drag_stages", Range::between(1, 4))) acts[stage - 1] = true;
  return acts;
}

/// Reads the part of the recipe that [preparation] gives: all except the grains, the time step, which depends on
/// them, and the keys of [sample.<name>].
SampleRecipe read_preparation(const Configuration& configuration, const TableNames& tables) {
  const Tables table(configuration, tables);
  SampleRecipe recipe;
  read_fields(table, recipe,
              {"packing", "material", "normal_stress", "shear_stress", "preparation_friction", "periodic_height",
               "glue", "drag", "drag_stages", "most_steps", "time_step"});
  recipe.drag_stages = read_drag_stages(table);
  return recipe;
}

/// The choice under `key`, or `otherwise` without this key.
template <Choice Enum>
Enum optional_choice(const Tables& sample, const char* key, Enum otherwise) {
  return sample.has(key) ? choice_of<Enum>(sample.text(key, choice_names<Enum>())) : otherwise;
}

std::uint64_t seed_offset(const Tables& sample, int replicate) {
  if (sample.has("seed_offsets")) {
    const auto offsets = sample.integers("seed_offsets", Range::between(0, 1e9));
    if (static_cast<std::size_t>(replicate) < offsets.size()) return static_cast<std::uint64_t>(offsets[replicate]);
  }
  return static_cast<std::uint64_t>(replicate) * seeds_per_replicate;
}

/// mu_1 of a sample: the value found earlier for this replicate, or else the value with which the search starts.
/// `own` is the table of the sample without those that it is `like`: what was found for another recipe does not help.
double preparation_friction(const Tables& sample, const Tables& own, int replicate) {
  SampleRecipe recipe;
  read_field(sample, recipe, &SampleRecipe::preparation_friction);
  sample.accept({"found_preparation_frictions"});
  if (!own.has("found_preparation_frictions")) return recipe.preparation_friction;
  const FieldKey key = key_of(&SampleRecipe::preparation_friction);
  const std::vector<double> found = own.quantities("found_preparation_frictions", key.dimension(), key.range());
  return static_cast<std::size_t>(replicate) < found.size() ? found[replicate] : recipe.preparation_friction;
}

}  // namespace

SlopeProperties read_slope(const Configuration& configuration) {
  SlopeProperties slope;
  const auto positive = [&](const char* key, const Dimension& dimension) {
    return configuration.quantity(key, dimension, Range::positive());
  };
  slope.saturated_density = positive("slope.saturated_density", dimension::density);
  slope.dry_density = positive("slope.dry_density", dimension::density);
  slope.thickness = positive("slope.thickness", dimension::length);
  slope.liquefiable_thickness = positive("slope.liquefiable_thickness", dimension::length);
  slope.water_table = configuration.quantity("slope.water_table", dimension::length, Range::not_negative());
  slope.angle = configuration.quantity("slope.angle", dimension::angle, Range::between(0.0, 1.5));
  slope.hydraulic_conductivity =
      configuration.quantity("slope.hydraulic_conductivity", dimension::velocity, Range::not_negative());
  as_written_by_user(configuration.place_of({"slope"}), [&] { validate(slope); });
  return slope;
}

Material read_material(const Configuration& configuration, const TableNames& tables) {
  Material material;
  const Tables table(configuration, tables);
  read_fields(table, material);
  const std::string reason = fmt::format("contact_law = \"{}\" does not use it", name_of(material.contact_law));
  const auto accept = [&](const auto& field) {
    if (!material.uses(field.name)) table.accept({field.name}, reason);
  };
  std::apply([&](const auto&... field) { (accept(field), ...); }, Material::fields());
  return material;
}

std::vector<std::string> samples_in_use(const Configuration& configuration) {
  std::set<std::string> named;
  for (const std::string& point : configuration.subtables("point"))
    if (const std::string key = "point." + point + ".sample"; configuration.has(key))
      named.insert(configuration.text(key));
  std::vector<std::string> samples = configuration.subtables("sample");
  std::erase_if(samples, [&](const std::string& name) {
    return configuration.is_of_base("sample." + name) && !named.contains(name);
  });
  return samples;
}

std::vector<SampleSpecification> read_samples(const Configuration& configuration, const SlopeProperties& slope,
                                              int replicate) {
  std::vector<SampleSpecification> samples;
  for (const std::string& name : samples_in_use(configuration)) {
    const std::vector<std::string> tables = with_like(configuration, "sample", name);
    const Tables own(configuration, tables);
    const TableNames preparation = within(tables, "preparation", {"preparation"});
    SampleSpecification sample{name, read_preparation(configuration, preparation), {}};
    sample.recipe.packing = read_packing(configuration, within(tables, "packing", {"packing"}));
    sample.recipe.packing.seed += seed_offset(own, replicate);
    sample.recipe.material = read_material(configuration, within(tables, "material", {"material"}));
    sample.recipe.normal_stress = initial_normal_stress(slope);
    sample.recipe.shear_stress = own.flag("isotropic") ? 0.0 : initial_shear_stress(slope);
    sample.recipe.periodic_height = own.has("periodic_height") && own.flag("periodic_height");
    sample.recipe.preparation_friction = preparation_friction(own, Tables(configuration, tables.front()), replicate);
    read_field(own, sample.recipe, &SampleRecipe::drag);
    sample.target.void_ratio = own.number("void_ratio", Range::inside(0.55, 1.0));
    sample.target.tolerance = own.number("tolerance", Range::positive());
    sample.target.most_trials = static_cast<int>(own.integer("most_trials", Range::between(1, 100)));
    sample.target.region = optional_choice(own, "void_ratio_of", VoidRatioRegion::cell);
    sample.recipe.glue = optional_choice(own, "glue", Glue::one_layer);
    sample.strain_height = optional_choice(own, "strain_height", StrainHeight::cell);
    sample.allow_uneven = Tables(configuration, preparation).flag("allow_uneven");
    sample.recipe.time_step =
        read_grain_time_step(configuration, Tables(configuration, preparation).key("time_step"),
                             sample.recipe.packing.smallest_diameter, sample.recipe.material);
    std::vector<std::string> places = tables;
    places.insert(places.end(), {"preparation", "packing", "material"});
    as_written_by_user(fmt::format("{}: sample {}", configuration.place_of(places), name),
                       [&] { validate(sample.recipe); });
    samples.push_back(sample);
  }
  return samples;
}

double read_grain_time_step(const Configuration& configuration, const std::string& key, double smallest_diameter,
                            const Material& material) {
  const double limit = longest_time_step(0.5 * smallest_diameter, material);
  const double time_step = configuration.quantity(key, dimension::time, Range::positive());
  if (time_step > limit)
    configuration.refuse(key,
                         fmt::format("is too long for DEM: at most {:.3g} s, which is {} of the Rayleigh time of the "
                                     "smallest grain", limit, largest_share_of_rayleigh_time),
                         "choose a smaller step, or larger or softer grains");
  return time_step;
}

}  // namespace flowslide
