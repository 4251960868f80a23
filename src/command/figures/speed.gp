# Time against largest error; columns evaluator, max_ulp, ns: a point each, its name beside it.
# title Time of one evaluation against its largest error
# description A point for each implementation of the velocities on everyday inputs, both axes
# description logarithmic: slower ones are to the right, less accurate ones above.
# size 560 420
set logscale xy
set xlabel 'time of one evaluation on everyday inputs / ns'
set ylabel 'largest error of a velocity / ulp'
set xrange [0.5:2e6]
set yrange [0.01:1e6]
set format xy '10^{%T}'
set xtics nomirror
set ytics nomirror
set grid lc rgb '#dddddd'
unset key
is(names, name) = strstrt(names, '|' . name . '|') > 0
y(names) = is(names, strcol(1)) ? column(2) : NaN
plot $data using 3:2 with points pt 7 ps 1 lc rgb 'black', \
     $data using 3:(y('|stepping|naive|fast|accurate|')):1 \
         with labels left offset 0.8,0.3, \
     $data using 3:(y('|product|')):1 with labels left offset 0.8,-0.6, \
     $data using 3:(y('|tangent|')):1 with labels right offset -0.8,-0.4, \
     $data using 3:(y('|closed|')):1 with labels right offset -0.4,0.7, \
     $data using 3:(y('|fast arrays|')):1 with labels center offset 0,0.8, \
     $data using 3:(y('|accurate arrays|exact rational|')):1 with labels center offset 0,-0.9
