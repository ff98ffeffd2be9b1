// SPDX-License-Identifier: GPL-2.0-or-later
// Reads the closed-form samples from their tables of a configuration. They replace DEM where grains do not matter.
#pragma once
#include <memory>
#include <string>

#include "configuration/configuration.hpp"
#include "sample/sample.hpp"
#include "slope/statics.hpp"

namespace flowslide {

/// The sample `name`, under the initial stresses of the slope (eqs 8 and 9). Keys of [elastic]: shear_modulus,
/// oedometric_modulus, viscosity, void_ratio. Keys of [critical_state]: the members of CriticalStateProperties by their
/// names, except the stresses and the substep. Throws ConfigurationError, also if the properties are not valid or if
/// tau_0 exceeds the strength of the sample.
std::unique_ptr<Sample> read_closed_form_sample(const Configuration& configuration, const std::string& name,
                                                const SlopeProperties& slope);

}  // namespace flowslide
