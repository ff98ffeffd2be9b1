// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/case_program.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "claims/claims.hpp"
#include "configuration/error.hpp"
#include "input/remarks.hpp"
#include "input/vocabulary.hpp"
#include "process/exit_code.hpp"
#include "process/mpi_session.hpp"
#include "process/ranks.hpp"
#include "program/changed_settings.hpp"
#include "program/file_names.hpp"
#include "program/metrics_table.hpp"
#include "program/run_list.hpp"
#include "program/run_main.hpp"
#include "program/versions.hpp"
#include "record/atomic_file.hpp"
#include "record/hash.hpp"
#include "record/result_file.hpp"
#include "run/begin_point.hpp"
#include "run/cost.hpp"
#include "run/preliminary_results.hpp"
#include "run/status.hpp"
#include "sample/closed_form.hpp"

namespace flowslide {
namespace {

class CaseProgram {
 public:
  CaseProgram(Case& the_case, const CommandLine& options, const std::filesystem::path& folder,
              std::span<const char* const> arguments)
      : case_(the_case),
        options_(options),
        arguments_(arguments),
        configuration_(layers_of(options, folder / "case.toml")) {
    describe_vocabulary(configuration_);
    case_.read(configuration_);
    configuration_.reject_unknown();
    points_ = case_.points();
    refuse_names_that_meet(points_, case_.tables());
    if (const std::filesystem::path claims = folder / "claims.toml"; std::filesystem::exists(claims)) {
      claims_ = load_claims(claims);
      changed_ = changed_settings(configuration_);
    }
    for (const std::string& name : selected_points(options_, names(points_))) chosen_.insert(name);
  }

  int run() {
    if (!options_.check && !options_.status && !options_.so_far && options_.points.empty()) say_remarks();
    if (options_.list) return list();
    if (options_.dry_run) return plan();
    if (options_.check) return check();
    if (options_.prepare) return prepare();
    if (options_.status) return status();
    if (options_.so_far) return write_preliminary_results();
    warn_of_idle_ranks();
    RunControl control({options_.checkpoint_interval, options_.max_walltime});
    for (const Point& point : points_)
      if (chosen_.contains(point.name)) run_point(point, control);
    // With --point, other programs may run the other points. Whoever starts them evaluates the claims with --check.
    return options_.points.empty() ? check() : to_int(ExitCode::ok);
  }

 private:
  std::string engine() const { return configuration_.text("engine", case_.description().engines); }

  /// Not with --point, where other programs run the other runs of the case and would repeat the remarks.
  void say_remarks() const {
    if (!first_rank()) return;
    for (const std::string& remark : remarks_on(configuration_, engine()))
      std::cerr << fmt::format("flowslide: {}\n", remark);
  }

  void warn_of_idle_ranks() const {
    const std::string engine = this->engine();
    if (mpi_ranks() > 1 && first_rank() && !engine.starts_with("liggghts"))
      std::cerr << fmt::format("flowslide: with --engine {} each of the {} ranks does the whole work; only liggghts "
                               "divides the work\n", engine, mpi_ranks());
  }

  static std::vector<std::string> names(const std::vector<Point>& points) {
    std::vector<std::string> all;
    all.reserve(points.size());
    for (const Point& point : points) all.push_back(point.name);
    return all;
  }
  bool first_rank() const { return mpi_rank() == 0; }

  int list() const {
    if (!first_rank()) return to_int(ExitCode::ok);
    if (!changed_.empty() && !options_.json)
      std::cerr << fmt::format("flowslide: settings differ from those of the case: {}; its claims are not evaluated\n",
                               fmt::join(changed_, "; "));
    nlohmann::ordered_json all;
    all["points"] = nlohmann::ordered_json::array();
    std::string text = "# name\tseconds\tdescription\n";
    for (const Point& point : points_) {
      if (!chosen_.contains(point.name)) continue;
      text += fmt::format("{}\t{:.0f}\t{}\n", point.name, point.predicted_seconds, point.description);
      all["points"].push_back({{"name", point.name},
                               {"figures", point.figures},
                               {"predicted_seconds", std::round(10.0 * point.predicted_seconds) / 10.0},
                               {"sample", point.sample},
                               {"figure_only", claims_.is_figure_only(point.name)},
                               {"description", point.description}});
    }
    all["claims"] = nlohmann::ordered_json::array();
    for (const Claim& claim : claims_at(claims_.claims, options_.scale)) all["claims"].push_back(claim.id);
    if (!changed_.empty()) all["changed"] = changed_;
    // Paths need not be UTF-8.
    const auto written = [&] { return all.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n"; };
    std::cout << (options_.json ? written() : text);
    return to_int(ExitCode::ok);
  }

  int plan() const {
    std::ostream nowhere(nullptr);
    std::ostream& out = first_rank() ? std::cout : nowhere;
    out << "# resolved configuration, hash " << hash_of(configuration_.resolved()) << "\n"
        << "# quantities are in quotes with their SI unit; a key with a bare number takes bare numbers only\n"
        << "# the comment after each value names the line or the option that sets it\n";
    for (const std::string& setting : changed_) out << "# changed: " << setting << "\n";
    out << configuration_.resolved_with_origins();
    print_inherited(out);
    for (const Point& point : points_) {
      if (!chosen_.contains(point.name)) continue;
      out << fmt::format("\n# run {}: {}; predicted {} on one core\n", point.name, point.description,
                         prediction_text(point.predicted_seconds));
      case_.print_plan(point, out);
    }
    return to_int(ExitCode::ok);
  }

  /// Prints the values that samples take from other samples, as comments: the text is still a configuration.
  void print_inherited(std::ostream& out) const {
    const std::string text = configuration_.inherited_with_origins("sample");
    for (std::string_view rest = text; !rest.empty(); rest.remove_prefix(rest.find('\n') + 1))
      out << "# " << rest.substr(0, rest.find('\n') + 1);
  }

  int prepare() const {
    RunControl control({options_.checkpoint_interval, options_.max_walltime});
    const auto poll = [&](const std::function<bool()>& keep) { control.poll_in_preparation(keep); };
    std::set<std::string> prepared{""};
    for (const Point& point : points_)
      if (chosen_.contains(point.name) && prepared.insert(point.sample).second)
        case_.prepare(point, options_.threads, ProgressStyle::of_stderr(mpi_rank()), poll);
    return to_int(ExitCode::ok);
  }

  int status() const {
    if (!first_rank()) return to_int(ExitCode::ok);
    const OutputFolder output = OutputFolder::open_existing(options_.output, case_.description().name);
    std::vector<PointStatus> all;
    for (const Point& point : points_)
      if (chosen_.contains(point.name)) all.push_back(status_of(output, point.name, identity_of(point)));
    std::cout << (options_.json ? status_json(all) : status_table(all));
    return to_int(ExitCode::ok);
  }

  int write_preliminary_results() const {
    if (!first_rank()) return to_int(ExitCode::ok);
    const std::string& name = case_.description().name;
    const OutputFolder output = OutputFolder::open_existing(options_.output, name);
    // Another name keeps --check and further runs away from results that are not complete.
    const OutputFolder copy = OutputFolder::open(output.file("so_far"), name + ", unfinished (--so-far)");
    std::map<std::string, RunIdentity> chosen;
    for (const Point& point : points_) {
      if (chosen_.contains(point.name))
        chosen.emplace(point.name, identity_of(point));
      else
        copy.remove_point(point.name);  // an earlier call with another choice may have written it
    }
    std::cerr << copy_preliminary_results(output, copy, chosen);
    finish(copy);
    std::cout << copy.path().string() << "\n";
    return to_int(ExitCode::ok);
  }

  RunIdentity identity_of(const Point& point) const {
    const std::string configuration = point.configuration.empty() ? configuration_.resolved() : point.configuration;
    return {case_.description().name, point.name, point.inputs, configuration, versions_of(point.inputs)};
  }

  /// Writes the tables of the figures, runs.dat with the runs that they show, and changes.txt with the settings that
  /// differ from those of the case.
  void finish(const OutputFolder& output) const {
    case_.finish(output);
    std::vector<Point> shown;
    for (const Point& point : points_)
      if (output.has_result(point.name)) shown.push_back(point);
    write_atomically(output.file("runs.dat"), run_list(shown, options_.scale));
    const std::filesystem::path changes = output.file("changes.txt");
    std::filesystem::remove(changes);
    if (!changed_.empty()) write_atomically(changes, fmt::format("{}\n", fmt::join(changed_, "\n")));
  }

  void run_point(const Point& point, RunControl& control) {
    if (control.poll() == RunControl::Due::stop) control.stop(fmt::format("{} was not begun", point.name));
    const std::string& case_name = case_.description().name;
    const RunIdentity identity = identity_of(point);
    std::optional<OutputFolder> output;
    std::optional<BegunPoint> begun;  // holds the lock until the run ends
    on_first_rank([&] {
      if (options_.resume) OutputFolder::open_existing(options_.output, case_name);
      output.emplace(OutputFolder::open(options_.output, case_name));
      begun.emplace(begin_point(*output, point.name, identity, options_.afresh));
    });
    if (!output) output.emplace(OutputFolder::open_existing(options_.output, case_name));
    if (same_on_all_ranks(begun && begun->complete)) {
      if (first_rank())
        std::cerr << fmt::format("{}: the result exists, with this configuration (code {:.7}); not run again\n",
                                 point.name, read_result(output->file(point.name + ".h5")).provenance.git_revision);
      return;
    }
    PointCheckpoints checkpoints(output->checkpoints(point.name), control, identity);
    const PointRun run{*output,          provenance_of(point), identity, ProgressStyle::of_stderr(mpi_rank()),
                       options_.threads, checkpoints};
    try {
      case_.run(point, run);
    } catch (const CorruptFileError&) {
      throw;
    } catch (const FileError& error) {  // such as a full disk
      const bool kept = !output->checkpoints(point.name).empty();
      throw FileError(error.what() + std::string(kept ? "; the same command continues from its last checkpoint" : ""));
    }
    on_first_rank([&] { output->checkpoints(point.name).remove(); });
  }

  /// The provenance of a run of this point that starts now. Seed, replicate and sample are left to the case.
  Provenance provenance_of(const Point& point) const {
    Provenance provenance = start_provenance(arguments_);
    provenance.mpi_ranks = mpi_ranks();
    provenance.case_name = case_.description().name;
    provenance.point = point.name;
    provenance.scale = options_.scale;
    provenance.predicted_seconds = point.predicted_seconds;
    provenance.engine = point.inputs.engine;
    if (!point.inputs.engine.empty()) provenance.engine_version = engine_version(point.inputs.engine);
    for (const std::string& figure : point.figures)
      provenance.figure += (provenance.figure.empty() ? "" : ", ") + figure;
    return provenance;
  }

  int check() const {
    if (!first_rank()) return to_int(ExitCode::ok);
    OutputFolder output = OutputFolder::open_existing(options_.output, case_.description().name);
    const std::vector<std::string> present = results_in(output);
    if (present.size() < chosen_.size())
      std::cerr << fmt::format("flowslide: {} of {} runs have no result; tables and claims are of the others\n",
                               chosen_.size() - present.size(), chosen_.size());
    finish(output);
    const auto metrics = case_.metrics(output.path(), present);
    write_atomically(output.file("metrics.dat"), metrics_table(metrics));
    std::vector<Provenance> origins;
    origins.reserve(present.size());
    for (const std::string& point : present) origins.push_back(read_result(output.file(point + ".h5")).provenance);
    write_atomically(output.file("cost.json"), cost_json(cost_of(origins)));
    std::vector<Claim> claims = claims_at(claims_.claims, options_.scale);
    if (!options_.points.empty()) std::erase_if(claims, [&](const Claim& claim) { return !concerns(claim); });
    std::vector<Verdict> verdicts = evaluate(claims, metrics);
    if (const std::string reason = reason_not_to_evaluate(); !reason.empty())
      verdicts = not_evaluated(verdicts, reason);
    if (verdicts.empty()) {
      for (const char* name : {"claims.md", "claims.json"}) std::filesystem::remove(output.file(name));
      if (options_.json) std::cout << json(verdicts);
      return to_int(ExitCode::ok);
    }
    write_atomically(output.file("claims.md"), markdown_table(verdicts));
    write_atomically(output.file("claims.json"), json(verdicts));
    std::cout << (options_.json ? json(verdicts) : terminal_table(verdicts) + cost_text(cost_of(origins)) + "\n");
    return to_int(is_one_not_met(verdicts) ? ExitCode::claim_not_met : ExitCode::ok);
  }

  /// Why the claims are about other runs than these; empty if they are about these.
  std::string reason_not_to_evaluate() const {
    std::vector<std::string> reasons;
    if (is_closed_form(engine()))
      reasons.push_back(
          fmt::format("the claims are about samples of grains, and engine = \"{}\" has no grains", engine()));
    if (!changed_.empty()) reasons.push_back(fmt::format("not the paper's settings: {}", fmt::join(changed_, "; ")));
    return fmt::format("{}", fmt::join(reasons, "; "));
  }

  /// The chosen points that have a complete result. Throws if a chosen point has a damaged result or the result of
  /// another run. Such a result of another point is only left out of the tables that finish() writes.
  std::vector<std::string> results_in(OutputFolder& output) const {
    std::vector<std::string> present;
    for (const Point& point : points_) {
      const auto file = output.file(point.name + OutputFolder::result_end);
      const FoundResult found = find_result(file, identity_of(point));
      const bool chosen = chosen_.contains(point.name);
      if (found.standing == Standing::complete && chosen) present.push_back(point.name);
      if (found.standing != Standing::damaged && found.standing != Standing::other) continue;
      const std::string problem =
          found.standing == Standing::damaged
              ? found.problem
              : fmt::format("{} is the result of another run ({})", file.string(), found.problem);
      if (chosen && found.standing == Standing::damaged) throw CorruptFileError(problem);
      if (chosen) throw ConfigurationError(fmt::format("{}; {}", problem, begin_anew));
      std::cerr << fmt::format("flowslide: {}; it is left out\n", problem);
      output.leave_out(point.name);
    }
    return present;
  }

  /// Whether a claim is about one of the chosen points, or about a figure that shows one of them. Every claim is, if
  /// all points are chosen.
  bool concerns(const Claim& claim) const {
    if (chosen_.size() == points_.size()) return true;
    const std::set<std::string> figures = figures_in(claim.figure);
    return std::any_of(points_.begin(), points_.end(), [&](const Point& point) {
      return chosen_.contains(point.name) &&
             (claim.metric.starts_with(point.name + ".") ||
              std::any_of(point.figures.begin(), point.figures.end(),
                          [&](const std::string& figure) { return figures.contains(figure); }));
    });
  }

  Case& case_;
  const CommandLine& options_;
  std::span<const char* const> arguments_;
  Configuration configuration_;
  std::vector<Point> points_;
  ClaimsFile claims_;                 ///< of claims.toml; empty without this file
  std::vector<std::string> changed_;  ///< see changed_settings; empty without claims.toml
  std::set<std::string> chosen_;
};

}  // namespace

int run_case(Case& the_case, int argc, const char* const* argv, const std::filesystem::path& folder) {
  const auto program = [&] {
    const CommandLine options = parse(argc, argv, the_case.description());
    return CaseProgram(the_case, options, folder, {argv, static_cast<std::size_t>(argc)}).run();
  };
  std::string unsaid;
  const int code = run_main(program, mpi_rank(), &unsaid);
  return same_exit_code(code, unsaid);
}

}  // namespace flowslide
