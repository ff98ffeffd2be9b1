// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/liggghts/pair_histories.hpp"

#include <atom.h>
#include <fmt/format.h>
#include <force.h>
#include <lammps.h>
#include <neigh_list.h>
#include <pair_gran.h>

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace flowslide {
namespace {

/// Offsets in the history array of a pair in LIGGGHTS: first the tangential model, then the rolling model.
constexpr int spring_offset = 0, torque_offset = 3;

/// Whether the array has a rolling torque.
bool has_torque(LAMMPS_NS::LAMMPS& lammps, ContactLaw law) {
  const bool expected = visit_law(law, []<typename Law>(Law) { return Law::Rolling::has_history; });
  const int length = static_cast<LAMMPS_NS::PairGran*>(lammps.force->pair)->dnum();
  if (length != (expected ? torque_offset + 3 : torque_offset))
    throw std::logic_error(fmt::format("LIGGGHTS keeps {} values for each contact of the law \"{}\"; correct "
                                       "has_history of its rolling part", length, name_of(law)));
  return expected;
}

/// Calls visit(i, j, history) for every touching pair in the neighbour list of this rank. i and j are local indices; j
/// may be a ghost. With `newton off` a pair with a ghost is in the lists of both owners.
template <typename Visit>
void for_each_touching_pair(LAMMPS_NS::LAMMPS& lammps, Visit visit) {
  auto* pair = static_cast<LAMMPS_NS::PairGran*>(lammps.force->pair);
  const LAMMPS_NS::NeighList& list = *pair->list;
  const LAMMPS_NS::Atom& atom = *lammps.atom;
  for (int k = 0; k < list.inum; ++k) {
    const int i = list.ilist[k];
    double* histories = list.listgranhistory->firstdouble[i];
    for (int m = 0; m < list.numneigh[i]; ++m) {
      const int j = list.firstneigh[i][m] & NEIGHMASK;
      const double reach = atom.radius[i] + atom.radius[j];
      if ((Vector3::Map(atom.x[i]) - Vector3::Map(atom.x[j])).squaredNorm() < reach * reach)
        visit(i, j, histories + m * pair->dnum());
    }
  }
}

std::uint32_t index_of(const LAMMPS_NS::Atom& atom, int i) { return static_cast<std::uint32_t>(atom.tag[i] - 1); }

}  // namespace

std::vector<ContactHistory> read_histories(LAMMPS_NS::LAMMPS& lammps, ContactLaw law) {
  const bool rolls = has_torque(lammps, law);
  std::vector<ContactHistory> contacts;
  const LAMMPS_NS::Atom& atom = *lammps.atom;
  for_each_touching_pair(lammps, [&](int i, int j, const double* history) {
    const std::uint32_t a = index_of(atom, i), b = index_of(atom, j);
    if (j >= atom.nlocal && a > b) return;  // the owner of the other grain, or the other image, reports it
    const double sign = a < b ? 1.0 : -1.0;
    ContactHistory contact{std::min(a, b), std::max(a, b), sign * Vector3::Map(history + spring_offset)};
    if (rolls) contact.rolling_torque = sign * Vector3::Map(history + torque_offset);
    contacts.push_back(contact);
  });
  return contacts;
}

void write_histories(LAMMPS_NS::LAMMPS& lammps, ContactLaw law, const std::vector<ContactHistory>& contacts) {
  const bool rolls = has_torque(lammps, law);
  const LAMMPS_NS::Atom& atom = *lammps.atom;
  for_each_touching_pair(lammps, [&](int i, int j, double* history) {
    const std::uint32_t a = index_of(atom, i), b = index_of(atom, j);
    const auto key = std::minmax(a, b);
    const auto before = [](const ContactHistory& c, const std::pair<std::uint32_t, std::uint32_t>& k) {
      return std::tie(c.first, c.second) < std::tie(k.first, k.second);
    };
    const std::pair<std::uint32_t, std::uint32_t> wanted{key.first, key.second};
    const auto found = std::lower_bound(contacts.begin(), contacts.end(), wanted, before);
    const bool known = found != contacts.end() && found->first == wanted.first && found->second == wanted.second;
    const double sign = a < b ? 1.0 : -1.0;
    Vector3::Map(history + spring_offset) = known ? Vector3(sign * found->tangential_spring) : Vector3::Zero();
    if (rolls)
      Vector3::Map(history + torque_offset) = known ? Vector3(sign * found->rolling_torque) : Vector3::Zero();
  });
}

}  // namespace flowslide
