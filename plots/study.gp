# SPDX-License-Identifier: GPL-2.0-or-later
# The figure of a study of the user's own: (A) stress paths, the first sample of each run; (B) sliding velocity, thin: each
# sample, thick: the median with a band from the lowest to the highest; (C) excess pore pressure, the same without the
# samples; (D) largest velocity over the swept quantity, with the range of the samples; without a sweep the velocity over
# time. Colours follow the value of the swept quantity, dashes the scheme.
tables = "slides.dat sweep.dat legend.txt"
command = "./reproduce study --config FILE"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("study.gp")]
load here."style.gp"

runs = values_of("slides.dat", "slide"); count = words(runs)
schemes = values_of("slides.dat", "scheme")
values = values_of("slides.dat", "value")
several = values_of("slides.dat", "samples") ne "1"
names = names_in("sweep.dat")
swept = rows("sweep.dat") > 0
largest(s, of) = optional(names, s."_largest_velocity_".of)   # missing in tables of older versions, for short runs
place(wanted, list) = sum [i = 1:words(list)] (word(list, i) eq wanted ? i : 0)
of_run(i, name) = asked("values", "-v name=".name." -v key=slide -v is=".shell_quoted(word(runs, i)), "slides.dat")

# Colours in the order of the values, from dark to light.
array anchor[5] = [black, blue, green, orange, vermillion]
part(colour, shift) = (int(colour) >> shift) & 0xFF
blend(a, b, share, shift) = int(part(a, shift) + share * (part(b, shift) - part(a, shift)) + 0.5) << shift
mixed(a, b, share) = blend(a, b, share, 16) + blend(a, b, share, 8) + blend(a, b, share, 0)
along(x) = x >= 4 ? anchor[5] : mixed(anchor[int(x) + 1], anchor[int(x) + 2], x - int(x))
shade(k, n) = along(n < 2 ? 1 : n < 6 ? k - 1 : 4.0 * (k - 1) / (n - 1))
array colour[count + 1]; array dash[count + 1]
path_of(i) = data(word(runs, i).".dat")
over(i, x) = data(word(runs, i)."_over_".x.".dat")
coarse(i) = data(word(runs, i)."_coarse.dat")
farthest = 0; fastest = 0
do for [i = 1:count] {
  colour[i] = swept ? shade(place(of_run(i, "value"), values), words(values)) : shade(i, count)
  dash[i] = swept ? place(of_run(i, "scheme"), schemes) : 1
  if (rows(word(runs, i).".dat") > 0) {
    stats path_of(i) using (column("displacement")) name "X" nooutput
    stats path_of(i) using (column("velocity")) name "V" nooutput
    farthest = X_max > farthest ? X_max : farthest; fastest = V_max > fastest ? V_max : fastest
  }
}
far = in_milli(farthest); far_unit = milli_unit(farthest, "m")
fast = in_milli(fastest); fast_unit = milli_unit(fastest, "m/s")
# Large and small values on the axis of D stand before a power of ten.
axis = label_of("x axis"); bracket = strstrt(axis, "(")
largest_value = 0
if (swept) { stats data("sweep.dat") using (abs(column("as_written"))) name "L" nooutput; largest_value = L_max }
power = largest_value > 0 ? int(floor(log10(largest_value) + 1e-9)) : 0
power = power > 3 || power < -2 ? power : 0
if (power != 0) {
  times = sprintf("10^{%s%d}", power < 0 ? "−" : "", abs(power))
  axis = bracket > 0 ? axis[1:bracket].times." ".axis[bracket + 1:*] : axis." (".times.")"
}
array shape[4] = [7, 5, 9, 11]
corner = changed.label_of("note").(several ? "; thin: each sample; thick: median; bands and bars: lowest to highest" : "")

do for [format in "png pdf"] {
  eval terminal(format, 16, 12.4)
  set output picture.".".format
  set multiplot layout 2, 2 margins 0.095, 0.845, 0.115, 0.92 spacing 0.12, 0.145 title corner @in_corner
  set tics font ",6.5"
  set xlabel "normal stress {/Symbol s} (kPa)"
  set ylabel "shear stress {/Symbol t} (kPa)" offset 1
  set xrange [0:*]; set yrange [*:*]
  unset key
  set title panel("A", "stress path")
  if (count == 0) { set xrange [0:1]; set yrange [0:1]; plot NaN notitle } else {
    plot for [i = 1:count] path_of(i) using (kilo * column("normal_stress")):(kilo * column("shear_stress")) \
           with lines linewidth 0.9 dashtype dash[i] linecolor rgb colour[i] notitle
  }

  set title panel("B", "sliding velocity")
  set xlabel sprintf("sliding distance {/:Italic x} (%s)", far_unit)
  set ylabel sprintf("sliding velocity {/:Italic v} (%s)", fast_unit) offset 1
  set xrange [0:far * (farthest > 0 ? farthest : 1)]; set yrange [0:*]
  set key at screen 0.995, screen 0.45 right top Left reverse title (swept ? (strlen(axis) < 16 ? axis : "") : "scheme") enhanced \
    font ",7" width 0
  if (count == 0 || farthest == 0) { set yrange [0:1]; plot NaN notitle } else {
    plot for [i = 1:count] over(i, "displacement") using (far * column("displacement")): \
           (fast * column("velocity_lowest")):(fast * column("velocity_highest")) \
           with filledcurves linecolor rgb colour[i] notitle, \
         for [i = 1:(several ? count : 0)] for [r = 1:replicates(word(runs, i))] replicate_file(word(runs, i), r) \
           using (far * column("displacement")):(fast * column("velocity")) with lines linewidth 0.4 \
           dashtype dash[i] linecolor rgb colour[i] notitle, \
         for [i = 1:count] over(i, "displacement") using (far * column("displacement")):(fast * column("velocity_median")) \
           with lines linewidth 1.3 dashtype dash[i] linecolor rgb colour[i] notitle, \
         for [i = 1:(count > 24 ? 0 : count)] keyentry with lines linewidth 1.6 \
           dashtype dash[i] linecolor rgb (swept && dash[i] > 1 ? -1 : colour[i]) \
           title (swept && dash[i] > 1 ? "" : label_of(word(runs, i))), \
         for [s = 1:(swept && words(schemes) > 1 ? words(schemes) : 0)] keyentry with lines linewidth 1.2 dashtype s \
           linecolor rgb black title word(schemes, s)
  }

  unset key
  set title panel("C", "excess pore pressure")
  set ylabel "excess pore pressure {/:Italic p_w} (kPa)" offset 0
  set yrange [*:*]
  if (count == 0 || farthest == 0) { set yrange [0:1]; plot NaN notitle } else {
    plot for [i = 1:count] coarse(i) using (far * column("displacement")):(kilo * column("pore_pressure_lowest")): \
           (kilo * column("pore_pressure_highest")) with filledcurves linecolor rgb colour[i] notitle, \
         for [i = 1:count] coarse(i) using (far * column("displacement")):(kilo * column("pore_pressure_median")) \
           with lines linewidth 1.1 dashtype dash[i] linecolor rgb colour[i] notitle
  }

  set xrange [*:*]; set yrange [0:*]
  if (swept) {
    set title panel("D", "largest velocity")
    set xlabel axis enhanced
    set ylabel sprintf("{/:Italic v}_{max} (%s)", fast_unit) offset 1
    set offsets graph 0.06, graph 0.06, graph 0.06, 0
    # The runs of the first scheme stand in the order of the values.
    if (label_of("x texts") eq "yes") {
      set xtics (label_of(word(runs, 1)) 1)
      do for [k = 2:words(values)] { set xtics add (label_of(word(runs, k)) k) }
    }
    first_value = first_of("sweep.dat", "as_written") / 10.0**power
    if (words(values) == 1) { set xrange [first_value - 1:first_value + 1] }
    if (largest(word(schemes, 1), "median") eq "" || fastest == 0) {
      set xrange [0:1]; set yrange [0:1]
      plot NaN notitle
    } else {
      plot for [s = 1:(several ? words(schemes) : 0)] data("sweep.dat") using (column("as_written") / 10.0**power): \
             (fast * column(largest(word(schemes, s), "median"))): \
             (fast * column(largest(word(schemes, s), "lowest"))):(fast * column(largest(word(schemes, s), "highest"))) \
             with yerrorbars linewidth 1.2 pointsize 0 linecolor rgb black notitle, \
           for [s = 1:words(schemes)] data("sweep.dat") using (column("as_written") / 10.0**power): \
             (fast * column(largest(word(schemes, s), "median"))) with linespoints linewidth 1.2 dashtype s \
             pointtype shape[1 + (s - 1) % 4] pointsize 0.6 linecolor rgb black notitle
    }
    set offsets; set xtics autofreq
  } else {
    set title panel("D", "sliding velocity over time")
    set xlabel "time {/:Italic t} (s)"
    set ylabel sprintf("sliding velocity {/:Italic v} (%s)", fast_unit) offset 1
    set yrange [*:*]
    if (count == 0 || farthest == 0) { set xrange [0:1]; set yrange [0:1]; plot NaN notitle } else {
      plot for [i = 1:count] over(i, "time") using (column("time")):(fast * column("velocity_lowest")): \
             (fast * column("velocity_highest")) with filledcurves linecolor rgb colour[i] notitle, \
           for [i = 1:count] over(i, "time") using (column("time")):(fast * column("velocity_median")) \
             with lines linewidth 1.3 dashtype dash[i] linecolor rgb colour[i] notitle
    }
  }
  unset multiplot
  set output
}
