// SPDX-License-Identifier: GPL-2.0-or-later
// Samples that stand in for DEM where grains do not matter, from their tables of a configuration.
#pragma once
#include <memory>
#include <string>

#include "configuration/configuration.hpp"
#include "sample/sample.hpp"
#include "slope/statics.hpp"

namespace flowslide {

/// The sample of that name, in balance with the slope (eqs 8 and 9). [elastic]: shear_modulus, oedometric_modulus,
/// viscosity, void_ratio. [critical_state]: the fields of CriticalStateProperties by their names, but for the stresses
/// and the substep. Throws ConfigurationError, also if tau_0 exceeds the strength.
std::unique_ptr<Sample> read_closed_form_sample(const Configuration& configuration, const std::string& name,
                                                const SlopeProperties& slope);

}  // namespace flowslide
