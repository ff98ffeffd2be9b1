// SPDX-License-Identifier: GPL-2.0-or-later
#include "curve_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace flowslide {
namespace {

constexpr double started_from = 1e-3;    ///< strain at which the effect of the sudden start of a fast test has decayed
constexpr double first_window = 0.05;    ///< the first peak lies below this strain
constexpr double liquefied_from = 0.10;  ///< strain well after the liquefaction of the loosest sample
constexpr double regain_from = 0.25;     ///< "when shear strain develops more than 25 %"
constexpr double quasi_static = 1e-3;    ///< up to this inertial number shear is nearly quasi-static
constexpr double carries_stress = 0.01;  ///< a sample with sigma/sigma_0 above this value is not liquefied

class Record {
 public:
  Record(const Series& series, double scale) : series_(series), scale_(scale) {}

  std::size_t rows() const { return series_.rows(); }
  double at(const char* column, std::size_t row) const { return series_.column(column).values[row]; }
  double strain(std::size_t row) const { return at("shear_strain", row); }
  double final_strain() const { return strain(rows() - 1); }
  double scale() const { return scale_; }

  /// Calls visit(row) for all rows with a strain in [from, to].
  void each(double from, double to, const std::function<void(std::size_t)>& visit) const {
    for (std::size_t row = 0; row < rows(); ++row)
      if (strain(row) >= from && strain(row) <= to) visit(row);
  }
  double largest(const char* column, double from, double to) const {
    double value = -std::numeric_limits<double>::infinity();
    each(from, to, [&](std::size_t row) { value = std::max(value, at(column, row)); });
    return value;
  }
  double smallest(const char* column, double from, double to) const {
    double value = std::numeric_limits<double>::infinity();
    each(from, to, [&](std::size_t row) { value = std::min(value, at(column, row)); });
    return value;
  }
  /// Mean over strain by the trapezoidal rule, because rows are not evenly spaced.
  double mean(const char* column, double from, double to) const {
    double sum = 0.0, width = 0.0;
    for (std::size_t row = 1; row < rows(); ++row) {
      if (strain(row - 1) < from || strain(row) > to) continue;
      const double step = strain(row) - strain(row - 1);
      sum += 0.5 * (at(column, row) + at(column, row - 1)) * step;
      width += step;
    }
    return sum / width;
  }

 private:
  const Series& series_;
  double scale_;
};

/// Adds the metrics of liquefaction and of the regain of strength.
void add_liquefaction(std::vector<Metric>& metrics, const Record& record) {
  const double end = record.final_strain();
  if (end < regain_from) return;
  metrics.push_back({"mean_liquefied_normal", record.mean("normal_stress", liquefied_from, end) / record.scale(), "1",
                     "mean normal stress beyond 10 % strain over sigma_0"});
  metrics.push_back({"mean_liquefied_shear", record.mean("shear_stress", liquefied_from, end) / record.scale(), "1",
                     "mean shear stress beyond 10 % strain over sigma_0"});
  const double lowest = record.smallest("normal_stress", 0.0, regain_from);
  metrics.push_back(
      {"lowest_normal", lowest / record.scale(), "1", "lowest normal stress up to 25 % strain over sigma_0"});
  metrics.push_back({"regained_shear", record.largest("shear_stress", regain_from, end) / record.scale(), "1",
                     "largest shear stress beyond 25 % strain over sigma_0"});
  double low_strain = 0.0;
  record.each(0.0, regain_from, [&](std::size_t row) {
    if (record.at("normal_stress", row) == lowest) low_strain = record.strain(row);
  });
  metrics.push_back({"regain_over_peak",
                     record.largest("shear_stress", low_strain, end) /
                         record.largest("shear_stress", 0.0, std::min(low_strain, first_window)),
                     "1", "largest shear stress after the lowest normal stress over the first peak"});
}

void add_rates(std::vector<Metric>& metrics, const Record& record, double strain_at_peak) {
  metrics.push_back({"initial_inertial_number", record.at("inertial_number", 0), "1", "inertial number at the start"});
  double fast_from = std::numeric_limits<double>::infinity(), largest = 0.0, kinetic = 0.0;
  for (std::size_t row = 0; row < record.rows(); ++row) {
    const double number = record.at("inertial_number", row), normal = record.at("normal_stress", row);
    largest = std::max(largest, number);
    if (number > quasi_static) fast_from = std::min(fast_from, record.strain(row));
    const double share = record.at("kinetic_normal_stress", row) / normal;
    if (normal > carries_stress * record.scale()) kinetic = std::max(kinetic, share);
  }
  metrics.push_back({"largest_inertial_number", largest, "1", "largest inertial number of the test"});
  metrics.push_back({"strain_when_not_quasi_static_over_peak", fast_from / strain_at_peak, "1",
                     "first strain at which the inertial number exceeds 1e-3, over that at the peak"});
  metrics.push_back({"kinetic_share", kinetic, "1",
                     "largest kinetic over contact normal stress while the sample bears 1 % of sigma_0"});
}

/// Adds the largest difference between the stresses of Bagi and Nicot, relative to the largest shear stress: after the
/// start of the test, and during it.
void add_formulas(std::vector<Metric>& metrics, const Record& record) {
  const double largest = record.largest("bagi_shear_stress", 0.0, record.final_strain());
  const auto apart = [&](double from, double to) {
    double difference = 0.0;
    record.each(from, to, [&](std::size_t row) {
      for (const char* component : {"shear_stress", "normal_stress"})
        difference = std::max(difference, std::abs(record.at((std::string("bagi_") + component).c_str(), row) -
                                                   record.at((std::string("nicot_") + component).c_str(), row)));
    });
    return difference / largest;
  };
  metrics.push_back(
      {"bagi_nicot_difference", apart(started_from, record.final_strain()), "1",
       "largest difference of Bagi's and Nicot's stress beyond 0.1 % strain over the largest shear stress"});
  metrics.push_back({"bagi_nicot_difference_at_start", apart(0.0, started_from), "1",
                     "this difference up to 0.1 % strain, where torques are not in balance yet"});
}

}  // namespace

std::vector<Metric> curve_metrics(const Series& series, const StressPeak& peak, double initial_normal_stress) {
  const Record record(series, initial_normal_stress);
  std::vector<Metric> metrics{{"peak_shear_stress", peak.stress, "Pa", "largest shear stress up to 5 % strain"},
                              {"strain_at_peak", peak.strain, "1", "shear strain at that stress"}};
  add_liquefaction(metrics, record);
  add_rates(metrics, record, peak.strain);
  add_formulas(metrics, record);
  // Ratios and means without data are not finite. A result accepts finite metrics only.
  std::erase_if(metrics, [](const Metric& metric) { return !std::isfinite(metric.value); });
  return metrics;
}

}  // namespace flowslide
