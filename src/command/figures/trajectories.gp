# Places of A, C and B against time, three panels, a row a collision; columns panel, t, x_A, x_C,
# x_B.
# title Trajectories of A, B and C
# description Three panels, place over time: A from below and B above (solid), C between them
# description (dashed). (a) At the magic ratio alpha_3 A and C stop and B leaves with all. (b) At
# description alpha = 0.12 all go on moving after three collisions each. (c) At alpha = 0.10 A meets
# description C a fourth time.
# size 600 900
set xrange [-1:5]
set yrange [-1.3:5.3]
set ytics 1 nomirror
set xtics 1 nomirror
set ylabel 'x / L' offset 1
set grid lc rgb '#dddddd'
set lmargin 7
unset key
set label 2 'A' at -0.5,-0.95
set label 3 'C' at -0.85,0.4
set label 4 'B' at -0.85,1.45
set multiplot layout 3,1
panels = 'a b c'
names = "'(a) α = α_3' '(b) α = 0.12' '(c) α = 0.10'"
do for [i=1:3] {
  set label 1 word(names, i) at graph 0.03,0.9
  if (i == 3) { set xlabel 't / (L/V)' } else { unset xlabel }
  plot $data using 2:(strcol(1) eq word(panels, i) ? $5 : NaN) with lines lw 3 lc rgb '#0072b2', \
       $data using 2:(strcol(1) eq word(panels, i) ? $4 : NaN) with lines \
            lw 3 dt (6,4) lc rgb '#d55e00', \
       $data using 2:(strcol(1) eq word(panels, i) ? $3 : NaN) with lines lw 3 lc rgb 'black'
}
unset multiplot
