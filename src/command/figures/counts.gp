# N_A and N_B against alpha; columns alpha, N_A, N_B: a row a step.
# title Numbers of collisions N_A and N_B against the mass ratio
# description Two falling staircases over alpha from 0.01 to 2, on a logarithmic axis: N_A (thin,
# description black) becomes k at the magic ratio alpha_k, N_B (thick, grey) at the deficient ratio
# description beta_k.
set logscale x
set xlabel 'mass ratio α = m/M'
set ylabel 'number of collisions' offset 1
set xrange [0.01:2]
set yrange [0:12]
set xtics nomirror
set ytics 0,1 nomirror
set grid lc rgb '#dddddd'
set key right top samplen 3 spacing 1.3
plot $data using 1:3 with steps lw 7 lc rgb '#b0b0b0' title 'N_B', \
     $data using 1:2 with steps lw 2 lc rgb 'black' title 'N_A'
