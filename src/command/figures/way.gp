# A block, a ball and a wall: places against time; columns t, x_block, x_ball: a row a collision.
# title The way of a block that a ball turns back
# description The block comes in on a straight line, slows down, turns round smoothly close to the
# description wall without touching it, and leaves on a straight line as fast as it came, a dot
# description at each collision; the light ball (dashed) zigzags between block and wall. The wall is
# description the thick line at the top.
set xrange [0:2]
set yrange [0:1.05]
set xlabel 't / (L/V)'
set ylabel 'x / L'
set grid lc rgb '#dddddd'
unset key
plot 1 with lines lw 4 lc rgb '#777777', \
     $data using 1:3 with lines lw 1.5 dt (6,4) lc rgb '#d55e00', \
     $data using 1:2 with lines lw 3 lc rgb '#0072b2', \
     $data using 1:($2 == $3 ? $2 : NaN) with points pt 7 ps 0.6 lc rgb '#0072b2'
