// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/assembly_group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <stdexcept>
#include <tuple>

namespace flowslide {
namespace {

static_assert(sizeof(Vector3) == 3 * sizeof(double), "an array of vectors is an array of shape (n, 3)");

void write_vectors(hdf5::Group& group, const std::string& name, std::span<const Vector3> values, const char* units) {
  const std::span<const double> numbers(values.empty() ? nullptr : values.front().data(), 3 * values.size());
  group.write<double>(name, numbers, {values.size(), 3}).set_attribute("units", units);
}

std::vector<Vector3> read_vectors(const hdf5::Group& group, const std::string& name, std::size_t n) {
  const auto numbers = group.read<double>(name, {n, 3});
  std::vector<Vector3> values(n);
  if (n > 0) std::memcpy(values.front().data(), numbers.data(), numbers.size() * sizeof(double));
  return values;
}

void write_cell(hdf5::Group& group, const Cell& cell) {
  group.write<double>("cell_lower", std::span(cell.lower.data(), 3), {3}).set_attribute("units", "m");
  group.write<double>("cell_upper", std::span(cell.upper.data(), 3), {3}).set_attribute("units", "m");
  const std::vector<std::uint8_t> periodic(cell.periodic.begin(), cell.periodic.end());
  group.write<std::uint8_t>("cell_periodic", periodic, {3}).set_attribute("units", "1");
  if (!cell.periodic[2]) return;
  group.write<double>("cell_shear_offset", std::span(&cell.shear_offset, 1), {1}).set_attribute("units", "m");
  group.write<double>("cell_shear_velocity", std::span(&cell.shear_velocity, 1), {1}).set_attribute("units", "m/s");
}

Cell read_cell(const hdf5::Group& group) {
  Cell cell;
  std::ranges::copy(group.read<double>("cell_lower", {3}), cell.lower.data());
  std::ranges::copy(group.read<double>("cell_upper", {3}), cell.upper.data());
  const auto periodic = group.read<std::uint8_t>("cell_periodic", {3});
  for (std::size_t axis = 0; axis < 3; ++axis) cell.periodic[axis] = periodic[axis] != 0;
  if (cell.periodic[2] && group.has("cell_shear_offset")) {  // absent in files from before such cells could be sheared
    cell.shear_offset = group.read<double>("cell_shear_offset", {1})[0];
    cell.shear_velocity = group.read<double>("cell_shear_velocity", {1})[0];
  }
  return cell;
}

void write_contacts(hdf5::Group& group, std::span<const ContactHistory> contacts) {
  std::vector<std::uint32_t> pairs;
  std::vector<Vector3> springs, torques;
  for (const ContactHistory& contact : contacts) {
    pairs.insert(pairs.end(), {contact.first, contact.second});
    springs.push_back(contact.tangential_spring);
    torques.push_back(contact.rolling_torque);
  }
  group.write<std::uint32_t>("contact_pair", pairs, {contacts.size(), 2}).set_attribute("units", "1");
  write_vectors(group, "contact_tangential_spring", springs, "m");
  write_vectors(group, "contact_rolling_torque", torques, "N m");
}

std::vector<ContactHistory> read_contacts(const hdf5::Group& group) {
  const auto pairs = group.read<std::uint32_t>("contact_pair", {hdf5::Group::any, 2});
  const std::size_t m = pairs.size() / 2;
  const auto springs = read_vectors(group, "contact_tangential_spring", m);
  const auto torques = read_vectors(group, "contact_rolling_torque", m);
  std::vector<ContactHistory> contacts(m);
  for (std::size_t i = 0; i < m; ++i) contacts[i] = {pairs[2 * i], pairs[2 * i + 1], springs[i], torques[i]};
  return contacts;
}

void check(const Assembly& assembly, const std::string& label) {
  const auto refuse = [&](std::string_view reason) {
    throw CorruptFileError(fmt::format("{}: {}", label, reason));
  };
  for (const Role role : assembly.role)
    if (role > Role::top_layer) refuse("a grain with an unknown role");
  const auto pair = [](const ContactHistory& contact) { return std::tuple(contact.first, contact.second); };
  for (std::size_t i = 0; i < assembly.contacts.size(); ++i) {
    const ContactHistory& contact = assembly.contacts[i];
    if (contact.second >= assembly.size()) refuse("a contact of a grain that does not exist");
    if (contact.first >= contact.second) refuse("a contact whose grains are not in order");
    if (i > 0 && pair(assembly.contacts[i - 1]) >= pair(contact)) refuse("contacts that are not in order");
  }
}

}  // namespace

void write_assembly(hdf5::Group& parent, const std::string& name, const Assembly& assembly) {
  auto group = parent.create_group(name);
  const std::size_t n = assembly.size();
  for (const auto* array : {&assembly.position, &assembly.velocity, &assembly.spin, &assembly.force, &assembly.torque})
    if (array->size() != n) throw std::invalid_argument("an assembly whose arrays differ in length");
  group.write<double>("radius", assembly.radius, {n}).set_attribute("units", "m");
  write_vectors(group, "position", assembly.position, "m");
  write_vectors(group, "velocity", assembly.velocity, "m/s");
  write_vectors(group, "spin", assembly.spin, "rad/s");
  write_vectors(group, "force", assembly.force, "N");
  write_vectors(group, "torque", assembly.torque, "N m");
  std::vector<std::uint8_t> roles;
  for (const Role role : assembly.role) roles.push_back(static_cast<std::uint8_t>(role));
  auto role = group.write<std::uint8_t>("role", roles, {n});
  role.set_attribute("units", "1");
  role.set_attribute("meaning", "0 mobile, 1 glued to the bottom, 2 glued to the top");
  write_contacts(group, assembly.contacts);
  write_cell(group, assembly.cell);
}

Assembly read_assembly(const hdf5::Group& parent, const std::string& name) {
  const auto group = parent.group(name);
  Assembly assembly;
  assembly.cell = read_cell(group);
  assembly.radius = group.read<double>("radius", {hdf5::Group::any});
  const std::size_t n = assembly.size();
  assembly.position = read_vectors(group, "position", n);
  assembly.velocity = read_vectors(group, "velocity", n);
  assembly.spin = read_vectors(group, "spin", n);
  assembly.force = read_vectors(group, "force", n);
  assembly.torque = read_vectors(group, "torque", n);
  for (const auto role : group.read<std::uint8_t>("role", {n})) assembly.role.push_back(static_cast<Role>(role));
  assembly.contacts = read_contacts(group);
  check(assembly, group.label());
  return assembly;
}

}  // namespace flowslide
