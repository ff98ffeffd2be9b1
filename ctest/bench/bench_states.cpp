// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench_states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "dem/make_engine.hpp"
#include "process/mpi_session.hpp"
#include "sample/dem_sample.hpp"
#include "sample_library/sample_cache.hpp"

namespace flowslide {
namespace {

constexpr int largest_prepared = 20'000;
constexpr double coarse_step = 1e-5, fast_coarse_step = 5e-6;  // s, to reach a state
constexpr double liquefied_stress = 300.0;                     // Pa: 1 % of sigma_0
constexpr double slow = 0.55, fast = 20.0;                     // 1/s: I = 1e-3 at 28 kPa; 4 m/s over 0.2 m

/// A lattice of about that many grains with the proportions of the paper's.
std::array<int, 3> lattice_of(int grains) {
  const int side = std::max(3, static_cast<int>(std::lround(std::cbrt(grains / 1.1))));
  return {side, side, std::max(3, static_cast<int>(std::lround(static_cast<double>(grains) / (side * side))))};
}

Assembly prepared(int grains) {
  const auto engine = make_engine("native", "/dev/null");
  SampleSpecification specification{"bench", {}, {0.80, 1.0, 1}, true};
  specification.recipe.packing.counts = lattice_of(grains);
  specification.recipe.preparation_friction = 0.5;
  specification.recipe.drag = 0.06;
  specification.recipe.stress_tolerance = 5e-3;
  return find_sample(*engine, specification, sample_cache_folder(), ProgressStyle::of_stderr(mpi_rank()))
      .sample.assembly;
}

/// Shears until the sample is liquid, or by `most` at least.
Assembly sheared(const Assembly& assembly, double rate, double step, double stress, double most) {
  const auto engine = make_engine("native", "/dev/null");
  DemSample sample(*engine, assembly, EngineSettings{Material{}, step, 0.0});
  sample.start_linear_velocity_field(rate);
  while (sample.shear_strain() < most && sample.strain({{rate, 0.0}, 100, step}).normal > stress) continue;
  return sample.assembly();
}

}  // namespace

std::vector<std::string> bench_state_names() { return {"rest", "shear", "liquefied", "runout"}; }

Assembly tiled(const Assembly& assembly, int across, int along) {
  const Vector3 length = assembly.cell.lengths();
  const auto n = static_cast<std::uint32_t>(assembly.size());
  Assembly tiles;
  tiles.cell = assembly.cell;
  tiles.cell.upper.x() += (across - 1) * length.x();
  tiles.cell.upper.y() += (along - 1) * length.y();
  tiles.resize(static_cast<std::size_t>(n) * static_cast<std::size_t>(across * along));
  const auto index = [&](std::uint32_t i, int x, int y) {
    const int column = (x + across) % across, row = (y + along) % along;
    return static_cast<std::uint32_t>(row * across + column) * n + i;
  };
  for (int y = 0; y < along; ++y)
    for (int x = 0; x < across; ++x) {
      for (std::uint32_t i = 0; i < n; ++i) {
        const std::size_t t = index(i, x, y);
        tiles.position[t] = assembly.position[i] + Vector3(x * length.x(), y * length.y(), 0.0);
        tiles.velocity[t] = assembly.velocity[i];
        tiles.spin[t] = assembly.spin[i];
        tiles.force[t] = assembly.force[i];
        tiles.torque[t] = assembly.torque[i];
        tiles.radius[t] = assembly.radius[i];
        tiles.role[t] = assembly.role[i];
      }
      for (ContactHistory contact : assembly.contacts) {
        const Vector3 apart = assembly.position[contact.second] - assembly.position[contact.first];
        contact.first = index(contact.first, x, y);
        contact.second = index(contact.second, x - static_cast<int>(std::lround(apart.x() / length.x())),
                               y - static_cast<int>(std::lround(apart.y() / length.y())));
        if (contact.first > contact.second) {  // what the second feels is the opposite
          std::swap(contact.first, contact.second);
          contact.tangential_spring = -contact.tangential_spring;
          contact.rolling_torque = -contact.rolling_torque;
        }
        tiles.contacts.push_back(contact);
      }
    }
  std::sort(tiles.contacts.begin(), tiles.contacts.end(), [](const ContactHistory& a, const ContactHistory& b) {
    return std::tie(a.first, a.second) < std::tie(b.first, b.second);
  });
  return tiles;
}

BenchState bench_state(const std::string& name, int grains) {
  BenchState state{name, 0.0, {}};
  const bool copies = grains > largest_prepared;
  state.assembly = prepared(copies ? 8800 : grains);
  if (name == "shear") {
    state.shear_rate = slow;
  } else if (name == "liquefied" || name == "runout") {
    state.shear_rate = name == "runout" ? fast : slow;
    state.assembly = sheared(state.assembly, 2.0 * slow, coarse_step, liquefied_stress, 1.0);
    if (name == "runout") state.assembly = sheared(state.assembly, fast, fast_coarse_step, -1e9, 1.0);
  } else if (name != "rest") {
    throw std::invalid_argument(fmt::format("there is no state '{}'; choose: rest, shear, liquefied, runout", name));
  }
  if (copies) {
    const int copy_count = static_cast<int>(std::lround(grains / 8800.0));
    const int along = copy_count % 2 == 0 ? 2 : 1;
    state.assembly = tiled(state.assembly, copy_count / along, along);
  }
  return state;
}

}  // namespace flowslide
