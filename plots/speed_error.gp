# SPDX-License-Identifier: GPL-2.0-or-later
# Speed against error for (A) the element test, (B) the trigger and (C) the pulse: time of a setting on one core over
# its largest error, relative to the spread over seeds. Grey: errors below this spread. Line: settings for which no
# other is both faster and more accurate. Open marks: other samples and RI, which do not compete. Dashed: LIGGGHTS at
# the paper's settings.
tables = "paper.dat"
do for [s in "element trigger pulse"] { tables = tables." errors_".s.".dat ".s."_front.dat" }
command = "./reproduce speed_error"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("speed_error.gp")]
load here."style.gp"
errors = "errors_element.dat errors_trigger.dat errors_pulse.dat"
fronts = "element_front.dat trigger_front.dat pulse_front.dat"

array scene[3] = ["element", "trigger", "pulse"]
array title[3] = ["element test", "trigger", "pulse"]
# What a setting changes: as in the tables, and in words.
settings = 17
array axis_names[settings] = ["dt_L", "strain_rate", "engine,_precision", "E", "rolling", "all", "dt_G", "n_accum", \
                              "eq._18,_17", "stress_every_n-th", "hybrid", "N", "RI:_floor", "RI:_I", "RI:_rest", \
                              "adaptive_dt_L", "RI:_adaptive_dt_L"]
array shown[settings] = ["time step of the grains", "strain rate", "engine or precision", "stiffness of the grains", \
  "no rolling resistance", "fast settings together", "time step of the slope", "steps per exchange", \
  "eq. 17 or eq. 18 as printed", "stress at every n-th exchange", "hybrid rate", "number of grains", "RI: least rate", \
  "RI: inertial number", "RI: liquefied sand at rest", "adaptive time step", \
  "RI: adaptive time step"]
array colour[settings] = [blue, vermillion, green, purple, orange, black, sky, purple, orange, grey, vermillion, \
                          black, blue, green, vermillion, sky, purple]
array symbol[settings] = [7, 5, 9, 11, 13, 3, 5, 7, 9, 11, 13, 4, 6, 8, 10, 13, 12]
seconds_of(i) = strcol("axis") eq axis_names[i] ? column("seconds") : NaN
paper(s) = first_where("paper.dat", "seconds", "scene", scene[s])
least_error = 5e-5; largest_error = 100.0
present(s) = rows(word(errors, s)) > 0
corner = stated("", "one mark a setting, over all its samples")

do for [format in "png pdf"] {
  eval terminal(format, 18, 10.8)
  set output picture.".".format
  set multiplot layout 1, 3 margins 0.085, 0.985, 0.42, 0.895 spacing 0.07 title corner @in_corner
  set logscale xy
  set format xy "10^{%T}"
  set xlabel "time on one core (s)"
  unset key
  do for [s = 1:3] {
    set title panel(word("A B C", s), title[s])
    set ylabel (s == 1 ? "largest error / spread over seeds" : "") offset 0.5
    set xrange [(s == 3 ? 1 : 0.03):(paper(s) > 0 ? 3 * paper(s) : 1e4)]
    set yrange [least_error:largest_error]
    set xtics 100
    set object 1 rectangle from graph 0, first least_error to graph 1, first 1 \
      fillcolor rgb grey fillstyle solid 0.2 noborder behind
    if (paper(s) > 0) {
      set arrow 1 from first paper(s), graph 0 to first paper(s), graph 1 nohead dashtype 2 linecolor rgb black
      set label 1 "LIGGGHTS, paper's settings" at first paper(s), graph 0.98 right rotate by 90 offset -1.3, 0 \
        font ",7"
    }
    if (present(s)) {
      plot for [k = 1:settings] data(word(errors, s)) using (seconds_of(k)):(column("error_over_spread")) \
             with points pointtype symbol[k] pointsize 1 linecolor rgb colour[k] notitle, \
           data(word(fronts, s)) using (column("seconds")):(column("error_over_spread")) \
             with lines linewidth 0.8 linecolor rgb black notitle
    } else {   # no run of this scene has a result
      plot data(word(fronts, s)) using (NaN):(NaN) notitle
    }
    unset object 1; unset arrow 1; unset label 1
  }
  # The key of all panels.
  unset logscale; set format xy "% h"; set xtics autofreq
  set lmargin at screen 0.02; set rmargin at screen 0.98; set bmargin at screen 0; set tmargin at screen 1
  set title ""; unset xlabel; unset ylabel; unset border; unset tics
  set xrange [0:1]; set yrange [0:1]
  set key at screen 0.04, screen 0.275 left top Left reverse vertical maxrows 6 samplen 1 width 1
  plot 2 notitle, \
       for [k = 1:settings] keyentry with points pointtype symbol[k] pointsize 1 linecolor rgb colour[k] title shown[k], \
       keyentry with lines linewidth 0.8 linecolor rgb black title "none faster and better"
  unset lmargin; unset rmargin; unset bmargin; unset tmargin
  set border 3; set tics nomirror out scale 0.6
  unset multiplot
  set output
}
