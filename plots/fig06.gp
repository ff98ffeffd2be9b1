# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 6: a slope coupled by eq. 15 to a sample of given inertial number, with dt_G from 1e-3 to 1e-6 s, beside an
# element test of the sample.
command = "./reproduce fig06"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("fig06.gp")]
ways = "RI"
array way_label[1] = ["eq. 15"]
load here."convergence.gp"
