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
isOne(rows) = strstrt(rows, '|' . strcol('scene') . ' ' . strcol('method') . '|') > 0
plot \
  'speed.csv' using (isOne('|T1-25 stock Bullet|T1-1000 stock Bullet|T1-10000 stock Bullet|T1-50000 stock Bullet|T1-100000 stock Bullet|') ? column('balls') : NaN):'ms_per_step' with linespoints lw 2 pt 9 ps 1.4 lc rgb '#000000' title 'stock Bullet', \
  'speed.csv' using (isOne('|T1-25 ours|T1-1000 ours|T1-10000 ours|T1-50000 ours|T1-100000 ours|') ? column('balls') : NaN):'ms_per_step' with linespoints lw 2 pt 7 ps 1.4 lc rgb '#0072B2' title 'ours', \
  'speed.csv' using (isOne('|T1-25 ours on 2 threads|T1-1000 ours on 2 threads|T1-10000 ours on 2 threads|T1-50000 ours on 2 threads|T1-100000 ours on 2 threads|') ? column('balls') : NaN):'ms_per_step' with linespoints lw 2 pt 5 ps 1.4 lc rgb '#D55E00' title 'ours on 2 threads', \
  'speed.csv' using (isOne('|T1-25 ours substep 1x4 leapfrog|T1-1000 ours 2x2 leapfrog|T1-10000 ours 3x3 leapfrog|T1-50000 ours 3x2 leapfrog|T1-100000 ours 3x3 leapfrog|') ? column('balls') : NaN):'ms_per_step' with linespoints lw 2 pt 11 ps 1.4 lc rgb '#009E73' title 'ours, tuned', \
  'speed.csv' using (isOne('|T1-10000 ours 3x3 leapfrog on 2 threads|T1-50000 ours 3x2 leapfrog on 2 threads|T1-100000 ours 3x3 leapfrog on 2 threads|') ? column('balls') : NaN):'ms_per_step' with linespoints lw 2 pt 13 ps 1.4 lc rgb '#CC79A7' title 'ours on 2 threads, tuned'
