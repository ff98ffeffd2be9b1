# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 7: like Figure 6, coupled by eq. 18 as printed, by eq. 18 with its remainder carried, and by eq. 17; and their
# errors over dt_G.
command = "./reproduce fig07"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("fig07.gp")]
ways = "reset carry variable"
array way_label[3] = ["eq. 18 as printed", "eq. 18, remainder carried", "eq. 17"]
load here."convergence.gp"
