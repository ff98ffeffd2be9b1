// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/symbols.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "configuration/nearest.hpp"

namespace flowslide {
namespace {

struct Symbol {
  std::string_view symbol;  // without underscores
  std::array<std::string_view, 2> keys;
};

constexpr std::array symbols{
    Symbol{"k", {"hydraulic_conductivity"}},
    Symbol{"theta", {"angle"}},
    Symbol{"alpha", {"angle"}},
    Symbol{"beta", {"angle"}},
    Symbol{"H", {"thickness"}},
    Symbol{"h", {"thickness"}},
    Symbol{"hs", {"liquefiable_thickness"}},
    Symbol{"hw", {"water_table"}},
    Symbol{"rhosat", {"saturated_density"}},
    Symbol{"rhod", {"dry_density"}},
    Symbol{"e", {"void_ratio"}},
    Symbol{"e0", {"void_ratio"}},
    Symbol{"rho", {"density"}},
    Symbol{"rhos", {"density"}},
    Symbol{"E", {"youngs_modulus"}},
    Symbol{"nu", {"poisson_ratio"}},
    Symbol{"en", {"restitution"}},
    Symbol{"COR", {"restitution"}},
    Symbol{"mu", {"sliding_friction"}},
    Symbol{"mur", {"rolling_friction"}},
    Symbol{"mu1", {"preparation_friction"}},
    Symbol{"c", {"drag"}},
    Symbol{"dmin", {"smallest_diameter"}},
    Symbol{"dmax", {"largest_diameter"}},
    Symbol{"N", {"lattice"}},
    Symbol{"A", {"amplitude"}},
    Symbol{"T", {"duration"}},
    Symbol{"I", {"inertial_number"}},
    Symbol{"gammadot", {"shear_rate"}},
    Symbol{"v0", {"initial_velocity"}},
    Symbol{"dtG", {"time_step"}},
    Symbol{"dtL", {"local_time_step", "time_step"}},
    Symbol{"dt", {"time_step", "local_time_step"}},
    Symbol{"naccum", {"n_accum"}},
    Symbol{"G", {"shear_modulus"}},
    Symbol{"M", {"oedometric_modulus"}},
};

/// The path of the table of a key, and the last part of the key.
std::pair<std::string_view, std::string_view> split(std::string_view key) {
  const std::size_t dot = key.rfind('.');
  if (dot == std::string_view::npos) return {"", key};
  return {key.substr(0, dot), key.substr(dot + 1)};
}

}  // namespace

std::vector<std::string> keys_of_symbol(std::string_view symbol) {
  std::string plain(symbol);
  std::erase(plain, '_');
  std::vector<std::string> keys;
  for (const Symbol& known : symbols)
    if (known.symbol == plain)
      for (const std::string_view key : known.keys)
        if (!key.empty()) keys.emplace_back(key);
  return keys;
}

std::string key_meant(std::string_view key, const std::vector<std::string>& keys) {
  const auto [table, symbol] = split(key);
  for (const std::string& name : keys_of_symbol(symbol)) {
    const std::string* best = nullptr;
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (const std::string& candidate : keys) {
      const auto [of, last] = split(candidate);
      const std::size_t distance = edit_distance(table, of);
      if (last != name || distance >= least) continue;
      least = distance;
      best = &candidate;
    }
    if (best != nullptr) return *best;
  }
  return "";
}

}  // namespace flowslide
