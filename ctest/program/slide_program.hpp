// SPDX-License-Identifier: GPL-2.0-or-later
// A case that slides, as a whole program in a scratch folder.
#pragma once
#include <stdlib.h>

#include <cmath>
#include <stdexcept>

#include "program/case_program.hpp"
#include "program/slide_case.hpp"
#include "program/slide_case_text.hpp"
#include "support/messages.hpp"

namespace flowslide {

class TestCase : public SlideCase {
 public:
  TestCase() : SlideCase({"test_case", "A slide", "1", {"Fig. 12"}, {}}) {}

 protected:
  std::vector<Metric> slide_metrics(const SlideOutcome& outcome) const override {
    if (metrics_fail) throw std::out_of_range("no column of that name");
    return {{"distance", outcome.series.last("displacement"), "m", "sliding distance"},
            {"peak", outcome.measures.peak_to_2.stress, "Pa", "largest shear stress"},
            {"mean_velocity", mean_over(outcome.measures.over_time, "velocity", 0.0, 1.0), "m/s", "mean velocity"},
            {"nothing", std::nan(""), "1", "never there"},
            {"profiles", static_cast<double>(outcome.profiles.columns.size()), "1", "columns of profiles"},
            {"replicate", static_cast<double>(outcome.point.replicate), "1", "number of the replicate"}};
  }
  void compare(const Ensembles& slides, std::map<std::string, double>& metrics) const override {
    metrics["slides"] = static_cast<double>(slides.size());
  }
  std::vector<std::string> abscissas() const override { return {"time", "displacement"}; }

 public:
  bool metrics_fail = false;
};

class SlideProgram : public testing::Test {
 protected:
  SlideProgram() {
    ::setenv("FLOWSLIDE_CACHE", (scratch_.path() / "cache").c_str(), 1);
    scratch_.write("case.toml", slide_case_text() + "[scale.quick]\n");
    scratch_.write("claims.toml", R"([[claim]]
id = "all_there"
figure = "Fig. 12"
sentence = "There are slides."
metric = "slides"
relation = ">"
threshold = 0
unit = "1"
origin = "published"
)");
  }
  ~SlideProgram() override { ::unsetenv("FLOWSLIDE_CACHE"); }

  int run(std::vector<std::string> options) {
    options.insert(options.end(), {"--output", output().string()});
    std::vector<const char*> words{"test_case"};
    for (const std::string& option : options) words.push_back(option.c_str());
    TestCase the_case;
    the_case.metrics_fail = metrics_fail_;
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = run_case(the_case, static_cast<int>(words.size()), words.data(), scratch_.path());
    text_ = testing::internal::GetCapturedStdout();
    error_ = testing::internal::GetCapturedStderr();
    return code;
  }
  std::filesystem::path output() const { return scratch_.path() / "out"; }

  ScratchFolder scratch_;
  std::string text_, error_;
  bool metrics_fail_ = false;
};

}  // namespace flowslide
