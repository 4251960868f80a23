# Eleven points on a rising straight line through zero: the exact velocity of the ball at eleven neighbouring machine numbers. The middle one is at zero as far as can be seen.
set xlabel 'doubles away from the hardest input'
set ylabel "c' after the last contact, in units of 10^{-13} V"
set key off
set grid
set xrange [-5.5:5.5]
plot 0 with lines linecolor rgb '#999999', \
     '{{around}}' using 1:($2*1e13) with points pointtype 7 pointsize 0.9 linecolor rgb '#1f4e8c'
