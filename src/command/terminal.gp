# Before every figure: `format` is set, and `size`, width and height in the units of SVG.
set encoding utf8
width = words(size) == 2 ? word(size, 1) + 0 : 600
height = words(size) == 2 ? word(size, 2) + 0 : 440
if (format eq 'svg') { set terminal svg size width,height font 'sans,17' background 'white' }
if (format eq 'png') {
  set terminal pngcairo size 2*width,2*height font 'sans,17' fontscale 1.5 linewidth 2 pointscale 2
}
if (format eq 'pdf') {
  set terminal pdfcairo size 0.01*width,0.01*height font 'sans,12' fontscale 0.9 linewidth 1.5
}
set datafile separator ','
set datafile columnheaders
