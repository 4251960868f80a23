# Errors against alpha; columns alpha, threshold, envelope, naive, tangent, fast, accurate.
# title Error of a_t against the mass ratio
# description Errors in ulp over alpha from 0.03 to 1.1, both axes logarithmic: what rounding alpha
# description alone would cost (line) rises to a peak at every magic ratio; accurate (dots) stays
# description below half an ulp, fast (crosses) below four times the line; naive and tangent are
# description above. Of these three each fourth point is drawn. Vertical lines are thresholds.
set logscale xy
set xlabel 'mass ratio α = m/M'
set ylabel 'error of a_t / ulp'
set xrange [0.03:1.1]
set yrange [0.01:1e18]
set format y '10^{%T}'
set xtics (0.03,0.05,0.1,0.2,0.3,0.5,1) nomirror
set ytics nomirror
set key at graph 0.96,0.95 samplen 3 spacing 1.3
plot $data using 2:(0.01):(0):(1e18) with vectors nohead lw 1 lc rgb '#cccccc' notitle, \
     $data every 4::0 using 1:4 with points pt 6 ps 1.1 lc rgb '#d55e00' title 'naive', \
     $data every 4::1 using 1:5 with points pt 8 ps 1.2 lc rgb '#0072b2' title 'tangent', \
     $data every 4::2 using 1:6 with points pt 2 ps 1.1 lc rgb '#009e73' title 'fast', \
     $data using 1:7 with points pt 7 ps 0.3 lc rgb 'black' title 'accurate', \
     $data using 1:3 with lines lw 2 lc rgb 'black' title 'envelope'
