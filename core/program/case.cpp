// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/case.hpp"

#include <utility>

namespace flowslide {

Provenance PointRun::provenance_now() const {
  Provenance now = provenance;
  now.processor_seconds = provenance.mpi_ranks * static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
  // NaN for a checkpoint of an older version, which did not record its processor time; the sum is then NaN too.
  if (const auto& kept = checkpoints.found())
    now.processor_seconds += kept->partial_result.provenance.processor_seconds;
  return now;
}

Result PointRun::result(Series series, std::vector<Metric> metrics) const {
  Result result;
  result.provenance = provenance_now();
  identity.stamp(result);
  result.series = std::move(series);
  result.metrics = std::move(metrics);
  return result;
}

}  // namespace flowslide
