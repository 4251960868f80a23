# a_t, b_t and c_t against alpha; columns alpha, a_t, b_t, c_t.
# title Terminal velocities against the mass ratio
# description Three curves over alpha from 0 to 1.2: b_t (solid) reaches V at every magic ratio,
# description where c_t (dashed) and a_t (dotted) are 0, and falls to c_t at every deficient ratio;
# description a_t is never positive.
set xlabel 'mass ratio α = m/M'
set ylabel 'terminal velocity / V'
set xrange [0:1.2]
set yrange [-0.25:1.15]
set xtics 0.2 nomirror
set ytics 0.25 nomirror
set grid lc rgb '#dddddd'
set key right center samplen 3 spacing 1.3
plot $data using 1:3 with lines lw 3 lc rgb 'black' title 'b_t', \
     $data using 1:4 with lines lw 3 dt (6,4) lc rgb '#d55e00' title 'c_t', \
     $data using 1:2 with lines lw 3 dt (2,3) lc rgb '#0072b2' title 'a_t'
