// SPDX-License-Identifier: GPL-2.0-or-later
// The codes that ./reproduce bench --peers times on one sample, and how each of them is run.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "peers/first_forces.hpp"
#include "peers/lammps_input.hpp"
#include "peers/peer_sample.hpp"

namespace flowslide {

/// A sample, its folder with the inputs and logs of all codes, and its number of contacts.
struct PeerScene {
  std::string name;  ///< such as "rest"
  PeerSample sample;
  std::filesystem::path folder;
  std::size_t contacts = 0;
};

/// The stress of the initial state by a code.
struct FirstState {
  SectionStress found;     ///< by the code
  SectionStress expected;  ///< from the law of the code, evaluated by this project
  SectionStress ours;      ///< by the law of this project, from the same springs: none for other codes
  double error = 0.0;      ///< of forces over the largest force, or of stresses over the normal stress
  double tolerance = 0.0;  ///< of the error

  bool agrees() const { return error <= tolerance; }  // false for NaN
};

/// A code with one law and one number of threads.
struct PeerCode {
  std::string name;  ///< also the name of its files
  std::string version;
  int threads = 1;
  bool rolling = true;
  double usual_rate = 1e6;  ///< grains times steps per second, only to choose the number of steps
  /// Writes the input into the folder of the scene.
  std::function<void(const PeerScene&, const PeerSteps&)> write;
  /// Makes the steps on the cores that this process may use. Returns timed steps per second. Throws std::runtime_error,
  /// with the end of its log, if the code fails.
  std::function<double(const PeerScene&, const PeerSteps&)> run;
  /// The initial state. Precondition: `run` was called for this scene.
  std::function<FirstState(const PeerScene&)> first_state;
};

/// All codes of this build and this machine. `left_out` receives one line for each that is missing.
std::vector<PeerCode> peer_codes(int cores, std::vector<std::string>& left_out);

/// Names of all codes, installed or not.
std::vector<std::string> peer_code_names();

/// Steps that take a code about this time (s). Another quarter comes before them without being timed.
PeerSteps steps_for(const PeerCode& code, std::size_t grains, double seconds);

}  // namespace flowslide
