// SPDX-License-Identifier: GPL-2.0-or-later
//
// LIGGGHTS reports every error through the class Error. Its methods end the process with exit(1) or MPI_Abort, without
// a message if the screen is off. They are exported functions of a shared library. The definitions below therefore
// replace them (ELF symbol interposition) and throw an exception that names the present activity.
#include "dem/liggghts/error_bridge.hpp"

#include <error.h>
#include <lammps.h>
#include <mpi.h>

#include <cstdio>
#include <string>

#include "dem/engine.hpp"

namespace flowslide {

LiggghtsActivity& liggghts_activity() {
  static LiggghtsActivity activity;
  return activity;
}

namespace {

constexpr int exit_numerical_failure = 3;

std::string message(const char* text) {
  const LiggghtsActivity& activity = liggghts_activity();
  return "LIGGGHTS failed: " + std::string(text) + "\n  while: " + activity.doing +
         "\n  its log: " + activity.log.string();
}

/// An error that all ranks of the simulation report together.
[[noreturn]] void fail_together(const LAMMPS_NS::LAMMPS* simulation, const char* text) {
  liggghts_activity().broken.insert(simulation);
  throw EngineError(message(text));
}

/// An error of one rank. The others wait in a collective call, so that all ranks must be ended.
[[noreturn]] void fail_alone(const LAMMPS_NS::LAMMPS* simulation, const char* text) {
  int ranks = 1;
  MPI_Comm_size(simulation->world, &ranks);
  if (ranks == 1) fail_together(simulation, text);
  std::fprintf(stderr, "error: %s\n", message(text).c_str());
  std::fflush(stderr);
  MPI_Abort(simulation->world, exit_numerical_failure);
  std::abort();
}

}  // namespace
}  // namespace flowslide

namespace LAMMPS_NS {

void Error::all(const char*, int, const char* text) { flowslide::fail_together(lmp, text); }
void Error::one(const char*, int, const char* text) { flowslide::fail_alone(lmp, text); }
void Error::universe_all(const char*, int, const char* text) { flowslide::fail_together(lmp, text); }
void Error::universe_one(const char*, int, const char* text) { flowslide::fail_alone(lmp, text); }
void Error::fix_error(const char*, int, Fix*, const char* text) { flowslide::fail_together(lmp, text); }
void Error::fix_error(const char*, int, Fix*, const char* style, const char* text) {
  flowslide::fail_together(lmp, ("fix " + std::string(style) + ": " + text).c_str());
}
void Error::compute_error(const char*, int, Compute*, const char* text) { flowslide::fail_together(lmp, text); }

}  // namespace LAMMPS_NS
