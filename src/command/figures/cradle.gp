# Places of blocks and balls against time, a row a collision; columns t, then x_A1, x_C1, x_A2 to
# x_A5.
# title The generalised Newton's cradle in space and time
# description Places over time of five equal blocks (solid) and four balls between them (dashed), of
# description mass ratios alpha_1 to alpha_4, before a wall at the top. The k-th ball bounces k
# description times between its blocks, then rests, and the next block has the whole momentum; the
# description fifth block meets the wall and all happens again the other way round.
# size 600 640
set xrange [-1:19]
set yrange [-1.3:8.4]
set xlabel 't / (L/V)'
set ylabel 'x / L' offset 1
set xtics 0,4 nomirror
set ytics 0,2 nomirror
set key outside above center horizontal samplen 4
set rmargin 5
set arrow from graph 0, first 8 to graph 1, first 8 nohead lw 5 lc rgb '#444444'
set label 'wall' at graph 0.03, first 7.7
# At the end all rest but A_1, which leaves as it came.
do for [k=1:4] { set label sprintf('C_%d', k) at graph 1, first 2*k-2 offset 0.5,0 }
do for [k=2:5] { set label sprintf('A_%d', k) at graph 1, first 2*k-3 offset 0.5,0 }
plot for [i=2:10:2] $data using 1:i with lines lw 2.5 lc rgb 'black' \
         title (i == 2 ? 'blocks A_k' : ''), \
     for [i=3:9:2] $data using 1:i with lines lw 2 dt (6,4) lc rgb '#d55e00' \
         title (i == 3 ? 'balls C_k' : '')
