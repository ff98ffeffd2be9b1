// SPDX-License-Identifier: GPL-2.0-or-later
#include "sweep/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "record/result_file.hpp"
#include "support/process.hpp"

namespace flowslide {
namespace {

namespace fs = std::filesystem;

std::string content_of_file(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Runs a program in `room` and writes its output to `said`.
int run(const Words& words, const fs::path& room, std::string& said) {
  Process process(words, room / "said");
  const int code = process.wait();
  said = process.said();
  return code;
}

bool is_closed_form(const std::string& engine) { return engine == "elastic" || engine == "critical_state"; }

/// The last words of a program.
std::string end_of(const std::string& said) {
  constexpr std::size_t most = 600;
  return said.size() > most ? "..." + said.substr(said.size() - most) : said;
}

/// What a dry run prints, without the remarks before it.
std::string plan_in(const std::string& said) {
  return said.substr(std::min(said.find("# resolved configuration"), said.size()));
}

/// The part of a plan that shows the settings.
std::string configuration_in(const std::string& plan) { return plan.substr(0, plan.find("\n# run ")); }

std::vector<std::string> points_in(const std::string& dry_run) {
  constexpr std::string_view start = "\n# run ";
  std::vector<std::string> points;
  for (std::size_t at = dry_run.find(start); at != std::string::npos; at = dry_run.find(start, at + 1))
    points.push_back(dry_run.substr(at + start.size(), dry_run.find(':', at) - at - start.size()));
  return points;
}

/// One study in a room of its own.
class Study {
 public:
  Study(const CaseUnderTest& of, Dice dice, fs::path room)
      : case_(of), dice_(dice), room_(std::move(room)), output_(room_ / "out put") {
    fs::create_directories(room_);
    engine_ = dice_.one_of(case_.engines);
    if (case_.has_sweeps || dice_.one_in(20)) return;  // the whole case
    for (std::size_t i = 0, count = 1 + dice_.below(2); i < count; ++i) chosen_.insert(dice_.one_of(case_.points));
  }

  void check() {
    draw_valid_changes();
    const bool ran = run_it();
    if (!ran) return;
    repeat_it();
    change_it();
    collect_it();
    draw_it();
  }

  std::string text() const {
    std::string text = fmt::format("{} --engine {}", case_.name, engine_);
    for (const std::string& point : chosen_) text += " --point " + point;
    for (const Setting& change : changes_) text += " --set '" + change.text() + "'";
    return text;
  }

 private:
  int call(const Words& more, const std::vector<Setting>& changes) {
    Words words{case_.program, "--engine", engine_, "--output", output_};
    for (const std::string& point : chosen_) words.insert(words.end(), {"--point", point});
    for (const Setting& change : changes) words.insert(words.end(), {"--set", change.text()});
    words.insert(words.end(), more.begin(), more.end());
    const int code = run(words, room_, said_);
    if (code != 0 && said_.find("flowslide: ") == std::string::npos && code != 4)
      throw StudyFailure(fmt::format("ended with {} without a message: {}", code, end_of(said_)));
    return code;
  }
  void expect(bool holds, const std::string& what) const {
    if (!holds) throw StudyFailure(fmt::format("{}; it said: {}", what, end_of(said_)));
  }
  /// A whole case is judged at its end, single points are not: 4 says that a claim is not met.
  void expect_judged(int code, bool run = true) const {
    expect(code == 0 || (code == 4 && (chosen_.empty() || !run)), fmt::format("ended with {}", code));
  }
  fs::path result(const std::string& point) const { return output_ / (point + ".h5"); }

  /// Changes that the program accepts: 2 is its answer to others.
  bool valid(const std::vector<Setting>& changes) {
    const int code = call({"--dry-run"}, changes);
    expect(code == 0 || code == 2, fmt::format("--dry-run ended with {}", code));
    return code == 0;
  }
  void draw_valid_changes() {
    do {
      changes_ = own_changes();
      table_.clear();
      if (dice_.one_in(4)) use_a_table();
    } while (!valid(changes_));
    plan_ = plan_in(said_);
    points_ = points_in(plan_);
  }
  /// Changes without a table: of a study of the user's own, its sweep, and on grains no others.
  std::vector<Setting> own_changes() {
    if (!case_.has_sweeps) return random_changes(case_.settings, dice_);
    const bool of_grains = !is_closed_form(engine_);
    std::vector<Setting> changes = random_sweep(of_grains, engine_, dice_);
    if (of_grains) return changes;
    for (const Setting& change : random_changes(case_.settings, dice_))
      if (!has_key(changes, change.key)) changes.push_back(change);
    return changes;
  }
  static bool has_key(const std::vector<Setting>& settings, const std::string& key) {
    return std::ranges::find(settings, key, &Setting::key) != settings.end();
  }
  void use_a_table() {
    const fs::path file = room_ / "loading table.dat";
    std::ofstream(file) << "0 0\n0.1 " << 100 * dice_.below(50) << "\n0.5 " << 100 * dice_.below(50) << "\n";
    std::erase_if(changes_, [](const Setting& change) { return change.key.starts_with("loading."); });
    changes_.push_back({"loading.history", "\"table\""});
    changes_.push_back({"loading.file", '"' + file.string() + '"'});
    table_ = file;
  }

  /// False if the numbers broke: a diagnosis, and no result.
  bool run_it() {
    const int code = call({}, changes_);
    if (code == 3) {
      bool complete = true;
      for (const std::string& point : points_) complete = complete && fs::exists(result(point));
      expect(!complete, "a numerical failure left all results");
      return false;
    }
    expect_judged(code);
    for (const std::string& point : points_) check_result(point);
    check_sweep();
    return true;
  }
  void check_result(const std::string& point) {
    expect(fs::exists(result(point)), "no result of " + point);
    const Result there = read_result(result(point));
    expect(there.series.rows() > 0, "no rows in the result of " + point);
    const auto stored = settings_in(there.configuration), planned = settings_in(plan_);
    for (const Setting& setting : planned) {
      // A run of a study has only the keys that its own scheme and value of the sweep read.
      if (case_.has_sweeps && !has_key(stored, setting.key)) continue;
      const auto same = [&](const Setting& other) { return other.text() == setting.text(); };
      expect(std::any_of(stored.begin(), stored.end(), same), "the result lacks " + setting.text());
    }
    expect(fs::exists(output_ / (point + ".dat")), "no table of " + point);
  }
  /// The values of a sweep are different runs, and their replicates have one configuration. Each planned setting is
  /// that of a run.
  void check_sweep() {
    if (!case_.has_sweeps) return;
    std::set<std::string> names, configurations;
    std::vector<Setting> stored;
    for (const std::string& point : points_) {
      names.insert(point.ends_with("_r2") ? point.substr(0, point.size() - 3) : point);
      const std::string configuration = read_result(result(point)).configuration;
      if (!configurations.insert(configuration).second) continue;
      for (const Setting& setting : settings_in(configuration)) stored.push_back(setting);
    }
    expect(names.size() == configurations.size(), "the values of the sweep are not one run each");
    for (const Setting& setting : settings_in(plan_))
      expect(is_of_all_runs(setting.key) || has_key(stored, setting.key), "no run has " + setting.text());
  }
  void repeat_it() {
    const std::string before = content_of_file(result(points_.front()));
    expect_judged(call({}, changes_));
    for (const std::string& point : points_)
      expect(said_.find(point + ": the result exists") != std::string::npos, point + " was run again");
    expect(content_of_file(result(points_.front())) == before, "a repetition changed the result");
  }
  void change_it() {
    const std::string before = content_of_file(result(points_.front()));
    // A point may have a loading of its own, which stands in front of the table.
    if (!table_.empty() && !read_result(result(points_.front())).inputs.empty()) {
      const std::string rows = content_of_file(table_);
      std::ofstream(table_, std::ios::app) << "0.9 77\n";
      refuse(changes_, "an edited loading table");
      std::ofstream(table_) << rows;
    }
    std::vector<Setting> others;
    do {
      others = changes_;
      const Setting& setting = dice_.one_of(case_.settings);
      if (has_key(others, setting.key) || (case_.has_sweeps && is_of_all_runs(setting.key))) continue;
      if (const std::string value = changed_value(setting.value, dice_); !value.empty() && value != setting.value)
        others.push_back({setting.key, value});
      // A key that this engine does not read leaves the plan unchanged.
    } while (others.size() == changes_.size() || !valid(others) ||
             configuration_in(plan_in(said_)) == configuration_in(plan_));
    refuse(others, others.back().text());
    expect(content_of_file(result(points_.front())) == before, "a refused run changed the result");
  }
  void refuse(const std::vector<Setting>& changes, const std::string& what) {
    for (const Words& action : {Words{}, Words{"--check"}})
      expect(call(action, changes) == 2,
             fmt::format("{} was not refused {}", what, action.empty() ? "" : "by --check"));
  }
  void collect_it() {
    for (const char* action : {"--check", "--status", "--so-far"}) {
      const int code = call({action}, changes_);
      if (std::string(action) == "--check") expect_judged(code, false);
      else expect(code == 0, fmt::format("{} ended with {}", action, code));
    }
    for (const std::string& point : points_)
      expect(fs::exists(output_ / "so_far" / (point + ".h5")), "--so-far left out " + point);
  }
  /// Of a whole case, every figure; of single points, a figure or the word that tables are missing.
  void draw_it() {
    const auto& [figure, script] = dice_.one_of(case_.figures);
    const int code = run({"gnuplot", "-c", script, output_, output_ / figure}, room_, said_);
    const bool refused = code == 2 && said_.find("Make it with: ./reproduce") != std::string::npos;
    expect(code == 0 || (refused && !chosen_.empty()), fmt::format("{} was not drawn ({})", figure, code));
    expect(said_.find("undefined") == std::string::npos && said_.find("warning") == std::string::npos,
           figure + " was drawn with complaints");
    for (const char* end : {".png", ".pdf"}) {
      const fs::path picture = output_ / (figure + end);
      const bool there = fs::exists(picture) && fs::file_size(picture) > 1000;
      expect(there == !refused, picture.filename().string() + (refused ? " was drawn of missing tables" : " is empty"));
    }
  }

  const CaseUnderTest& case_;
  Dice dice_;
  fs::path room_, output_, table_;
  std::string engine_, said_, plan_;
  std::set<std::string> chosen_;     ///< by --point; empty: all
  std::vector<std::string> points_;  ///< of the study
  std::vector<Setting> changes_;
};

}  // namespace

CaseUnderTest case_in(const std::string& name, const fs::path& build, const fs::path& source, const fs::path& room) {
  CaseUnderTest found{name, build / "cases" / name / name, {"elastic", "critical_state"}, name == "study",
                      {},   {},                            {}};
  std::string said;
  if (run({found.program, "--engine", "elastic", "--list"}, room, said) != 0) throw StudyFailure(name + ": " + said);
  for (std::size_t at = said.find('\n') + 1; at < said.size(); at = said.find('\n', at) + 1)
    found.points.push_back(said.substr(at, said.find('\t', at) - at));
  if (run({found.program, "--engine", "elastic", "--dry-run"}, room, said) != 0) throw StudyFailure(name + ": " + said);
  found.settings = settings_in(plan_in(said));
  if (found.has_sweeps)
    for (const char* engine : {"native", "native-mixed", "liggghts", "liggghts-stock"})
      if (run({found.program, "--engine", engine, "--dry-run"}, room, said) == 0) found.engines.emplace_back(engine);
  std::ifstream table(source / "plots" / "figures.txt");
  for (std::string line; std::getline(table, line);) {
    std::istringstream words(line);
    std::string figure, of, script;
    if (words >> figure >> of >> script && of == name && script != "-")
      found.figures.emplace_back(figure, source / "plots" / script);
  }
  return found;
}

StudyOutcome check_study(const CaseUnderTest& of, Dice dice, const fs::path& room) {
  Study study(of, dice, room);
  try {
    study.check();
  } catch (const std::exception& failure) {
    return {study.text(), failure.what()};
  }
  return {study.text(), ""};
}

}  // namespace flowslide
