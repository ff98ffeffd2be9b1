// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <optional>
#include <string>

#include "experiment/ensemble.hpp"

namespace flowslide {

/// The sample is fully liquefied once sigma falls below this fraction of its initial value.
inline constexpr double liquefied_share = 0.01;

/// The first row at which sigma is below liquefied_share of its value in the first row; none without such a row.
std::optional<std::size_t> liquefied_row(const Series& series);

/// Shear strain of that row; NaN without such a row.
double liquefaction_strain(const Series& series);

/// The lines of peaks.dat above its rows: the states that Fig. 8 marks.
std::string marked_states_head();

/// A row of peaks.dat: name of the slide; the state at the peak of tau; the state at full liquefaction (see
/// liquefied_row), NaN if the slide does not liquefy. The velocity and the inertial number at the peak are those of the
/// row next to its time. Empty if there is no peak.
std::string marked_states_row(const std::string& slide, const Result& result);

}  // namespace flowslide
