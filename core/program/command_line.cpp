// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "configuration/error.hpp"
#include "configuration/nearest.hpp"
#include "process/exit_code.hpp"

namespace flowslide {
namespace {

const std::vector<std::string> scale_names{"quick", "paper"};

constexpr std::size_t most_listed = 24;  ///< a message lists at most this number of names

/// A check that accepts only one of `names`, and proposes the nearest one.
auto one_of(const std::vector<std::string>& names) {
  return [names](const std::string& text) -> std::string {
    if (std::find(names.begin(), names.end(), text) != names.end()) return "";
    if (names.size() > most_listed)
      return fmt::format("\"{}\" does not exist; {}", text, did_you_mean(text, names, "see --list"));
    return fmt::format("\"{}\" does not exist; it must be {}; {}", text, list_of(names),
                       did_you_mean(text, names, "choose one of these"));
  };
}

/// A check that accepts only an integer from `least` to `most`.
auto integer_from(std::int64_t least, std::int64_t most) {
  return [least, most](const std::string& text) -> std::string {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc{} && end == text.data() + text.size() && value >= least && value <= most)
      return "";
    return fmt::format("\"{}\" is not allowed; it must be an integer from {} to {}", text, least, most);
  };
}

std::string key_and_value(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals != std::string::npos && equals > 0 && text[0] != '-') return "";
  return fmt::format("\"{}\" is not KEY=VALUE; write, for example, slope.angle=\"6 deg\"", text);
}

/// The options as CLI11 reads them. `fill` turns them into a CommandLine.
struct Raw {
  std::vector<std::string> settings;
  std::int64_t seed = 0;
  std::int64_t replicates = 1;
  std::string engine;
  std::string configuration_file;
  std::string output;
  bool allow_unstable = false;
  std::string checkpoint_interval, max_walltime;
};

constexpr std::int64_t most_threads = 1024, most_seed = 1000000000, most_replicates = 100;

void add_run_options(CLI::App& app, Raw& raw, CommandLine& command_line, const CaseDescription& description) {
  const std::string group = "What to run";
  app.add_option("--config", raw.configuration_file, "TOML file whose values replace those of the case's case.toml")
      ->type_name("FILE")
      ->group(group);
  app.add_option("--set", raw.settings,
                 "Set one value of the configuration, such as slope.angle=\"6 deg\". A quantity needs its unit. May be "
                 "repeated. --dry-run prints all keys")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false)
      ->check(CLI::Validator(key_and_value, ""))
      ->group(group);
  app.add_option("--scale", command_line.scale, "Size of the runs: quick (default) or paper")
      ->type_name("SCALE")
      ->check(CLI::Validator(one_of(scale_names), ""))
      ->group(group);
  app.add_option("--engine", raw.engine,
                 fmt::format("Engine that moves the grains: {}; default: the key `engine`",
                             fmt::join(description.engines, ", ")))
      ->type_name("NAME")
      ->check(CLI::Validator(one_of(description.engines), ""))
      ->group(group);
  app.add_option("--seed", raw.seed, "Seed of the first replicate, at least 0; default: the key `seed`")
      ->type_name("N")
      ->check(CLI::Validator(integer_from(0, most_seed), ""))
      ->group(group);
  app.add_option("--replicates", raw.replicates, "Number of replicates, at least 1; default: the key `replicates`")
      ->type_name("N")
      ->check(CLI::Validator(integer_from(1, most_replicates), ""))
      ->group(group);
  app.add_flag("--allow-unstable", raw.allow_unstable,
               "Also run slides with dt_G above the limit of stability; sets the key `coupling.allow_unstable`")
      ->group(group);
  app.add_option("--point", command_line.points,
                 "Execute only this run of the case. May be repeated; see --list")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->group(group);
  app.add_option("--output", raw.output,
                 fmt::format("Folder of the results; default: results/{}/SCALE", description.name))
      ->type_name("DIR")
      ->group(group);
}

void add_long_run_options(CLI::App& app, Raw& raw, CommandLine& command_line) {
  const std::string group = "Long runs";
  app.add_flag("--resume", command_line.resume,
               "Require that the folder of results exists. With and without this option, runs continue from their "
               "checkpoints; runs without a checkpoint start from the beginning")
      ->group(group);
  app.add_flag(
         "--afresh", command_line.afresh,
         "Start the runs again: first delete their checkpoints, and results that are damaged or of another run "
         "(other settings, input files or engine). Without this option such results are an error. Complete results of "
         "this run are kept")
      ->excludes("--resume")
      ->group(group);
  app.add_option("--threads", command_line.threads,
                 "Number of threads of the native engines; it does not change results. Default: one below 10 000 "
                 "grains, otherwise one per core. LIGGGHTS uses MPI ranks instead: mpirun -np N")
      ->type_name("N")
      ->check(CLI::Validator(integer_from(1, most_threads), ""))
      ->group(group);
  app.add_option("--checkpoint-interval", raw.checkpoint_interval,
                 "Wall time between two checkpoints, such as \"30 s\"; default: 3 min")
      ->type_name("TIME")
      ->group(group);
  app.add_option("--max-walltime", raw.max_walltime,
                 "Write a checkpoint and end with exit code 75 before this wall time since the start of the program, "
                 "such as \"24 h\"")
      ->type_name("TIME")
      ->group(group);
}

void add_other_options(CLI::App& app, CommandLine& command_line) {
  const std::string group = "Instead of a run";
  app.add_flag("--dry-run", command_line.dry_run,
               "Print the resolved configuration, the commands to the engine, the steps and the predicted time. Write "
               "nothing")
      ->group(group);
  app.add_flag("--list", command_line.list, "Print the runs with their predicted time")->group(group);
  app.add_flag("--check", command_line.check,
               "Collect the complete runs in --output: write the tables of the figures and evaluate the claims")
      ->group(group);
  app.add_flag("--prepare", command_line.prepare,
               "Prepare the samples of the runs and store them in the cache. Without this step, a run prepares its "
               "own sample")
      ->group(group);
  app.add_flag("--status", command_line.status,
               "Print the state and the progress of the runs in --output: complete, running, stopped or not begun")
      ->group(group);
  app.add_flag("--so-far", command_line.so_far,
               "Write preliminary results to the folder so_far in --output: complete runs, and other runs up to "
               "their last checkpoint. Plot them like complete results. Running programs are not disturbed")
      ->group(group);
  app.add_flag("--json", command_line.json, "Machine-readable output of --list, --status or --check")->group(group);
}

std::string footer(const std::string& name) {
  return fmt::format(
      "\nExamples:\n"
      "  {0}                                         run the whole case at quick scale\n"
      "  {0} --list                                  print its runs and their predicted time\n"
      "  {0} --scale paper --dry-run                 print the plan at the size of the paper\n"
      "  {0} --set slope.angle=\"6 deg\" --output results/6_deg   run with one changed value\n"
      "\nExit codes:\n"
      "  0 ok, 1 standard output cannot be written, 2 configuration, 3 numerical failure, 4 a claim is not met,\n"
      "  70 a defect of the program: please report it, 75 stopped but resumable, 130 interrupted\n",
      name);
}

[[noreturn]] void refuse(const CLI::ParseError& error, const CLI::App& app, const CaseDescription& description) {
  std::string hint;
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) names.push_back(option->get_name());
    const std::vector<std::string> unknown = app.remaining();
    if (!unknown.empty()) {
      const std::string name = unknown.front().substr(0, unknown.front().find('='));
      if (const std::string text = did_you_mean(name, names, ""); !text.empty()) hint = " (" + text + ")";
    }
  }
  throw ConfigurationError(fmt::format("{}{}; see {} --help", error.what(), hint, description.name));
}

/// The time of an option, s, > 0; `unset` if the option was not given. The message about a missing unit proposes
/// `likely_unit`.
double time_in(const std::string& text, const char* option, std::string_view likely_unit, double unset) {
  if (text.empty()) return unset;
  try {
    if (const double time = parse_quantity(text, dimension::time, likely_unit); time > 0.0) return time;
  } catch (const std::invalid_argument& error) {
    throw ConfigurationError(fmt::format("{}: {}", option, error.what()));
  }
  throw ConfigurationError(fmt::format("{}: \"{}\" is not above 0; write, for example, {} \"90 min\"", option, text,
                                       option));
}

void fill(CommandLine& command_line, const Raw& raw, const CLI::App& app, const CaseDescription& description) {
  const auto given = [&app](const char* name) { return app.count(name) > 0; };
  for (const std::string& setting : raw.settings) {
    const std::size_t equals = setting.find('=');
    command_line.overrides.push_back({setting.substr(0, equals), setting.substr(equals + 1), "--set " + setting});
  }
  if (given("--config")) command_line.configuration_file = raw.configuration_file;
  if (given("--engine"))
    command_line.overrides.push_back({"engine", fmt::format("\"{}\"", raw.engine), "--engine " + raw.engine});
  const auto number = [&](const char* key, std::int64_t value) {
    if (given(fmt::format("--{}", key).c_str()))
      command_line.overrides.push_back({key, fmt::format("{}", value), fmt::format("--{} {}", key, value)});
  };
  number("seed", raw.seed);
  number("replicates", raw.replicates);
  if (raw.allow_unstable) command_line.overrides.push_back({"coupling.allow_unstable", "true", "--allow-unstable"});
  if (given("--output") && raw.output.empty()) throw ConfigurationError("--output: the path is empty; name a folder");
  command_line.output = given("--output") ? std::filesystem::path(raw.output)
                                          : std::filesystem::path("results") / description.name / command_line.scale;
  command_line.checkpoint_interval = time_in(raw.checkpoint_interval, "--checkpoint-interval", "min", 180.0);
  command_line.max_walltime = time_in(raw.max_walltime, "--max-walltime", "h", std::numeric_limits<double>::infinity());
  const int others = command_line.status + command_line.so_far + command_line.prepare;
  if (command_line.dry_run + command_line.list + command_line.check + others > 1) {
    throw ConfigurationError(
        fmt::format("--dry-run, --list, --check, --prepare, --status and --so-far exclude each other: give one; see {} "
                    "--help",
                    description.name));
  }
  if (command_line.json && !command_line.list && !command_line.check && !command_line.status)
    throw ConfigurationError(fmt::format("--json needs --list, --status or --check; see {} --help", description.name));
}

}  // namespace

CommandLine parse(int argc, const char* const* argv, const CaseDescription& description) {
  CommandLine command_line;
  Raw raw;
  const std::string figures =
      description.figures.empty() ? "" : fmt::format("\nFigures: {}.", fmt::join(description.figures, ", "));
  CLI::App app(description.description + figures, description.name);
  app.set_help_flag("--help,-h", "Print this help and end")->group("About");
  app.set_version_flag("--version", fmt::format("{} {}", description.name, description.version),
                       "Print the version and end")
      ->group("About");
  app.footer(footer(description.name));
  add_run_options(app, raw, command_line, description);
  add_long_run_options(app, raw, command_line);
  add_other_options(app, command_line);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    throw FinishedEarly(app.help());
  } catch (const CLI::CallForVersion& version) {
    throw FinishedEarly(std::string(version.what()) + "\n");
  } catch (const CLI::ParseError& error) {
    refuse(error, app, description);
  }
  fill(command_line, raw, app, description);
  return command_line;
}

Layers layers_of(const CommandLine& command_line, const std::filesystem::path& case_file) {
  return {case_file, command_line.scale, command_line.configuration_file, command_line.overrides};
}

std::vector<std::string> selected_points(const CommandLine& command_line, const std::vector<std::string>& available) {
  if (command_line.points.empty()) return available;
  for (const std::string& point : command_line.points) {
    if (const std::string problem = one_of(available)(point); !problem.empty())
      throw ConfigurationError("--point: " + problem);
  }
  std::vector<std::string> chosen;
  for (const std::string& point : available)
    if (std::find(command_line.points.begin(), command_line.points.end(), point) != command_line.points.end())
      chosen.push_back(point);
  return chosen;
}

}  // namespace flowslide
