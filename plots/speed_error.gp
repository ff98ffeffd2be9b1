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
array axis_names[15] = ["dt_L", "strain_rate", "engine,_precision", "E", "rolling", "all", "dt_G", "n_accum", \
                        "eq._18,_17", "stress_every_n-th", "hybrid", "N", "RI:_floor", "RI:_I", "RI:_rest"]
array shown[15] = ["dt_L", "strain rate", "engine", "E", "rolling", "all at once", "dt_G", "n_{accum}", "eqs 17, 18", \
                   "stress", "hybrid", "N", "RI: floor", "RI: I", "RI: rest"]
array colour[15] = [blue, vermillion, green, purple, orange, black, sky, purple, orange, grey, vermillion, \
                    black, blue, green, vermillion]
array symbol[15] = [7, 5, 9, 11, 13, 3, 5, 7, 9, 11, 13, 4, 6, 8, 10]
array axes_of[3] = [values_of("errors_element.dat", "axis"), values_of("errors_trigger.dat", "axis"), \
                    values_of("errors_pulse.dat", "axis")]
has(s, i) = strstrt(" ".axes_of[s]." ", " ".axis_names[i]." ") > 0
seconds_of(i) = strcol("axis") eq axis_names[i] ? column("seconds") : NaN
paper(s) = first_where("paper.dat", "seconds", "scene", scene[s])
least_error = 1e-3; largest_error = 100.0

set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
do for [format in "png pdf"] {
  eval terminal(format, 18, 10.5)
  set output picture.".".format
  set multiplot layout 1, 3
  set bmargin 11.5   # the same for all panels, whatever the length of their keys
  set xlabel "time on one core (s)"
  do for [s = 1:3] {
    set title panel(word("A B C", s), title[s])
    set ylabel (s == 1 ? "largest error over spread over seeds" : "") offset 1
    set xrange [(s == 3 ? 1 : 0.03):(paper(s) > 0 ? 3 * paper(s) : 1e4)]
    set yrange [least_error:largest_error]
    set key below center Left reverse maxcols 2
    set object 1 rectangle from graph 0, first least_error to graph 1, first 1 \
      fillcolor rgb grey fillstyle solid 0.2 noborder behind
    if (paper(s) > 0) {
      set arrow 1 from first paper(s), graph 0 to first paper(s), graph 1 nohead dashtype 2 linecolor rgb black
      set label 1 "LIGGGHTS, paper's settings" at first paper(s), graph 0.98 right rotate by 90 offset -1.3, 0 \
        font ",7"
    }
    present = ""
    do for [i = 1:15] { if (has(s, i)) { present = present." ".i } }
    if (present eq "") {   # no run of this scene has a result
      plot data(word(fronts, s)) using (NaN):(NaN) notitle
    } else {
      plot for [k in present] data(word(errors, s)) using (seconds_of(k + 0)):(column("error_over_spread")) \
             with points pointtype symbol[k + 0] pointsize 0.9 linecolor rgb colour[k + 0] title shown[k + 0], \
           data(word(fronts, s)) using (column("seconds")):(column("error_over_spread")) \
             with lines linewidth 0.8 linecolor rgb black notitle
    }
    unset object 1; unset arrow 1; unset label 1
  }
  unset multiplot
  set output
}
