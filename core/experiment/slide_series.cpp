// SPDX-License-Identifier: GPL-2.0-or-later
#include "experiment/slide_series.hpp"

namespace flowslide {

Series slide_series() {
  const char* shear = "positive downslope";
  const char* compression = "compression positive";
  Series series;
  series.columns = {
      {"displacement", "x", "m", "sliding distance", shear, {}},
      {"velocity", "v", "m/s", "sliding velocity", shear, {}},
      {"shear_strain", "gamma", "1", "shear strain of the liquefiable layer", shear, {}},
      {"volumetric_strain", "epsilon", "1", "volumetric strain of the layer by drainage", compression, {}},
      {"shear_stress", "tau", "Pa", "resisting shear stress", shear, {}},
      {"normal_stress", "sigma", "Pa", "effective normal stress", compression, {}},
      {"mean_stress", "p", "Pa", "mean stress away from the glued layers, with the kinetic part", compression, {}},
      {"pore_pressure", "p_w", "Pa", "excess pore pressure at the base", "positive above hydrostatic", {}},
      {"driving_stress", "tau_d", "Pa", "driving shear stress", shear, {}},
      {"global_rate", "eps_G", "1/s", "strain rate of the slope", "", {}},
      {"rate_asked", "eps_L^U", "1/s", "strain rate asked for of the sample", "", {}},
      {"rate_applied", "eps_L", "1/s", "strain rate that the sample was last sheared at", "", {}},
      {"inertial_number", "I", "1", "inertial number of the rate applied", "", {}},
      {"global_inertial_number", "I_G", "1", "inertial number of the rate of the slope", "", {}},
      {"void_ratio", "e", "1", "void ratio of the sample", "", {}},
      {"local_time", "t_L", "s", "local clock", "", {}},
      {"local_steps", "n_L", "1", "local time steps so far", "", {}},
  };
  return series;
}

}  // namespace flowslide
