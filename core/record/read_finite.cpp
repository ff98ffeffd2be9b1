// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/read_finite.hpp"

#include <fmt/format.h>

#include <cmath>

#include "record/assembly_group.hpp"

namespace flowslide {
std::string flaw_of(const Assembly& assembly) {
  const auto not_finite = [](const char* what, std::size_t grain) {
    return fmt::format("the {} of grain {} is not finite", what, grain);
  };
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    if (!std::isfinite(assembly.radius[i]) || assembly.radius[i] <= 0.0)
      return fmt::format("the radius of grain {} is not positive", i);
    if (!assembly.position[i].allFinite()) return not_finite("position", i);
    if (!assembly.velocity[i].allFinite()) return not_finite("velocity", i);
    if (!assembly.spin[i].allFinite()) return not_finite("spin", i);
    if (!assembly.force[i].allFinite()) return not_finite("force", i);
    if (!assembly.torque[i].allFinite()) return not_finite("torque", i);
  }
  for (const ContactHistory& contact : assembly.contacts)
    if (!contact.tangential_spring.allFinite() || !contact.rolling_torque.allFinite())
      return fmt::format("the contact of the grains {} and {} is not finite", contact.first, contact.second);
  const Cell& cell = assembly.cell;
  if (!cell.lower.allFinite() || !cell.upper.allFinite() || (cell.lengths().array() <= 0.0).any())
    return "the cell has no volume";
  return "";
}

void ReadNumber::operator()(const char* name, double& value) const {
  value = group.number_attribute(name);
  if (!std::isfinite(value)) throw CorruptFileError(fmt::format("{}: {} is {}", group.label(), name, value));
}

void ReadNumber::operator()(const char* name, std::int64_t& value) const {
  value = group.integer_attribute(name);
  if (value < 0) throw CorruptFileError(fmt::format("{}: {} is {}", group.label(), name, value));
}

Assembly read_finite_assembly(const hdf5::Group& parent, const std::string& name) {
  Assembly assembly = read_assembly(parent, name);
  if (const std::string flaw = flaw_of(assembly); !flaw.empty())
    throw CorruptFileError(fmt::format("{}/{}: {}", parent.label(), name, flaw));
  return assembly;
}

}  // namespace flowslide
