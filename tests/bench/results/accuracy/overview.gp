# Draws overview.png; in this folder: gnuplot overview.gp
reset
set terminal pngcairo size 2400,3040 font 'DejaVu Sans,11' background 'white'
set output 'overview.png'
set datafile separator comma
set datafile columnheaders
set logscale xy
set format '10^{%T}'
set grid xtics ytics lc rgb '#BBBBBB' lw 1 dt 1
# Errors that the axis does not reach stand at its ends.
clipped(e) = e < 1e-16 ? 1e-16 : e > 1000 ? 1000 : e
is(engine, integrator, contacts) = strcol('engine') eq engine && strcol('integrator') eq integrator && strcol('contacts') eq contacts

set multiplot layout 8,5 title "error against CPU time of the steps (s)" font ',16'

unset arrow
unset label
unset key
set title "{/:Bold bounce}, t = 10 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'bounce.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'bounce.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'bounce.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'bounce.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'bounce.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'bounce.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'bounce.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'bounce.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'bounce.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'bounce.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'bounce.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'bounce.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'bounce.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'bounce.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'bounce.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'bounce.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'bounce.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold zeno}, t = 6 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'zeno.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'zeno.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'zeno.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'zeno.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'zeno.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'zeno.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'zeno.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'zeno.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'zeno.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'zeno.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'zeno.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'zeno.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'zeno.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'zeno.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'zeno.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'zeno.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'zeno.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold zeno-rest}, t = 4 s, error in m" offset 0,-0.6
set xrange [1e-06:0.1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 0.1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'zeno-rest.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'zeno-rest.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'zeno-rest.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'zeno-rest.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'zeno-rest.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'zeno-rest.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'zeno-rest.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'zeno-rest.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'zeno-rest.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'zeno-rest.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'zeno-rest.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'zeno-rest.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'zeno-rest.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'zeno-rest.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'zeno-rest.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'zeno-rest.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'zeno-rest.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold slide-to-roll}, t = 3 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'slide-to-roll.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'slide-to-roll.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'slide-to-roll.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'slide-to-roll.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'slide-to-roll.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'slide-to-roll.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'slide-to-roll.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'slide-to-roll.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'slide-to-roll.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'slide-to-roll.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'slide-to-roll.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'slide-to-roll.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'slide-to-roll.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'slide-to-roll.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'slide-to-roll.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'slide-to-roll.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'slide-to-roll.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold backspin}, t = 3 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'backspin.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'backspin.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'backspin.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'backspin.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'backspin.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'backspin.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'backspin.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'backspin.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'backspin.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'backspin.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'backspin.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'backspin.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'backspin.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'backspin.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'backspin.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'backspin.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'backspin.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold backspin-return}, t = 3 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'backspin-return.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'backspin-return.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'backspin-return.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'backspin-return.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'backspin-return.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'backspin-return.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'backspin-return.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'backspin-return.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'backspin-return.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'backspin-return.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'backspin-return.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'backspin-return.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'backspin-return.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'backspin-return.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'backspin-return.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'backspin-return.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'backspin-return.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold rolling-well}, t = 10 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'rolling-well.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'rolling-well.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'rolling-well.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'rolling-well.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'rolling-well.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'rolling-well.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'rolling-well.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'rolling-well.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'rolling-well.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'rolling-well.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'rolling-well.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'rolling-well.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'rolling-well.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'rolling-well.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'rolling-well.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'rolling-well.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'rolling-well.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold rolling-stops}, t = 3 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'rolling-stops.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'rolling-stops.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'rolling-stops.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'rolling-stops.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'rolling-stops.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'rolling-stops.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'rolling-stops.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'rolling-stops.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'rolling-stops.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'rolling-stops.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'rolling-stops.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'rolling-stops.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'rolling-stops.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'rolling-stops.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'rolling-stops.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'rolling-stops.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'rolling-stops.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold stuck-under-a-well}, t = 10 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'stuck-under-a-well.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'stuck-under-a-well.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'stuck-under-a-well.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'stuck-under-a-well.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'stuck-under-a-well.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'stuck-under-a-well.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'stuck-under-a-well.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'stuck-under-a-well.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'stuck-under-a-well.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'stuck-under-a-well.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'stuck-under-a-well.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'stuck-under-a-well.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'stuck-under-a-well.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'stuck-under-a-well.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'stuck-under-a-well.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'stuck-under-a-well.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'stuck-under-a-well.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold whispering-gallery}, t = 10 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'whispering-gallery.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'whispering-gallery.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'whispering-gallery.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'whispering-gallery.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'whispering-gallery.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'whispering-gallery.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'whispering-gallery.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'whispering-gallery.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'whispering-gallery.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'whispering-gallery.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'whispering-gallery.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'whispering-gallery.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'whispering-gallery.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'whispering-gallery.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'whispering-gallery.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'whispering-gallery.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'whispering-gallery.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold wall-slide-to-roll}, t = 5 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'wall-slide-to-roll.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'wall-slide-to-roll.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'wall-slide-to-roll.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'wall-slide-to-roll.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'wall-slide-to-roll.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'wall-slide-to-roll.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'wall-slide-to-roll.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'wall-slide-to-roll.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'wall-slide-to-roll.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'wall-slide-to-roll.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'wall-slide-to-roll.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'wall-slide-to-roll.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'wall-slide-to-roll.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'wall-slide-to-roll.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'wall-slide-to-roll.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'wall-slide-to-roll.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'wall-slide-to-roll.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold wall-rolling}, t = 10 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'wall-rolling.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'wall-rolling.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'wall-rolling.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'wall-rolling.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'wall-rolling.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'wall-rolling.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'wall-rolling.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'wall-rolling.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'wall-rolling.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'wall-rolling.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'wall-rolling.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'wall-rolling.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'wall-rolling.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'wall-rolling.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'wall-rolling.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'wall-rolling.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'wall-rolling.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold corner-slide-to-roll}, t = 10 s, error in m" offset 0,-0.6
set xrange [1e-06:0.1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 0.1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'corner-slide-to-roll.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'corner-slide-to-roll.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'corner-slide-to-roll.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'corner-slide-to-roll.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'corner-slide-to-roll.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'corner-slide-to-roll.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'corner-slide-to-roll.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'corner-slide-to-roll.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'corner-slide-to-roll.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'corner-slide-to-roll.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'corner-slide-to-roll.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'corner-slide-to-roll.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'corner-slide-to-roll.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'corner-slide-to-roll.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'corner-slide-to-roll.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'corner-slide-to-roll.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'corner-slide-to-roll.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold corner-rolling}, t = 10 s, error in m" offset 0,-0.6
set xrange [1e-05:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-05,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-05,1e-08 to 0.00015,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 0.00015,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-05,1e-08 to 0.00015,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 0.00015,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-05,1e-08 to 0.00015,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 0.00015,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'corner-rolling.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'corner-rolling.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'corner-rolling.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'corner-rolling.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'corner-rolling.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'corner-rolling.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'corner-rolling.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'corner-rolling.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'corner-rolling.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'corner-rolling.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'corner-rolling.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'corner-rolling.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'corner-rolling.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'corner-rolling.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'corner-rolling.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'corner-rolling.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'corner-rolling.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold oblique-ground}, t = 2 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'oblique-ground.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'oblique-ground.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'oblique-ground.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'oblique-ground.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'oblique-ground.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'oblique-ground.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'oblique-ground.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'oblique-ground.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'oblique-ground.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'oblique-ground.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'oblique-ground.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'oblique-ground.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'oblique-ground.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'oblique-ground.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'oblique-ground.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'oblique-ground.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'oblique-ground.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold oblique-balls}, t = 2 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'oblique-balls.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'oblique-balls.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'oblique-balls.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'oblique-balls.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'oblique-balls.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'oblique-balls.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'oblique-balls.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'oblique-balls.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'oblique-balls.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'oblique-balls.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'oblique-balls.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'oblique-balls.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'oblique-balls.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'oblique-balls.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'oblique-balls.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'oblique-balls.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'oblique-balls.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold friction-balls-stick}, t = 2 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'friction-balls-stick.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'friction-balls-stick.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'friction-balls-stick.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'friction-balls-stick.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'friction-balls-stick.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'friction-balls-stick.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'friction-balls-stick.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'friction-balls-stick.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'friction-balls-stick.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'friction-balls-stick.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'friction-balls-stick.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'friction-balls-stick.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'friction-balls-stick.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'friction-balls-stick.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'friction-balls-stick.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'friction-balls-stick.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'friction-balls-stick.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold friction-balls-slip}, t = 2 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'friction-balls-slip.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'friction-balls-slip.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'friction-balls-slip.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'friction-balls-slip.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'friction-balls-slip.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'friction-balls-slip.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'friction-balls-slip.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'friction-balls-slip.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'friction-balls-slip.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'friction-balls-slip.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'friction-balls-slip.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'friction-balls-slip.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'friction-balls-slip.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'friction-balls-slip.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'friction-balls-slip.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'friction-balls-slip.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'friction-balls-slip.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold billiard}, t = 3 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'billiard.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'billiard.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'billiard.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'billiard.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'billiard.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'billiard.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'billiard.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'billiard.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'billiard.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'billiard.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'billiard.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'billiard.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'billiard.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'billiard.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'billiard.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'billiard.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'billiard.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold circle-billiard}, t = 1000 s, error in m" offset 0,-0.6
set xrange [0.0001:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 0.0001,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 0.00015,1e-08 to 0.0015,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 0.0015,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 0.00015,1e-08 to 0.0015,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 0.0015,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 0.00015,1e-08 to 0.0015,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 0.0015,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'circle-billiard.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'circle-billiard.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'circle-billiard.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'circle-billiard.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'circle-billiard.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'circle-billiard.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'circle-billiard.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'circle-billiard.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'circle-billiard.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'circle-billiard.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'circle-billiard.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'circle-billiard.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'circle-billiard.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'circle-billiard.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'circle-billiard.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'circle-billiard.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'circle-billiard.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold cradle}, t = 1.5 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'cradle.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'cradle.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'cradle.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'cradle.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'cradle.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'cradle.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'cradle.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'cradle.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'cradle.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'cradle.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'cradle.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'cradle.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'cradle.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'cradle.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'cradle.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'cradle.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'cradle.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold galperin}, t = 4 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'galperin.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'galperin.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'galperin.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'galperin.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'galperin.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'galperin.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'galperin.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'galperin.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'galperin.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'galperin.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'galperin.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'galperin.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'galperin.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'galperin.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'galperin.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'galperin.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'galperin.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold collapse}, t = 6 s, error in m" offset 0,-0.6
set xrange [1e-05:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-05,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-05,1e-08 to 0.00015,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 0.00015,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-05,1e-08 to 0.00015,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 0.00015,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-05,1e-08 to 0.00015,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 0.00015,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'collapse.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'collapse.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'collapse.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'collapse.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'collapse.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'collapse.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'collapse.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'collapse.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'collapse.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'collapse.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'collapse.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'collapse.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'collapse.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'collapse.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'collapse.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'collapse.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'collapse.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold collapse-twin}, t = 10 s, error in m" offset 0,-0.6
set xrange [1e-05:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-05,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-05,1e-08 to 0.00015,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 0.00015,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-05,1e-08 to 0.00015,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 0.00015,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-05,1e-08 to 0.00015,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 0.00015,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'collapse-twin.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'collapse-twin.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'collapse-twin.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'collapse-twin.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'collapse-twin.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'collapse-twin.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'collapse-twin.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'collapse-twin.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'collapse-twin.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'collapse-twin.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'collapse-twin.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'collapse-twin.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'collapse-twin.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'collapse-twin.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'collapse-twin.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'collapse-twin.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'collapse-twin.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold pile-stands}, t = 10 s, error in m" offset 0,-0.6
set xrange [1e-05:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-05,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-05,1e-08 to 0.00015,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 0.00015,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-05,1e-08 to 0.00015,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 0.00015,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-05,1e-08 to 0.00015,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 0.00015,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'pile-stands.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'pile-stands.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'pile-stands.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'pile-stands.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'pile-stands.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'pile-stands.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'pile-stands.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'pile-stands.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'pile-stands.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'pile-stands.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'pile-stands.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'pile-stands.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'pile-stands.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'pile-stands.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'pile-stands.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'pile-stands.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'pile-stands.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold pile-slips}, t = 1 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'pile-slips.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'pile-slips.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'pile-slips.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'pile-slips.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'pile-slips.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'pile-slips.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'pile-slips.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'pile-slips.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'pile-slips.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'pile-slips.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'pile-slips.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'pile-slips.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'pile-slips.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'pile-slips.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'pile-slips.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'pile-slips.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'pile-slips.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold column}, t = 1 s, error in m" offset 0,-0.6
set xrange [1e-05:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-05,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-05,1e-08 to 0.00015,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 0.00015,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-05,1e-08 to 0.00015,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 0.00015,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-05,1e-08 to 0.00015,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 0.00015,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'column.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'column.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'column.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'column.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'column.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'column.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'column.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'column.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'column.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'column.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'column.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'column.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'column.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'column.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'column.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'column.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'column.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold orbit}, t = 20 s, error in m" offset 0,-0.6
set xrange [1e-05:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-05,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-05,1e-08 to 0.00015,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 0.00015,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-05,1e-08 to 0.00015,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 0.00015,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-05,1e-08 to 0.00015,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 0.00015,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'orbit.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'orbit.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'orbit.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'orbit.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'orbit.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'orbit.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'orbit.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'orbit.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'orbit.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'orbit.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'orbit.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'orbit.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'orbit.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'orbit.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'orbit.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'orbit.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'orbit.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold orbit-short}, t = 2 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'orbit-short.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'orbit-short.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'orbit-short.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'orbit-short.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'orbit-short.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'orbit-short.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'orbit-short.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'orbit-short.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'orbit-short.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'orbit-short.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'orbit-short.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'orbit-short.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'orbit-short.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'orbit-short.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'orbit-short.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'orbit-short.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'orbit-short.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold circular-orbit}, t = 20 s, error in m" offset 0,-0.6
set xrange [1e-05:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-05,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-05,1e-08 to 0.00015,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 0.00015,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-05,1e-08 to 0.00015,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 0.00015,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-05,1e-08 to 0.00015,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 0.00015,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'circular-orbit.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'circular-orbit.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'circular-orbit.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'circular-orbit.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'circular-orbit.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'circular-orbit.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'circular-orbit.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'circular-orbit.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'circular-orbit.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'circular-orbit.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'circular-orbit.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'circular-orbit.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'circular-orbit.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'circular-orbit.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'circular-orbit.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'circular-orbit.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'circular-orbit.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold through-the-centre}, t = 10 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'through-the-centre.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'through-the-centre.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'through-the-centre.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'through-the-centre.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'through-the-centre.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'through-the-centre.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'through-the-centre.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'through-the-centre.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'through-the-centre.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'through-the-centre.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'through-the-centre.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'through-the-centre.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'through-the-centre.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'through-the-centre.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'through-the-centre.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'through-the-centre.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'through-the-centre.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold well-bounces}, t = 6 s, error in m" offset 0,-0.6
set xrange [1e-06:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-06,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 1.5e-05,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 1.5e-05,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-06,1e-08 to 1.5e-05,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 1.5e-05,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'well-bounces.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'well-bounces.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'well-bounces.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'well-bounces.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'well-bounces.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'well-bounces.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'well-bounces.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'well-bounces.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'well-bounces.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'well-bounces.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'well-bounces.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'well-bounces.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'well-bounces.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'well-bounces.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'well-bounces.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'well-bounces.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'well-bounces.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold well-bounces-long}, t = 16 s, error in m" offset 0,-0.6
set xrange [1e-05:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-05,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-05,1e-08 to 0.00015,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 0.00015,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-05,1e-08 to 0.00015,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 0.00015,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-05,1e-08 to 0.00015,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 0.00015,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'well-bounces-long.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'well-bounces-long.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'well-bounces-long.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'well-bounces-long.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'well-bounces-long.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'well-bounces-long.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'well-bounces-long.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'well-bounces-long.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'well-bounces-long.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'well-bounces-long.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'well-bounces-long.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'well-bounces-long.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'well-bounces-long.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'well-bounces-long.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'well-bounces-long.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'well-bounces-long.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'well-bounces-long.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold bouncing}, t = 20 s, error in 1" offset 0,-0.6
set xrange [0.0001:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 0.0001,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 0.00015,1e-08 to 0.0015,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 0.0015,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 0.00015,1e-08 to 0.0015,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 0.0015,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 0.00015,1e-08 to 0.0015,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 0.0015,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'bouncing.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'bouncing.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'bouncing.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'bouncing.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'bouncing.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'bouncing.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'bouncing.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'bouncing.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'bouncing.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'bouncing.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'bouncing.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'bouncing.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'bouncing.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'bouncing.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'bouncing.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'bouncing.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'bouncing.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold 666}, t = 10 s, error in m^2" offset 0,-0.6
set xrange [0.01:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 0.01,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 0.015,1e-08 to 0.15,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 0.15,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 0.015,1e-08 to 0.15,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 0.15,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 0.015,1e-08 to 0.15,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 0.15,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  '666.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  '666.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  '666.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  '666.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  '666.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  '666.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  '666.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  '666.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  '666.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  '666.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  '666.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  '666.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  '666.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  '666.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  '666.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  '666.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  '666.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold elastic-666}, t = 10 s, error in 1" offset 0,-0.6
set xrange [0.001:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 0.001,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 0.0015,1e-08 to 0.015,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 0.015,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 0.0015,1e-08 to 0.015,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 0.015,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 0.0015,1e-08 to 0.015,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 0.015,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'elastic-666.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'elastic-666.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'elastic-666.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'elastic-666.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'elastic-666.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'elastic-666.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'elastic-666.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'elastic-666.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'elastic-666.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'elastic-666.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'elastic-666.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'elastic-666.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'elastic-666.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'elastic-666.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'elastic-666.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'elastic-666.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'elastic-666.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset key
set title "{/:Bold cooling-gas}, t = 2 s, error in 1" offset 0,-0.6
set xrange [1e-05:1]
set yrange [1e-16:10000]
set ytics 1e-15,1e3,1e3
set mytics 1
set arrow from 1e-05,1e-3 to 1,1e-3 nohead back lc rgb '#000000' lw 1 dt 2
set arrow from 1.5e-05,1e-08 to 0.00015,1e-09 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 1' at 0.00015,1e-09 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-05,1e-08 to 0.00015,1e-10 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 2' at 0.00015,1e-10 left offset 0.3,0 tc rgb '#666666' font ',9'
set arrow from 1.5e-05,1e-08 to 0.00015,1e-12 nohead lc rgb '#666666' lw 1.5 dt 3
set label 'order 4' at 0.00015,1e-12 left offset 0.3,0 tc rgb '#666666' font ',9'
plot \
  'cooling-gas.csv' using (is('ours', 'pefrl', 'auto') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 notitle, \
  'cooling-gas.csv' using (is('ours', 'symplectic-euler', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 notitle, \
  'cooling-gas.csv' using (is('ours', 'leapfrog', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 notitle, \
  'cooling-gas.csv' using (is('ours', 'heun', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 notitle, \
  'cooling-gas.csv' using (is('ours', 'rk4', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 notitle, \
  'cooling-gas.csv' using (is('ours', 'pefrl', 'substep') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 notitle, \
  'cooling-gas.csv' using (is('ours', 'symplectic-euler', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 notitle, \
  'cooling-gas.csv' using (is('ours', 'leapfrog', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 notitle, \
  'cooling-gas.csv' using (is('ours', 'heun', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 notitle, \
  'cooling-gas.csv' using (is('ours', 'rk4', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 notitle, \
  'cooling-gas.csv' using (is('ours', 'pefrl', 'exact') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 notitle, \
  'cooling-gas.csv' using (is('reference-euler', 'euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 notitle, \
  'cooling-gas.csv' using (is('reference-improved-euler', 'improved-euler', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 notitle, \
  'cooling-gas.csv' using (is('reference-rk', 'rk', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 notitle, \
  'cooling-gas.csv' using (is('reference-heun', 'heun', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 notitle, \
  'cooling-gas.csv' using (is('reference-rk4', 'rk4', 'manifold') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 notitle, \
  'cooling-gas.csv' using (is('bullet', 'symplectic-euler', 'sequential-impulse') ? column('cpu_s') : NaN):(clipped(column('error'))) with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 notitle

unset arrow
unset label
unset title
unset tics
unset border
unset logscale
set key inside left center Left reverse spacing 1.05
set xrange [0:1]
set yrange [0:1]
plot \
  NaN with linespoints lc rgb '#900072B2' lw 8.4 dt 1 pt 7 ps 1.8 title "{/:Bold ours pefrl auto (default)}", \
  NaN with linespoints lc rgb '#E69F00' lw 0.9 dt 2 pt 4 ps 0.78 title "ours symplectic-euler substep", \
  NaN with linespoints lc rgb '#56B4E9' lw 0.9 dt 2 pt 8 ps 0.78 title "ours leapfrog substep", \
  NaN with linespoints lc rgb '#009E73' lw 0.9 dt 2 pt 10 ps 0.78 title "ours heun substep", \
  NaN with linespoints lc rgb '#CC79A7' lw 0.9 dt 2 pt 12 ps 0.78 title "ours rk4 substep", \
  NaN with linespoints lc rgb '#0072B2' lw 0.9 dt 2 pt 6 ps 0.78 title "ours pefrl substep", \
  NaN with linespoints lc rgb '#E69F00' lw 1.2 dt 1 pt 5 ps 0.78 title "ours symplectic-euler exact", \
  NaN with linespoints lc rgb '#56B4E9' lw 1.2 dt 1 pt 9 ps 0.78 title "ours leapfrog exact", \
  NaN with linespoints lc rgb '#009E73' lw 1.2 dt 1 pt 11 ps 0.78 title "ours heun exact", \
  NaN with linespoints lc rgb '#CC79A7' lw 1.2 dt 1 pt 13 ps 0.78 title "ours rk4 exact", \
  NaN with linespoints lc rgb '#0072B2' lw 1.2 dt 1 pt 7 ps 0.78 title "ours pefrl exact", \
  NaN with linespoints lc rgb '#444444' lw 1.2 dt 4 pt 1 ps 0.78 title "reference-euler", \
  NaN with linespoints lc rgb '#777777' lw 1.2 dt 4 pt 2 ps 0.78 title "reference-improved-euler", \
  NaN with linespoints lc rgb '#999999' lw 1.2 dt 4 pt 3 ps 0.78 title "reference-rk", \
  NaN with linespoints lc rgb '#555555' lw 1.2 dt 4 pt 8 ps 0.78 title "reference-heun", \
  NaN with linespoints lc rgb '#888888' lw 1.2 dt 4 pt 12 ps 0.78 title "reference-rk4", \
  NaN with linespoints lc rgb '#D55E00' lw 1.8 dt 1 pt 15 ps 0.96 title "bullet"
unset multiplot
