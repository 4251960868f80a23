# Time against largest error; columns evaluator, max_ulp, ns: a point each, its name beside it.
# title Time of one evaluation against its largest error
# description A point for each implementation of the velocities on everyday inputs, both axes
# description logarithmic: slower ones are to the right, less accurate ones above.
# size 800 560
set logscale xy
set xlabel 'time of one evaluation on everyday inputs / ns'
set ylabel 'largest error of a velocity / ulp'
set xrange [2:1e6]
set yrange [0.01:1e6]
set format xy '10^{%T}'
set xtics nomirror
set ytics nomirror
set grid lc rgb '#dddddd'
unset key
plot $data using 3:2 with points pt 7 ps 1 lc rgb 'black', \
     $data every 4::0 using 3:2:1 with labels left rotate by 30 offset 0.6,0.4, \
     $data every 4::1 using 3:2:1 with labels left rotate by -30 offset 0.6,-0.4, \
     $data every ::2::2 using 3:2:1 with labels right rotate by -30 offset -0.6,0.4, \
     $data every ::3::3 using 3:2:1 with labels right rotate by 30 offset -0.6,-0.4, \
     $data every ::6::7 using 3:2:1 with labels left rotate by 30 offset 0.6,0.4
