# The place of the block over time: it comes in on a straight line, slows down, turns round smoothly close to the wall without touching it, and leaves on a straight line as fast as it came. Each dot is a contact with the ball.
set xlabel 'time, in units of L/V'
set ylabel 'place of the block, in units of L'
set xrange [0:1.6]
set yrange [0:1.05]
set key off
plot 1 with lines linewidth 3 linecolor rgb '#777777', \
     '{{way}}' using 2:3 with linespoints pointtype 7 pointsize 0.7 linecolor rgb '#1f4e8c'
