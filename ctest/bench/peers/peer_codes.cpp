// SPDX-License-Identifier: GPL-2.0-or-later
#include "peers/peer_codes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <regex>
#include <stdexcept>
#include <utility>

#include "dem/make_engine.hpp"
#include "grains/contact_forces.hpp"
#include "grains/stress.hpp"
#include "peers/run_program.hpp"
#include "peers/yade_input.hpp"

namespace flowslide {
namespace {

/// Of forces and stresses: what rounding in another order leaves in double, and in the mixed build.
constexpr double tolerance_double = 1e-9, tolerance_mixed = 1e-5;

constexpr const char* data_name = "sample.data";
constexpr const char* table_name = "sample.txt";

/// The version of a Debian package.
std::string debian_version(const std::string& package) {
  const std::filesystem::path room = std::filesystem::temp_directory_path();
  try {
    return package + " " +
           run_program({"dpkg-query", "-W", "-f", "${Version}", package}, room,
                       fmt::format("flowslide_version_{}", package));
  } catch (const std::runtime_error&) {
    return package + " of unknown version";
  }
}

PeerSample sample_for(const PeerSample& sample, bool rolling) {
  PeerSample changed = sample;
  if (!rolling) changed.material.rolling_friction = 0.0;
  return changed;
}

/// An engine of this project, LIGGGHTS among them, with the springs of the sample.
struct EngineCode {
  std::string engine, name;
  int threads;
  bool rolling;

  std::unique_ptr<Engine> loaded(const PeerScene& scene) const { return loaded(engine, scene); }
  std::unique_ptr<Engine> loaded(const std::string& other, const PeerScene& scene) const {
    const PeerSample sample = sample_for(scene.sample, rolling);
    auto loaded = make_engine(other, scene.folder / (name + ".log"), threads);
    loaded->load(sample.assembly, EngineSettings{sample.material, sample.time_step, 0.0});
    BoundaryMotion motion;
    motion.top_velocity.x() = sample.top_velocity;
    loaded->move(motion);
    return loaded;
  }
  void write(const PeerScene& scene, const PeerSteps&) const {
    const PeerSample sample = sample_for(scene.sample, rolling);
    std::string text;
    for (const std::string& line :
         setup_text(engine, sample.assembly, EngineSettings{sample.material, sample.time_step, 0.0}))
      text += line + "\n";
    if (!text.empty()) write_text(scene.folder / (name + ".in"), text);
  }
  double run(const PeerScene& scene, const PeerSteps& steps) const {
    const auto stepped = loaded(scene);
    stepped->run(steps.before);
    const auto start = std::chrono::steady_clock::now();
    stepped->run(steps.timed);
    return steps.timed / std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  /// The stress of the first step, by this engine and by the plain form of the law.
  FirstState first_state(const PeerScene& scene) const {
    const auto stepped = loaded(scene), reference = loaded("native", scene);
    stepped->run(1);
    reference->run(1);
    const CellStress found = stepped->cell_stress();
    const Assembly grains = reference->save();
    const SlopeStress ours = slope_stress(
        bagi_stress(grains, evaluate_contact_forces(grains, reference->settings().material, scene.sample.time_step)));
    FirstState state;
    state.found = {found.normal, found.shear};
    state.expected = state.ours = {ours.normal, ours.shear};
    state.error =
        std::max(std::abs(found.normal - ours.normal), std::abs(found.shear - ours.shear)) / std::abs(ours.normal);
    state.tolerance = engine == "native-mixed" ? tolerance_mixed : tolerance_double;
    return state;
  }
};

PeerCode engine_code(const std::string& engine, int threads, bool rolling, double usual_rate) {
  const std::string name =
      fmt::format("{}{}{}", engine, rolling ? "" : "-no-rolling", threads > 1 ? fmt::format("-{}", threads) : "");
  const EngineCode code{engine, name, threads, rolling};
  return {name,
          engine == "liggghts" ? debian_version("liggghts") : "this project",
          threads,
          rolling,
          usual_rate,
          [code](const PeerScene& scene, const PeerSteps& steps) { code.write(scene, steps); },
          [code](const PeerScene& scene, const PeerSteps& steps) { return code.run(scene, steps); },
          [code](const PeerScene& scene) { return code.first_state(scene); }};
}

/// The initial state of a code that has written its forces.
std::function<FirstState(const PeerScene&)> state_from_forces(
    const std::string& name, const std::function<FirstStepLaw(const PeerScene&)>& law) {
  return [name, law](const PeerScene& scene) {
    const Assembly& grains = scene.sample.assembly;
    const std::vector<Vector3> found = read_forces(scene.folder / (name + ".forces"), grains.size());
    const std::vector<Vector3> expected = first_forces(scene.sample, law(scene));
    return FirstState{section_stress(grains, found), section_stress(grains, expected),
                      section_stress(grains, first_forces_of_this_project(scene.sample)), force_error(found, expected),
                      tolerance_double};
  };
}

/// Timed steps per second from what a code has printed: the last match of a pattern with (steps) and (seconds) in this
/// order or the other.
double speed_in(const std::string& said, const std::string& pattern, bool steps_first, const std::string& name) {
  const std::regex line(pattern);
  double speed = 0.0;
  for (std::sregex_iterator match(said.begin(), said.end(), line), end; match != end; ++match) {
    const double first = std::stod((*match)[1]), second = std::stod((*match)[2]);
    speed = steps_first ? first / second : second / first;
  }
  if (!(speed > 0.0)) throw std::runtime_error(name + " has printed no time; see its log");
  return speed;
}

PeerCode lammps_code(const std::string& name, LammpsLaw law, double usual_rate) {
  const auto first_law = [law](const PeerScene& scene) {
    FirstStepLaw first{.arms_to_surface = true, .none_beyond_cap = true};
    if (law == LammpsLaw::granular) return first;
    const HertzHistoryDamping damping = hertz_history_damping(typical_contact(scene.sample));
    first.normal_rate = damping.normal;
    first.tangential_rate = damping.tangential;
    return first;
  };
  return {
      name,
      debian_version("lammps"),
      1,
      law == LammpsLaw::granular,
      usual_rate,
      [=](const PeerScene& scene, const PeerSteps& steps) {
        write_text(scene.folder / data_name, lammps_data(scene.sample));
        write_text(scene.folder / (name + ".in"), lammps_script(scene.sample, law, steps, data_name, name + ".forces"));
      },
      [=](const PeerScene& scene, const PeerSteps&) {
        const std::string said = run_program({"lmp", "-log", "none", "-in", name + ".in"}, scene.folder, name + ".log");
        return speed_in(said, R"(Loop time of (\S+) on \d+ procs for (\d+) steps)", false, name);
      },
      state_from_forces(name, first_law)};
}

PeerCode yade_code(const std::string& name, int threads, double usual_rate) {
  const FirstStepLaw law{.glued_are_heavy = true, .attraction_left_out = true};
  return {name,
          debian_version("yade"),
          threads,
          true,
          usual_rate,
          [=](const PeerScene& scene, const PeerSteps& steps) {
            write_text(scene.folder / table_name, sample_table(scene.sample));
            write_text(scene.folder / (name + ".py"), yade_script(scene.sample, steps, table_name, name + ".forces"));
          },
          [=](const PeerScene& scene, const PeerSteps&) {
            const std::string said = run_program({"yade", "-n", "-x", fmt::format("-j{}", threads), name + ".py"},
                                                 scene.folder, name + ".log");
            return speed_in(said, R"(flowslide: (\d+) steps in (\S+) s)", true, name);
          },
          state_from_forces(name, [law](const PeerScene&) { return law; })};
}

}  // namespace

std::vector<std::string> peer_code_names() {
  return {"native",
          "native-mixed",
          "native-no-rolling",
          "native-mixed-no-rolling",
          "native-2",
          "native-mixed-2",
          "liggghts",
          "lammps-granular",
          "lammps-hertz",
          "yade",
          "yade-2"};
}

std::vector<PeerCode> peer_codes(int cores, std::vector<std::string>& left_out) {
  std::vector<PeerCode> codes;
  for (const auto& [engine, rate] : {std::pair{"native", 4e7}, std::pair{"native-mixed", 6e7}}) {
    codes.push_back(engine_code(engine, 1, true, rate));
    codes.push_back(engine_code(engine, 1, false, 1.2 * rate));
    if (cores > 1) codes.push_back(engine_code(engine, 2, true, 1.6 * rate));
  }
  const std::vector<std::string> engines = engine_names_of_build();
  if (std::find(engines.begin(), engines.end(), "liggghts") != engines.end())
    codes.push_back(engine_code("liggghts", 1, true, 5e6));
  else
    left_out.push_back("LIGGGHTS is left out: this build has FLOWSLIDE_LIGGGHTS=OFF");
  if (is_installed("lmp")) {
    codes.push_back(lammps_code("lammps-granular", LammpsLaw::granular, 3e6));
    codes.push_back(lammps_code("lammps-hertz", LammpsLaw::hertz_history, 7e6));
  } else {
    left_out.push_back("LAMMPS is left out: there is no program lmp (package lammps of packages-peers.txt)");
  }
  if (is_installed("yade")) {
    codes.push_back(yade_code("yade", 1, 1e6));
    if (cores > 1) codes.push_back(yade_code("yade-2", 2, 1.6e6));
  } else {
    left_out.push_back("YADE is left out: there is no program yade (package yade of packages-peers.txt)");
  }
  if (cores < 2) left_out.push_back("Two threads are left out: this process may use one core only");
  return codes;
}

PeerSteps steps_for(const PeerCode& code, std::size_t grains, double seconds) {
  constexpr int least = 20;
  const int timed = std::max(least, static_cast<int>(seconds * code.usual_rate / static_cast<double>(grains)));
  return {std::max(least, timed / 4), timed};
}

}  // namespace flowslide
