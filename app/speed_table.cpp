#include "speed_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "bench_row.h"
#include "values.h"
#include "work_precision.h"

namespace wells {
namespace {

/// Of the rows of "bench".
constexpr std::string_view kPhysicsColumns =
    "integrator,contacts,ball_overlap_m,ground_overlap_m,wall_overlap_m,escaped,energy_start_J,"
    "energy_end_J,kinetic_start_J,kinetic_end_J,asleep,exact_share,substep_share,impacts,"
    "handed_over,direct_contacts,unsolved_islands,contacts_J,friction_J,drag_J,wells_J,push_out_J,"
    "flight_J,memory_MiB,state_hash";

std::string range(const PairedRatio& ratio) {
  return fmt::format("{:.3g} ({:.3g}..{:.3g})", ratio.median, ratio.least, ratio.most);
}

std::string verdict(const SpeedResult& result, const SpeedRow& row) {
  return keepsBounds(result, row) ? "pass" : "FAIL";
}

std::string textLine(const SpeedResult& result, const SpeedRow& row) {
  const BenchRow& r = *row.row;
  const bool isOurs = !row.method.isBullet();
  const double change = r.number("energy_end_J") - r.number("energy_start_J");
  const auto optional = [&](const char* column, const char* format) {
    return r.text(column).empty() ? "-" : fmt::format(fmt::runtime(format), r.number(column));
  };
  const auto single = timesOneThread(result, row);
  const auto bytes = ballBytes(result, row);
  return fmt::format(
      "  {:<22} {:>10.4g} {:>22} {:>22} {:>9.3g} {:>9} {:>5} {:>9.3g} {:>9.3g} {:>7} {:>11.3g} "
      "{:>11} {:>6} {:>7}  {}\n",
      name(row.method), median(row.times), isOurs ? range(timesBullet(result, row)) : "",
      single ? range(*single) : "", r.number("ball_overlap_m"),
      isOurs ? fmt::format("{:.3g}", ballBound(result, row)) : "",
      isOurs ? verdict(result, row) : "", r.number("ground_overlap_m"), r.number("wall_overlap_m"),
      r.text("escaped"), change, optional("contacts_J", "{:.3g}"),
      optional("exact_share", "{:.2f}"), bytes ? fmt::format("{:.0f}", *bytes) : "",
      r.text("state_hash"));
}

std::string csvLine(const SpeedResult& result, const SpeedRow& row) {
  const SpeedScene& scene = *result.scene;
  const SpeedMethod& m = row.method;
  const auto ratio = [](const PairedRatio& r) {
    return fmt::format("{:.4g},{:.4g},{:.4g}", r.median, r.least, r.most);
  };
  const auto single = timesOneThread(result, row);
  const auto bytes = ballBytes(result, row);
  std::string line = fmt::format(
      "{},{},{},{},{},{},{},{},{:.6g},{:.6g},{:.6g},{},{},{},{}", scene.name, scene.balls,
      result.steps, scene.column, row.times.size(), csvField(name(m)), m.engine, m.threads,
      median(row.times), std::ranges::min(row.times), std::ranges::max(row.times),
      m.isBullet() ? "1,1,1" : ratio(timesBullet(result, row)), single ? ratio(*single) : ",,",
      bytes ? fmt::format("{:.0f}", *bytes) : "",
      m.isBullet() ? "," : fmt::format("{:.6g},{}", ballBound(result, row), verdict(result, row)));
  for (const std::string_view column : splitAtCommas(kPhysicsColumns))
    line += ',' + csvField(row.row->text(std::string(column)));
  return line + ',' + buildColumns() + '\n';
}

/// Rows of several scenes of T1 as one line of the plot.
struct Curve {
  std::string title;
  std::string rows = "|";  // "|scene method|scene method|"
};

/// Empty: not drawn.
std::string titleOf(const SpeedMethod& method) {
  const bool isTuned = method.substeps > 0;
  if (!isTuned) return method.contacts.empty() ? name(method) : "";
  SpeedMethod plain;
  plain.threads = method.threads;
  return name(plain) + ", tuned";
}

std::vector<Curve> curvesOf(std::span<const SpeedResult> results) {
  std::vector<Curve> curves;
  for (const SpeedResult& result : results) {
    std::vector<std::string> drawn = {""};  // what has no title is not
    for (const SpeedRow& row : result.rows) {
      const std::string title = titleOf(row.method);
      const bool isFirst = std::ranges::find(drawn, title) == drawn.end();
      if (result.scene->scene != "T1" || !row.row || !isFirst) continue;
      drawn.push_back(title);
      auto curve = std::ranges::find(curves, title, &Curve::title);
      if (curve == curves.end()) curve = curves.insert(curve, {title});
      curve->rows += fmt::format("{} {}|", result.scene->name, name(row.method));
    }
  }
  return curves;
}

}  // namespace

std::string speedText(const SpeedResult& result) {
  const SpeedScene& scene = *result.scene;
  if (result.rounds() == 0)
    return fmt::format("{}: left out, there was no time for a round of it\n", scene.name);
  std::string text = fmt::format(
      "{}: {} balls, steps 0 to {}{}, {} round(s) of up to {}\n"
      "  {:<22} {:>10} {:>22} {:>22} {:>9} {:>9} {:>5} {:>9} {:>9} {:>7} {:>11} {:>11} {:>6} "
      "{:>7}  {}\n",
      scene.name, scene.balls, result.steps,
      scene.column == "ms_per_step" ? "" : " (time of the last 100)", result.rounds(),
      result.wantedRounds, "method", "ms a step", "Bullet / it", "1 thread / it", "balls (m)",
      "bound (m)", "kept", "ground", "wall", "escaped", "energy (J)", "contacts", "exact", "B/ball",
      "state");
  for (const SpeedRow& row : result.rows) text += textLine(result, row);
  return text;
}

std::string speedCsv(std::span<const SpeedResult> results) {
  std::string csv = fmt::format(
      "scene,balls,steps,time_of,rounds,method,engine,threads,ms_per_step,ms_least,ms_most,"
      "times_bullet,times_bullet_least,times_bullet_most,times_one_thread,times_one_thread_least,"
      "times_one_thread_most,bytes_a_ball,ball_bound_m,verdict,{},{}\n",
      kPhysicsColumns, kBuildColumns);
  for (const SpeedResult& result : results)
    for (const SpeedRow& row : result.rows)
      if (row.row) csv += csvLine(result, row);
  return csv;
}

std::string speedScript(std::span<const SpeedResult> results) {
  const std::vector<Curve> curves = curvesOf(results);
  if (curves.empty()) return "";
  std::string script =
      "# Draws speed.png; in this folder: gnuplot speed.gp\n"
      "set terminal pngcairo size 1100,800 font 'DejaVu Sans,15' background 'white'\n"
      "set output 'speed.png'\n"
      "set datafile separator comma\n"
      "set datafile columnheaders\n"
      "# A method's line goes on across the others' rows.\n"
      "set datafile missing NaN\n"
      "set logscale xy\n"
      "set grid lc rgb '#BBBBBB' lw 1 dt 1\n"
      "set title \"{/:Bold T1}: a step against the number of balls\"\n"
      "set xlabel 'balls'\n"
      "set ylabel 'time of a step (ms)'\n"
      "set xrange [15:160000]\n"
      "set key outside right top Left reverse spacing 1.3\n"
      "set arrow from 15,1000.0/60 to 160000,1000.0/60 nohead back lc rgb '#000000' lw 2 dt 2\n"
      "set label '60 Hz' at 18,1000.0/60 left offset 0,0.7\n"
      "isOne(rows) = strstrt(rows, '|' . strcol('scene') . ' ' . strcol('method') . '|') > 0\n"
      "plot";
  // Okabe and Ito's, which the colour-blind tell apart.
  const char* const colours[] = {"#000000", "#0072B2", "#D55E00", "#009E73",
                                 "#CC79A7", "#E69F00", "#56B4E9"};
  const int markers[] = {9, 7, 5, 11, 13, 4, 6};
  for (std::size_t i = 0; i < curves.size(); ++i)
    script += fmt::format(
        "{} \\\n  'speed.csv' using (isOne('{}') ? column('balls') : NaN):'ms_per_step' with "
        "linespoints lw 2 pt {} ps 1.4 lc rgb '{}' title '{}'",
        i == 0 ? "" : ",", curves[i].rows, markers[i % std::size(markers)],
        colours[i % std::size(colours)], curves[i].title);
  return script + "\n";
}

}  // namespace wells
