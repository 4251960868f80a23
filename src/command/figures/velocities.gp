# Velocities after n cycles for a light ball; columns n, a, b, c, c_prime.
# title Velocities of a light ball and of both blocks, cycle by cycle
# description Two panels over the number of cycles n, for alpha = 1/1000. Above: that of A (filled
# description dots) falls from 1 to 0 and that of B (open dots) rises from 0 to 1 along two smooth
# description curves. Below: the ball's two velocities form an arch and its mirror image, more than
# description twenty times as high.
# size 600 620
set xrange [-1:36]
set grid lc rgb '#dddddd'
set lmargin 8
set key right center samplen 1 spacing 1.3
set multiplot layout 2,1
set ylabel 'blocks: velocity / V'
set yrange [-0.05:1.05]
plot $data using 1:2 with points pt 7 ps 0.6 lc rgb '#0072b2' title 'a_n', \
     $data using 1:3 with points pt 6 ps 0.7 lc rgb 'black' title 'b_n'
set ylabel 'ball: velocity / V'
set yrange [-25:25]
set key center center
set xlabel 'cycles n'
plot $data using 1:4 with points pt 7 ps 0.6 lc rgb '#d55e00' title 'c_n', \
     $data using 1:5 with points pt 6 ps 0.7 lc rgb 'black' title "c'_n"
unset multiplot
