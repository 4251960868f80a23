# V_n on the unit sphere, seen from outside; columns part (V_n or circle), n, a, b, sqrt(alpha) c'.
# title V_n turning about its axis on the unit sphere
# description A sphere with the axes a, b and sqrt(alpha) c'. At the magic ratio alpha_5 the tips of
# description V_0 to V_5 (dots) lie on one circle about an axis (arrow), each a turn by psi from the
# description one before: from the tip of a, where A has everything, to that of b, where B has.
# size 600 560
unset key
unset border
unset tics
set size ratio -1
set margins 1,1,1,1
set xrange [-1.35:1.6]
set yrange [-1.15:1.5]
set trange [0:2*pi]
set samples 400
azimuth = 0.62
height = 0.42
px(x,y,z) = -x*sin(azimuth) + y*cos(azimuth)
py(x,y,z) = -(x*cos(azimuth) + y*sin(azimuth))*sin(height) + z*cos(height)
depth(x,y,z) = (x*cos(azimuth) + y*sin(azimuth))*cos(height) + z*sin(height)
front(x,y,z) = depth(x,y,z) < 0 ? NaN : py(x,y,z)
# The axis goes through the middle of the circle.
stats $data every ::6 using 3 nooutput name 'x'
stats $data every ::6 using 4 nooutput name 'y'
stats $data every ::6 using 5 nooutput name 'z'
long = sqrt(x_mean**2 + y_mean**2 + z_mean**2)
ax = px(x_mean, y_mean, z_mean)/long
ay = py(x_mean, y_mean, z_mean)/long
set parametric
do for [i=1:3] {
  x = i == 1; y = i == 2; z = i == 3
  set arrow from 0,0 to 1.26*px(x,y,z),1.26*py(x,y,z) head size 0.05,18 back lw 1 lc rgb '#777777'
  set label word("a b √α·c'", i) at 1.38*px(x,y,z),1.38*py(x,y,z) center
}
set arrow from 0,0 to 1.25*ax,1.25*ay head filled size 0.06,18 lw 2.5 lc rgb 'black'
set label 'axis' at 1.7*ax,1.6*ay center
plot cos(t),sin(t) with lines lw 1.6 lc rgb '#777777', \
     px(0,cos(t),sin(t)),front(0,cos(t),sin(t)) with lines lw 1 lc rgb '#bbbbbb', \
     px(cos(t),0,sin(t)),front(cos(t),0,sin(t)) with lines lw 1 lc rgb '#bbbbbb', \
     px(cos(t),sin(t),0),front(cos(t),sin(t),0) with lines lw 1 lc rgb '#bbbbbb', \
     $data every ::126 using (px($3,$4,$5)):(py($3,$4,$5)) with lines \
         lw 2 dt (2,3) lc rgb '#d55e00', \
     $data every ::6::126 using (px($3,$4,$5)):(py($3,$4,$5)) with lines lw 2.5 lc rgb '#0072b2', \
     $data every ::0::5 using (px($3,$4,$5)):(py($3,$4,$5)) with points pt 7 ps 1 lc rgb 'black', \
     $data every ::1::4 using (0.85*px($3,$4,$5)):(0.85*py($3,$4,$5)):(sprintf('V_%g', $2)) \
         with labels center, \
     $data every ::0::0 using (px($3,$4,$5)):(py($3,$4,$5)):('V_0') \
         with labels left offset 0.8,0.7, \
     $data every ::5::5 using (px($3,$4,$5)):(py($3,$4,$5)):('V_5') \
         with labels right offset -0.6,0.7
