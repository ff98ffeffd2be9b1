// SPDX-License-Identifier: GPL-2.0-or-later
// peer_bench [--scenes STATE/N,...] [--codes A,B] [--turns N] [--seconds S] [--output DIR]
// Times this project's kernel, LIGGGHTS, LAMMPS and YADE by turns on the same samples, with the paper's dt_L. Writes
// the input of each code into a folder for each sample. A code whose forces of the initial state are not those of its
// law, as this project evaluates it, is refused. Prints tables in Markdown.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sched.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "bench_options.hpp"
#include "bench_states.hpp"
#include "configuration/error.hpp"
#include "dem/make_engine.hpp"
#include "grains/contact_forces.hpp"
#include "peers/peer_table.hpp"
#include "peers/run_program.hpp"
#include "process/exit_code.hpp"
#include "program/run_main.hpp"
#include "sample/dem_sample.hpp"

namespace flowslide {
namespace {

struct Options {
  std::vector<std::string> scenes{"rest/8800", "shear/8800", "liquefied/8800", "rest/1100", "rest/70400"};
  std::vector<std::string> codes = peer_code_names();
  int turns = 5;
  double seconds = 5.0;
  std::filesystem::path output = "results/bench/peers";
};

Options read_options(int argc, char** argv) {
  Options options;
  CLI::App app("This project's kernel beside other codes");
  app.add_option("--scenes", options.scenes, "STATE/NUMBER OF GRAINS")->delimiter(',');
  app.add_option("--codes", options.codes)->delimiter(',')->check(CLI::IsMember(peer_code_names()));
  app.add_option("--turns", options.turns)->check(CLI::Range(1, 1000));
  app.add_option("--seconds", options.seconds, "of each code in each turn, about")->check(CLI::Range(0.01, 3600.0));
  app.add_option("--output", options.output, "folder of the inputs and logs");
  parse_options(app, argc, argv);
  return options;
}

/// The cores that this process may use. Each code gets the first of them.
class Cores {
 public:
  Cores() { ::sched_getaffinity(0, sizeof all_, &all_); }
  int count() const { return CPU_COUNT(&all_); }
  /// Restricts this process, and the threads and programs that it starts from now on, to `number` cores.
  void use(int number) const {
    cpu_set_t chosen;
    CPU_ZERO(&chosen);
    for (int core = 0; core < CPU_SETSIZE && CPU_COUNT(&chosen) < number; ++core)
      if (CPU_ISSET(core, &all_)) CPU_SET(core, &chosen);
    ::sched_setaffinity(0, sizeof chosen, &chosen);
  }

 private:
  cpu_set_t all_;
};

/// State and number of grains of a scene. Throws ConfigurationError.
std::pair<std::string, int> scene_words(const std::string& text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const std::string state = text.substr(0, slash), number = text.substr(std::min(slash + 1, text.size()));
  const std::vector<std::string> states = bench_state_names();
  int grains = 0;
  std::from_chars(number.data(), number.data() + number.size(), grains);
  if (std::find(states.begin(), states.end(), state) == states.end() || grains < 27)
    throw ConfigurationError(
        fmt::format("scene '{}'; allowed: one of {}, a slash and at least 27 grains, such as rest/1100", text,
                    fmt::join(states, ", ")));
  return {state, grains};
}

PeerScene make_scene(const std::string& text, const std::filesystem::path& output) {
  const auto [name, grains] = scene_words(text);
  BenchState state = bench_state(name, grains);
  PeerScene scene;
  scene.name = state.name;
  scene.sample.assembly = std::move(state.assembly);
  if (state.name == "shear") {
    DemSample sheared(make_engine("native", "/dev/null"), scene.sample.assembly,
                      EngineSettings{scene.sample.material, scene.sample.time_step, 0.0});
    sheared.start_linear_velocity_field(state.shear_rate);
    scene.sample.assembly = sheared.assembly();
  }
  scene.sample.top_velocity = state.shear_rate * scene.sample.assembly.cell.height();
  scene.sample = with_layers_moving(std::move(scene.sample));
  const ContactForces forces =
      evaluate_contact_forces(scene.sample.assembly, scene.sample.material, scene.sample.time_step);
  scene.contacts = forces.contacts.size();
  fmt::print("{} with {} grains: {} mobile grains touch a plane behind a layer; LAMMPS and YADE have no planes.\n",
             scene.name, scene.sample.assembly.size(), forces.plane_contacts.size());
  scene.folder = std::filesystem::absolute(output / fmt::format("{}_{}", scene.name, grains));
  std::filesystem::create_directories(scene.folder);
  write_text(scene.folder / "sample.txt", sample_table(scene.sample));
  return scene;
}

/// The first turn of a code: its input, one run, and its initial state. Throws std::runtime_error if it fails or
/// differs.
PeerRow begin(const PeerScene& scene, const PeerCode& code, const PeerSteps& steps) {
  code.write(scene, steps);
  PeerRow row{&code, {}, {code.run(scene, steps)}};
  row.first = code.first_state(scene);
  const FirstState& s = row.first;
  if (!s.agrees())
    throw std::runtime_error(fmt::format(
        "its initial state has sigma {:.9g} and tau {:.9g} Pa; by its law {:.9g} and {:.9g} Pa are expected; forces or "
        "stresses differ by {:.1e}, allowed: {:.0e}",
        s.found.normal, s.found.shear, s.expected.normal, s.expected.shear, s.error, s.tolerance));
  return row;
}

std::vector<PeerRow> measure(const PeerScene& scene, const std::vector<PeerCode>& codes, const Options& options,
                             const Cores& cores) {
  std::vector<PeerRow> rows;
  const auto steps_of = [&](const PeerCode& code) {
    return steps_for(code, scene.sample.assembly.size(), options.seconds);
  };
  for (const PeerCode& code : codes) {
    cores.use(code.threads);
    try {
      rows.push_back(begin(scene, code, steps_of(code)));
    } catch (const std::runtime_error& error) {
      fmt::print("{} with {} grains, {} is refused: {}\n", scene.name, scene.sample.assembly.size(), code.name,
                 error.what());
    }
  }
  for (int turn = 1; turn < options.turns; ++turn)
    for (PeerRow& row : rows) {
      cores.use(row.code->threads);
      row.speeds.push_back(row.code->run(scene, steps_of(*row.code)));
    }
  cores.use(cores.count());
  return rows;
}

int run(int argc, char** argv) {
  const Options options = read_options(argc, argv);
  for (const std::string& text : options.scenes) scene_words(text);
  const Cores cores;
  std::vector<std::string> left_out;
  std::vector<PeerCode> codes = peer_codes(cores.count(), left_out);
  std::erase_if(codes, [&](const PeerCode& code) {
    return std::find(options.codes.begin(), options.codes.end(), code.name) == options.codes.end();
  });
  for (const std::string& line : left_out) fmt::print("{}.\n", line);
  for (const PeerCode& code : codes)
    if (code.version != "this project") fmt::print("{}: {}\n", code.name, code.version);
  std::string speeds = speed_header(), stresses = stress_header();
  for (const std::string& text : options.scenes) {
    const PeerScene scene = make_scene(text, options.output);
    fmt::print(stderr, "flowslide: {} with {} grains\n", scene.name, scene.sample.assembly.size());
    const std::vector<PeerRow> rows = measure(scene, codes, options, cores);
    speeds += speed_lines(scene, rows);
    stresses += stress_lines(scene, rows);
    std::fflush(stdout);
  }
  fmt::print("\nMedians of {} turns:\n\n{}\nStress of the initial state:\n\n{}", options.turns, speeds, stresses);
  return to_int(ExitCode::ok);
}

}  // namespace
}  // namespace flowslide

int main(int argc, char** argv) {
  flowslide::note_environment();
  return flowslide::run_main([&] { return flowslide::run(argc, argv); }, 0);
}
