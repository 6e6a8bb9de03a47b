# Draws curve.png; in this folder: gnuplot curve.gp
set terminal pngcairo size 1100,800 font 'DejaVu Sans,15' background 'white'
set output 'curve.png'
set datafile separator comma
set datafile columnheaders
set logscale xy
set grid lc rgb '#BBBBBB' lw 1 dt 1
set title "{/:Bold T1}: what the solver leaves, and what it takes"
set xlabel 'time of a step (ms)'
set ylabel 'worst overlap of two balls at the end (m)'
set key outside right top Left reverse spacing 1.3
# None at all stands at the foot of the axis.
shown(overlap) = overlap < 1e-5 ? 1e-5 : overlap
is(s) = strcol('engine') eq 'ours' && column('substeps') == s
plot \
  'curve.csv' using (is(2) ? column('ms_per_step') : NaN):(shown(column('ball_overlap_m'))) with linespoints lw 2 pt 7 lc rgb '#0072B2' title '2 substeps', \
  '' using (is(2) ? column('ms_per_step') : NaN):(shown(column('ball_overlap_m'))):(strcol('iterations')) with labels offset 0,0.8 tc rgb '#0072B2' notitle, \
  'curve.csv' using (is(3) ? column('ms_per_step') : NaN):(shown(column('ball_overlap_m'))) with linespoints lw 2 pt 7 lc rgb '#009E73' title '3 substeps', \
  '' using (is(3) ? column('ms_per_step') : NaN):(shown(column('ball_overlap_m'))):(strcol('iterations')) with labels offset 0,0.8 tc rgb '#009E73' notitle, \
  'curve.csv' using (is(4) ? column('ms_per_step') : NaN):(shown(column('ball_overlap_m'))) with linespoints lw 2 pt 7 lc rgb '#D55E00' title '4 substeps', \
  '' using (is(4) ? column('ms_per_step') : NaN):(shown(column('ball_overlap_m'))):(strcol('iterations')) with labels offset 0,0.8 tc rgb '#D55E00' notitle, \
  'curve.csv' using (is(8) ? column('ms_per_step') : NaN):(shown(column('ball_overlap_m'))) with linespoints lw 2 pt 7 lc rgb '#CC79A7' title '8 substeps', \
  '' using (is(8) ? column('ms_per_step') : NaN):(shown(column('ball_overlap_m'))):(strcol('iterations')) with labels offset 0,0.8 tc rgb '#CC79A7' notitle, \
  'curve.csv' using (strcol('engine') eq 'bullet' ? column('ms_per_step') : NaN):(shown(column('ball_overlap_m'))) with points pt 9 ps 2 lc rgb '#000000' title 'stock Bullet'
