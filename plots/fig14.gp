# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 14: runout on samples of four void ratios, RD (solid) and RI (dark dashes). (A) Sliding velocity; thin: each
# sample; thick: the median, as far as more than half of the samples slide; inset: the densest samples. (B) Excess pore
# pressure: medians of means over 1/25 of the distance. (C) Largest velocity over the void ratio of our samples.
void_ratios = "790 771 765 751"   # loose to dense
slide(scheme, i) = scheme."_e0_".word(void_ratios, i)
slides = ""; bands = ""; coarse_bands = ""; names = ""
do for [i = 1:4] {
  do for [s in "RD RI"] {
    names = names." ".slide(s, i)
    slides = slides." ".slide(s, i).".dat"
    bands = bands." ".slide(s, i)."_over_displacement.dat"
    coarse_bands = coarse_bands." ".slide(s, i)."_coarse.dat"
  }
}
tables = "sweep.dat legend.txt".slides.bands.coarse_bands
command = "./reproduce fig14"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("fig14.gp")]
load here."style.gp"

curves = 4
key_title = "paper's {/:Italic e}_0"
void_ratio = optional(names_in("sweep.dat"), "RD_initial_void_ratio_median")
axis = "paper_void_ratio"; parameter(i) = 1e-3 * word(void_ratios, i)
on_axis(k) = column(void_ratio)
# Without values, or with one void ratio only (a closed-form sample), there is no range.
least_e = least_of("sweep.dat", "RD_initial_void_ratio_median")
largest_e = largest_of("sweep.dat", "RD_initial_void_ratio_median")
margin = largest_e - least_e > 1e-6 ? 0.15 * (largest_e - least_e) : 0.05
last_x = least_e == least_e ? sprintf("set xrange [%g:%g]; set xtics (%.3f, %.3f); set format x '%%.3f'", \
  least_e - margin, largest_e + margin, least_e, largest_e) : \
  "set xrange [0.7:0.9]"
largest_title = "our {/:Italic e}_0"
mark_critical = ""
inset = 4
largest_key = "set key at graph 0, graph 1.05 left top Left reverse"
load here."sweep.gp"
