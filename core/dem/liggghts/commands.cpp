// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/liggghts/commands.hpp"

#include <fmt/format.h>

#include <tuple>
#include <utility>

namespace flowslide {
namespace {

constexpr int atom_types = 3;

std::string per_type(const char* property, double value) {
  std::string line = fmt::format("fix {0} all property/global {0} peratomtype", property);
  for (int i = 0; i < atom_types; ++i) line += fmt::format(" {:.17g}", value);
  return line;
}

std::string per_pair(const char* property, double value) {
  std::string line = fmt::format("fix {0} all property/global {0} peratomtypepair {1}", property, atom_types);
  for (int i = 0; i < atom_types * atom_types; ++i) line += fmt::format(" {:.17g}", value);
  return line;
}

std::string scalar(const char* property, double value) {
  return fmt::format("fix {0} all property/global {0} scalar {1:.17g}", property, value);
}

/// Appends the properties of a part of the law.
template <typename Part>
void add_properties(const Material& material, std::vector<std::string>& commands) {
  const auto add = [&](const auto& property) {
    const double value = material.*property.value;
    const bool per_pair_of_types = property.kind == laws::PropertyKind::per_pair;
    commands.push_back(per_pair_of_types ? per_pair(property.name, value) : scalar(property.name, value));
  };
  std::apply([&](const auto&... property) { (add(property), ...); }, Part::liggghts_properties);
}

/// The settings of a part of the law in the pair style.
template <typename Part>
std::string switches(const Material& material) {
  std::string settings;
  const auto add = [&](const auto& setting) {
    settings += fmt::format(" {} {}", setting.name, material.*setting.value ? "on" : "off");
  };
  if constexpr (requires { Part::liggghts_switches; })
    std::apply([&](const auto&... setting) { (add(setting), ...); }, Part::liggghts_switches);
  return settings;
}

/// The commands of the contact law: properties of its parts, then the pair style.
std::vector<std::string> law_commands(const Material& material) {
  return visit_law(material.contact_law, [&]<typename Law>(Law) {
    std::vector<std::string> commands;
    add_properties<typename Law::Normal>(material, commands);
    add_properties<typename Law::Tangential>(material, commands);
    add_properties<typename Law::Rolling>(material, commands);
    commands.push_back(fmt::format("pair_style gran model {} tangential {} rolling_friction {}",
                                   Law::Normal::liggghts_model, Law::Tangential::liggghts_model,
                                   Law::Rolling::liggghts_model) +
                       switches<typename Law::Normal>(material) + switches<typename Law::Tangential>(material) +
                       switches<typename Law::Rolling>(material));
    return commands;
  });
}

std::string box_command(const Cell& cell) {
  std::string line = "region box block";
  for (int axis = 0; axis < 3; ++axis) {
    const double margin = cell.periodic[axis] ? 0.0 : box_margin * cell.lengths()[axis];
    line += fmt::format(" {:.17g} {:.17g}", cell.lower[axis] - margin, cell.upper[axis] + margin);
  }
  return line + " units box";
}

/// Range of the neighbour list beyond contact, as a fraction of the smallest diameter.
constexpr double skin_share = 0.05;

}  // namespace

std::vector<std::string> setup_commands(const Assembly& assembly, const EngineSettings& settings,
                                        SeparatedHistory separated) {
  const Material& m = settings.material;
  const auto& periodic = assembly.cell.periodic;
  const auto boundary = [&](int axis) { return periodic[axis] ? 'p' : 'f'; };
  std::vector<std::string> commands{
      "hard_particles yes",  // otherwise LIGGGHTS refuses E = 2 GPa; must be the first command
      "units si",
      "atom_style granular",
      "atom_modify map array",
      fmt::format("boundary {} {} {}", boundary(0), boundary(1), boundary(2)),
      "newton off",                // contact histories need this command and the next
      "communicate single vel yes",
      box_command(assembly.cell),
      fmt::format("create_box {} box", atom_types),
      fmt::format("neighbor {:.17g} bin", skin_share * 2.0 * assembly.smallest_radius()),
      // A factor above 1 makes LIGGGHTS clear the history of a pair that separates.
      fmt::format("neigh_modify delay 0 every 1 check yes contact_distance_factor {}",
                  separated == SeparatedHistory::cleared ? 1.005 : 1.0),
      per_type("youngsModulus", m.youngs_modulus),
      per_type("poissonsRatio", m.poisson_ratio),
      per_pair("coefficientRestitution", m.restitution),
  };
  for (std::string& command : law_commands(m)) commands.push_back(std::move(command));
  commands.insert(commands.end(),
                  {"pair_coeff * *", fmt::format("timestep {:.17g}", settings.time_step), "thermo 0"});
  return commands;
}

std::vector<std::string> grain_commands() {
  const int bottom = atom_type(Role::bottom_layer), top = atom_type(Role::top_layer);
  return {
      fmt::format("group mobile type {}", atom_type(Role::mobile)),
      // Contacts within a glued layer do no work, but they would keep a stress forever.
      fmt::format("neigh_modify exclude type {0} {0}", bottom),
      fmt::format("neigh_modify exclude type {0} {0}", top),
      "fix integrate mobile nve/sphere",
      "compute pair_virial all pressure thermo_temp virial",  // computed only at the last step of a run
      "fix steering all viscous 0.0",  // placeholder for this project's own fix
  };
}

}  // namespace flowslide
