# Velocities of a light ball and two blocks over the cycle number n. That of A falls from one to zero and that of B rises from zero to one along two smooth curves; the ball's two velocities form a flat arch above and a nearly mirrored arch below, more than twenty times as high.
set multiplot layout 2,1
set key outside right
set lmargin 8
set rmargin 14
set xrange [0:36]
set ylabel 'blocks'
plot '{{curves}}' using 1:2 with points pointtype 7 pointsize 0.6 linecolor rgb '#1f4e8c' title 'a_n', \
     '' using 1:3 with points pointtype 6 pointsize 0.7 linecolor rgb '#9c4a00' title 'b_n'
set ylabel 'ball'
set xlabel 'n'
plot 0 with lines linecolor rgb '#999999' notitle, \
     '{{curves}}' using 1:4 with points pointtype 7 pointsize 0.6 linecolor rgb '#333333' title 'c_n', \
     '' using 1:5 with points pointtype 6 pointsize 0.7 linecolor rgb '#333333' title "c'_n"
unset multiplot
