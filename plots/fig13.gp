# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 13: runout at several hydraulic conductivities k, RD (solid) and RI (dark dashes). (A) Sliding velocity; thin:
# each sample; thick: the median, as far as more than half of the samples slide. (B) Excess pore pressure: medians of
# means over 1/25 of the distance. (C) Largest velocity over k; grey: the interval of k in which drainage begins to slow
# RI; line: the paper's critical k.
conductivities = "0 5e-6 1e-5 2e-5 4e-5 1e-4"
slide(scheme, i) = scheme."_".word(conductivities, i)
slides = ""; bands = ""; coarse_bands = ""; names = ""
do for [i = 1:6] {
  do for [s in "RD RI"] {
    names = names." ".slide(s, i)
    slides = slides." ".slide(s, i).".dat"
    bands = bands." ".slide(s, i)."_over_displacement.dat"
    coarse_bands = coarse_bands." ".slide(s, i)."_coarse.dat"
  }
}
tables = "sweep.dat critical.dat legend.txt".slides.bands.coarse_bands
command = "./reproduce fig13"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("fig13.gp")]
load here."style.gp"

curves = 6
key_title = "{/:Italic k} (m/s)"
lower = first_of("critical.dat", "lower"); upper = first_of("critical.dat", "upper")
papers = 4e-5                # m/s, the critical k of the paper
tens = 1e5                   # m/s to 1e-5 m/s
axis = "hydraulic_conductivity"; parameter(i) = 1e-5 * word("0 0.5 1 2 4 10", i)   # m/s
last_x = "set xrange [-0.5:10.5]"
on_axis(k) = tens * column(axis)
largest_title = "{/:Italic k} (10^{−5} m/s)"
mark_critical = ""
if (lower == lower) {   # false for NaN: there is no critical k
  mark_critical = sprintf("set object 1 rectangle from first %g, graph 0 to first %g, graph 1 \
    fillcolor rgb grey fillstyle solid 0.25 noborder behind;", tens * lower, tens * upper)
}
mark_critical = mark_critical.sprintf("set arrow 1 from first %g, graph 0 to first %g, graph 1 \
  nohead dashtype 2 linecolor rgb black", tens * papers, tens * papers)
inset = 0   # of no curve
largest_key = "set key at graph 1.05, graph 1.05 right top Right noreverse"
load here."sweep.gp"
