# Draws speed.png; in this folder: gnuplot speed.gp
set terminal pngcairo size 1100,800 font 'DejaVu Sans,15' background 'white'
set output 'speed.png'
set datafile separator comma
set datafile columnheaders
# A method's line goes on across the others' rows.
set datafile missing NaN
set logscale xy
set grid lc rgb '#BBBBBB' lw 1 dt 1
set title "{/:Bold T1}: a step against the number of balls"
set xlabel 'balls'
set ylabel 'time of a step (ms)'
set xrange [15:160000]
set key outside right top Left reverse spacing 1.3
set arrow from 15,1000.0/60 to 160000,1000.0/60 nohead back lc rgb '#000000' lw 2 dt 2
set label '60 Hz' at 18,1000.0/60 left offset 0,0.7
is(name) = strcol('scene')[1:2] eq 'T1' && strcol('method') eq name
plot \
  'speed.csv' using (is('stock Bullet') ? column('balls') : NaN):'ms_per_step' with linespoints lw 2 pt 9 ps 1.4 lc rgb '#000000' title 'stock Bullet', \
  'speed.csv' using (is('ours') ? column('balls') : NaN):'ms_per_step' with linespoints lw 2 pt 7 ps 1.4 lc rgb '#0072B2' title 'ours', \
  'speed.csv' using (is('ours on 2 threads') ? column('balls') : NaN):'ms_per_step' with linespoints lw 2 pt 5 ps 1.4 lc rgb '#D55E00' title 'ours on 2 threads', \
  'speed.csv' using (is('ours 3x3') ? column('balls') : NaN):'ms_per_step' with linespoints lw 2 pt 11 ps 1.4 lc rgb '#009E73' title 'ours 3x3', \
  'speed.csv' using (is('ours 3x3 on 2 threads') ? column('balls') : NaN):'ms_per_step' with linespoints lw 2 pt 13 ps 1.4 lc rgb '#CC79A7' title 'ours 3x3 on 2 threads', \
  'speed.csv' using (is('ours 4x3') ? column('balls') : NaN):'ms_per_step' with linespoints lw 2 pt 4 ps 1.4 lc rgb '#E69F00' title 'ours 4x3', \
  'speed.csv' using (is('ours 4x3 on 2 threads') ? column('balls') : NaN):'ms_per_step' with linespoints lw 2 pt 6 ps 1.4 lc rgb '#56B4E9' title 'ours 4x3 on 2 threads'
