# Draws billiard.png; in this folder: gnuplot billiard.gp
reset
set terminal pngcairo size 1600,1000 font 'DejaVu Sans,16' background 'white'
set output 'billiard.png'
set datafile separator comma
set datafile columnheaders
set logscale xy
set format '10^{%T}'
set grid xtics ytics lc rgb '#BBBBBB' lw 1 dt 1
# Errors that the axis does not reach stand at its ends.
clipped(e) = e < 1e-16 ? 1e-16 : e > 1000 ? 1000 : e
is(engine, integrator, contacts) = strcol('engine') eq engine && strcol('integrator') eq integrator && strcol('contacts') eq contacts

set title "{/:Bold billiard}: two impacts, the second magnifies the error of the first"
set xlabel 'CPU time of the steps until t = 3 s (s)'
set ylabel 'largest error of a position at the end (m)'
set key outside right top Left reverse spacing 1.3 samplen 3 font ',15'
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',13'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',13'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',13'
plot \
  'billiard.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 14 dt 1 pt 7 ps 3 title "{/:Bold ours pefrl auto (default)}: exact", \
  'billiard.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.5 dt 2 pt 4 ps 1.3 title "ours symplectic-euler substep: order 1.4", \
  'billiard.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.5 dt 2 pt 8 ps 1.3 title "ours leapfrog substep: order 1.4", \
  'billiard.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.5 dt 2 pt 10 ps 1.3 title "ours heun substep: order 1.4", \
  'billiard.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.5 dt 2 pt 12 ps 1.3 title "ours rk4 substep: order 1.4", \
  'billiard.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.5 dt 2 pt 6 ps 1.3 title "ours pefrl substep: order 1.4", \
  'billiard.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 2 dt 1 pt 5 ps 1.3 title "ours symplectic-euler exact: exact", \
  'billiard.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 2 dt 1 pt 9 ps 1.3 title "ours leapfrog exact: exact", \
  'billiard.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 2 dt 1 pt 11 ps 1.3 title "ours heun exact: exact", \
  'billiard.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 2 dt 1 pt 13 ps 1.3 title "ours rk4 exact: exact", \
  'billiard.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 2 dt 1 pt 7 ps 1.3 title "ours pefrl exact: exact", \
  'billiard.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 2 dt 4 pt 1 ps 1.3 title "reference-euler: order 1.4", \
  'billiard.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 2 dt 4 pt 2 ps 1.3 title "reference-improved-euler: order 0.2", \
  'billiard.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 2 dt 4 pt 3 ps 1.3 title "reference-rk: no order", \
  'billiard.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 2 dt 4 pt 8 ps 1.3 title "reference-heun: order 1.1", \
  'billiard.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 2 dt 4 pt 12 ps 1.3 title "reference-rk4: order 1.1", \
  'billiard.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 3 dt 1 pt 15 ps 1.6 title "bullet: no order"
