// SPDX-License-Identifier: GPL-2.0-or-later
// What a case that slides makes of results: here with results that are made up, in place of runs.
#include "program/slide_case.hpp"

#include "configuration/error.hpp"
#include "program/slide_case_text.hpp"
#include "record/gnuplot_table.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

namespace fs = std::filesystem;

class ResultsCase : public SlideCase {
 public:
  ResultsCase() : SlideCase({"results", "Slides", "1", {}, {}}) {}
  using SlideCase::slide_names;

 protected:
  std::vector<Metric> slide_metrics(const SlideOutcome&) const override { return {}; }
  void compare(const Ensembles& slides, std::map<std::string, double>& metrics) const override {
    for (const auto& [name, ensemble] : slides) metrics["compared." + name] = static_cast<double>(ensemble.size());
    metrics["nothing"] = std::nan("");
  }
  std::vector<std::string> abscissas() const override { return {"displacement"}; }
};

class SlideResults : public testing::Test {
 protected:
  SlideResults() { scratch_.write("case.toml", slide_and_test_text()); }
  /// The case with a user's file, on an engine.
  ResultsCase read(const std::string& engine, const std::string& user = "") {
    ResultsCase the_case;
    Layers layers{scratch_.path() / "case.toml", "quick", {}, {{"engine", engine, "--engine"}}};
    if (!user.empty()) layers.user_file = scratch_.write("user.toml", user);
    the_case.read(Configuration(layers));
    return the_case;
  }
  void write(const std::string& point, int replicate, const std::string& sample, const Series& empty) {
    Result result;
    result.provenance.point = point;
    result.provenance.replicate = replicate;
    result.provenance.sample = sample;
    result.metrics = {{"peak", 1.0 + replicate, "Pa", ""}};
    result.series = empty;
    for (int row = 0; row <= 4; ++row)
      result.series.append_row(row, std::vector<double>(empty.columns.size(), 0.5 * row));
    write_result(output_.file(point + ".h5"), result, IfExists::replace);
  }
  ScratchFolder scratch_;
  OutputFolder output_ = OutputFolder::open(scratch_.path() / "out", "results");
};

TEST_F(SlideResults, CompareTheSlidesOfTheCaseAlone) {
  const std::string own = "[point.RD_mine]\nlike = 'RD'\n";
  const ResultsCase the_case = read("native", own);
  write("RD", 0, "loose a", slide_series());
  write("RD_r2", 1, "loose b", slide_series());
  write("RD_mine", 0, "loose a", slide_series());
  const auto metrics = the_case.metrics(output_.path(), {"RD", "RD_r2", "RD_mine"});
  EXPECT_EQ(metrics.at("compared.RD"), 2.0);
  EXPECT_FALSE(metrics.contains("compared.RD_mine"));  // no claim of the paper is about it
  EXPECT_EQ(metrics.at("RD_mine.peak"), 1.0);
  EXPECT_EQ(metrics.at("RD.peak.median"), 1.5);
  EXPECT_FALSE(metrics.contains("nothing"));
}

TEST_F(SlideResults, RefuseReplicatesThatAreOneSample) {
  write("RD", 0, "loose a", slide_series());
  write("RI_r2", 1, "loose a", slide_series());
  const ResultsCase the_case = read("native");
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { the_case.finish(output_); }), "are no replicates");
}

TEST_F(SlideResults, LeaveOutAbscissasThatATestDoesNotHave) {
  write("alone", 0, "loose a", shear_test_series());
  write("RD", 0, "loose a", slide_series());
  read("native").finish(output_);
  EXPECT_TRUE(fs::exists(output_.file("RD_over_displacement.dat")));
  EXPECT_FALSE(fs::exists(output_.file("alone_over_displacement.dat")));
}

TEST_F(SlideResults, HaveTablesWithoutRowsForWhatAClosedFormSampleDoesNotHave) {
  const ResultsCase the_case = read("elastic", "point.RD.profile_strains = [0.1]\n");
  the_case.finish(output_);
  const Series alone = read_table(output_.file("alone.dat")).series;
  EXPECT_EQ(alone.rows(), 0U);
  EXPECT_TRUE(alone.has("shear_stress"));
  EXPECT_TRUE(fs::exists(output_.file("RD_profiles_band.dat")));
  EXPECT_EQ(the_case.slide_names(), (std::vector<std::string>{"alone", "RD", "RI"}));
}

TEST_F(SlideResults, HaveTablesWithoutRowsForWhatLiggghtsCannotShear) {
  const std::string across_faces = "[sample.loose]\nperiodic_height = true\n";
  EXPECT_FALSE(read("native", across_faces).points().empty());
  const ResultsCase the_case = read("liggghts", across_faces);
  EXPECT_EQ(the_case.points().size(), 0U);
  the_case.finish(output_);
  EXPECT_TRUE(read_table(output_.file("RD.dat")).series.has("displacement"));
}

TEST_F(SlideResults, NameTheirTables) {
  const std::vector<std::string> tables = read("native").tables();
  for (const char* name : {"RD_over_displacement", "RI_profiles_band", "alone_over_displacement"})
    EXPECT_NE(std::find(tables.begin(), tables.end(), name), tables.end()) << name;
}

}  // namespace
}  // namespace flowslide
