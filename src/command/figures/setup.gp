# The three bodies before the first collision; columns body, x, v: a row a body.
# title The initial state of the three bodies
# description Three bodies on a line: block A of mass M at the left moves to the right with velocity
# description V, the ball C of mass m = alpha M rests at x = 0, block B of mass M rests at x = L.
# size 600 200
set xrange [-1.5:1.5]
set yrange [-0.36:0.46]
set size ratio -1
set margins 1,1,0,0
unset border
unset tics
unset key
set arrow from -1.45,-0.16 to 1.45,-0.16 nohead lw 1.5 lc rgb 'black'
set arrow from 0,-0.18 to 0,-0.14 nohead lc rgb 'black'
set arrow from 1,-0.18 to 1,-0.14 nohead lc rgb 'black'
set label '0' at 0,-0.27 center
set label 'L' at 1,-0.27 center
set label 'x' at 1.42,-0.27 center
set label 'M' at -1,0.27 center
set label 'M' at 1,0.27 center
set label 'm = αM' at 0,0.27 center
set label 'V' at -0.55,0.14 center
plot $data every 2 using 2:(0):(0.16):(0.16) with boxxyerror \
         lc rgb 'black' lw 2 fs solid 0.2 border, \
     $data every ::1::1 using 2:(-0.09):(0.07) with circles \
         lc rgb 'black' lw 2 fs solid 0.5 border, \
     $data every ::0::0 using ($2+0.2):(0):(0.45*$3):(0) with vectors \
         head filled size 0.07,20 lw 2.5 lc rgb 'black', \
     $data every 2 using 2:(0):1 with labels center, \
     $data every ::1::1 using 2:(0.06):1 with labels center
