# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 12: pulses of three amplitudes, RD (solid) and RI (dark dashes): (A) velocity, (B) excess pore pressure, (C)
# largest velocity of RD over the amplitude. The paper's claim that RD forgets the amplitude holds if the medians in C
# differ less than the bars are long.
amplitudes = "3 4 5"
slide(scheme, i) = scheme."_".word(amplitudes, i)."kPa"
bands = ""; wide_bands = ""; names = ""
do for [i = 1:3] {
  do for [s in "RD RI"] {
    bands = bands." ".slide(s, i)."_over_displacement.dat"
    wide_bands = wide_bands." ".slide(s, i)."_windows.dat"
    names = names." ".slide(s, i)
  }
}
tables = "legend.txt".bands.wide_bands
command = "./reproduce fig12"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("fig12.gp")]
load here."style.gp"

table(scheme, i) = data(slide(scheme, i)."_over_displacement.dat")
wide(scheme, i) = data(slide(scheme, i)."_windows.dat")
corner = stated(names, "bands and bars: lowest to highest of the samples, lines: median")
least = least_of(wide_bands, "pore_pressure_lowest")   # below 0: suction
lowest = least < 0 ? 5 * floor(kilo * least / 5) : 0
farthest = largest_of(bands." ".wide_bands, "displacement"); far = in_milli(farthest)
fastest = largest_of(bands, "velocity_highest"); fast = in_milli(fastest)
has_largest = readable(path("sweep.dat"))   # tables of older versions lack it
largest(of) = optional(names_in("sweep.dat"), "RD_largest_velocity_".of)
fastest_of_all = has_largest ? largest_of("sweep.dat", "RD_largest_velocity_highest") : NaN
v_max(of) = in_milli(fastest_of_all) * column(largest(of))
by_amplitude(i, value) = abs(kilo * column("amplitude") - word(amplitudes, i)) < 1e-6 ? value : NaN

do for [format in "png pdf"] {
  eval terminal(format, has_largest ? 18 : 14, 7)
  set output picture.".".format
  set multiplot layout 1, (has_largest ? 3 : 2) margins (has_largest ? 0.07 : 0.09), 0.985, 0.18, 0.84 \
    spacing (has_largest ? 0.08 : 0.11) title corner @in_corner
  set xlabel sprintf("sliding distance {/:Italic x} (%s)", milli_unit(farthest, "m"))
  if (far != 1 && farthest > 0) { set xtics few_tics(far * farthest) }
  set xrange [0:*] noextend

  set title panel("A", "sliding velocity")
  set ylabel sprintf("sliding velocity {/:Italic v} (%s)", milli_unit(fastest, "m/s")) offset 1
  set yrange [0:*]
  set offsets 0, 0, graph 0.35, 0   # room for the key
  set key left top Left reverse samplen 3 maxrows 3
  eval frame(bands, "set xrange [0:1]; set yrange [0:1]")
  plot for [s in "RI RD"] for [i = 1:3] table(s, i) \
         using (far * column("displacement")):(fast * column("velocity_lowest")):(fast * column("velocity_highest")) \
         with filledcurves fillstyle transparent solid 0.13 noborder linecolor rgb ordered(i, 3) notitle, \
       for [i = 1:3] table("RD", i) using (far * column("displacement")):(fast * column("velocity_median")) \
         with lines linewidth 2 linecolor rgb ordered(i, 3) title label_of(slide("RD", i)), \
       for [i = 1:3] table("RI", i) using (far * column("displacement")):(fast * column("velocity_median")) \
         with lines linewidth 1.2 @dashes linecolor rgb dark(ordered(i, 3)) notitle, \
       keyentry with lines linewidth 2 linecolor rgb black title "RD", \
       keyentry with lines linewidth 1.2 @dashes linecolor rgb black title "RI"
  set offsets

  set title panel("B", "excess pore pressure")
  set ylabel "excess pore pressure {/:Italic p_w} (kPa)" offset 0
  set yrange [lowest:30]
  unset key
  plot for [s in "RI RD"] for [i = 1:3] wide(s, i) \
         using (far * column("displacement")):(kilo * column("pore_pressure_lowest")): \
         (kilo * column("pore_pressure_highest")) with filledcurves fillstyle transparent solid 0.1 noborder \
         linecolor rgb ordered(i, 3) notitle, \
       for [i = 1:3] wide("RD", i) using (far * column("displacement")):(kilo * column("pore_pressure_median")) \
         with lines linewidth 2 linecolor rgb ordered(i, 3) notitle, \
       for [i = 1:3] wide("RI", i) using (far * column("displacement")):(kilo * column("pore_pressure_median")) \
         with lines linewidth 1.2 @dashes linecolor rgb dark(ordered(i, 3)) notitle

  if (has_largest) {
    set title panel("C", "largest velocity of RD")
    set xlabel "amplitude {/:Italic A} (kPa)"
    set ylabel "{/:Italic v}_{max} (".milli_unit(fastest_of_all, "m/s").")" offset 1
    set xrange [2.5:5.5]; set xtics 1; set yrange [0:*]
    eval frame("sweep.dat", "set yrange [0:1]")
    plot data("sweep.dat") using (kilo * column("amplitude")):(v_max("median")) \
           with lines linewidth 1 linecolor rgb grey notitle, \
         for [i = 1:3] data("sweep.dat") using (by_amplitude(i, kilo * column("amplitude"))):(v_max("median")): \
           (v_max("lowest")):(v_max("highest")) \
           with yerrorbars linewidth 1.4 pointtype 7 pointsize 0.8 linecolor rgb ordered(i, 3) notitle
    set xtics autofreq
  }
  unset multiplot
  set output
}
