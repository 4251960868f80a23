# Collisions in the unfolded wedge, a row a collision, in their order; columns collision, t, s,
# angle.
# title The collisions as a straight line through the unfolded wedge
# description A fan of rays from one point, each turned by psi/2 from the one before: mirror images
# description of the wedge (grey) of all places. Solid rays are collisions of A and C, dashed ones
# description of C and B; the distance from the tip is that of A and B. At alpha_3 the six
# description collisions P_1, Q_1 to Q_3 (dots) lie on one straight line.
# size 600 360
unset key
unset border
unset tics
set size ratio -1
set margins 1,1,1,1
set xrange [-3:3]
set yrange [-0.4:2.95]
reach = 2.7
stats $data using 4 nooutput name 'turn'
h = turn_min
set object polygon from 0,0 to reach,0 to reach*cos(h),reach*sin(h) to 0,0 \
    back fillstyle solid 1 noborder fc rgb '#e4e4e4'
set arrow from 0,0 to reach,0 nohead lw 2.5 dt (8,4) lc rgb 'black'
set label 'C meets B' at 1.75,-0.2 center
set label 'A meets C' at 1.72*cos(h),1.72*sin(h)+0.22 center rotate by h*180/pi
plot $data every 2 using (0):(0):(reach*cos($4)):(reach*sin($4)) with vectors \
         nohead lw 1.5 lc rgb 'black', \
     $data every 2::1 using (0):(0):(reach*cos($4)):(reach*sin($4)) with vectors \
         nohead lw 1.5 dt (8,4) lc rgb '#010101', \
     $data using ((reach+0.17)*cos($4)):((reach+0.17)*sin($4)):1 with labels center, \
     $data every ::0::0 using (2.9):($3*sin($4)):(-5.8):(0) with vectors \
         head filled size 0.12,18 lw 3 lc rgb '#0072b2', \
     $data using ($3*cos($4)):($3*sin($4)) with points pt 7 ps 1 lc rgb 'black'
