# rho against alpha; columns alpha, rho for e = 1, 0.9, 0.8, 0.7.
# title Energy transmission rho against the mass ratio
# description Four curves over alpha from 0 to 1.2, lower for lower restitution: e = 1 (solid) has
# description its maxima 1 at the magic ratios; e = 0.9 (dashed), 0.8 (dash-dotted) and 0.7 (dotted)
# description have theirs further to the right but for the one at alpha = 1. Where collisions never
# description end there is no curve.
set xlabel 'mass ratio α = m/M'
set ylabel 'energy transmission ρ'
set xrange [0:1.2]
set yrange [0:1.05]
set xtics 0.2 nomirror
set ytics 0.2 nomirror
set grid lc rgb '#dddddd'
set key right bottom samplen 4 spacing 1.2
plot $data using 1:2 with lines lw 3 lc rgb 'black' title 'e = 1', \
     $data using 1:3 with lines lw 3 dt (8,4) lc rgb '#0072b2' title 'e = 0.9', \
     $data using 1:4 with lines lw 3 dt (8,3,2,3) lc rgb '#d55e00' title 'e = 0.8', \
     $data using 1:5 with lines lw 3 dt (2,3) lc rgb '#009e73' title 'e = 0.7'
