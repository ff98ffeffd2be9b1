// SPDX-License-Identifier: GPL-2.0-or-later
// A case of slides and an element test on 150 grains or a closed-form sample, as a program to be stopped and killed.
// It reads $RESTARTABLE_CASE/case.toml.
#include <cstdlib>

#include "program/case_program.hpp"
#include "program/slide_case.hpp"

namespace flowslide {
namespace {

class Restartable : public SlideCase {
 public:
  Restartable() : SlideCase({"restartable", "Slides to be stopped", "1", {"Fig. 12"}, {}}) {}

 protected:
  std::vector<Metric> slide_metrics(const SlideOutcome& outcome) const override {
    const Series& rows = outcome.series;
    return {{"last_shear_stress", rows.column("shear_stress").values.back(), "Pa", "tau of the last row"},
            {"rows", static_cast<double>(rows.rows()), "1", "number of rows"},
            {"profiles", static_cast<double>(outcome.profiles.columns.size()), "1", "columns of profiles"}};
  }
  void compare(const Ensembles&, std::map<std::string, double>&) const override {}
  std::vector<std::string> abscissas() const override { return {"time"}; }
};

}  // namespace
}  // namespace flowslide

int main(int argc, char** argv) {
  const char* folder = std::getenv("RESTARTABLE_CASE");
  if (folder == nullptr) return 2;
  flowslide::Restartable the_case;
  return flowslide::run_case(the_case, argc, argv, folder);
}
