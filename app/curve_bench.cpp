#include "curve_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "bench_child.h"
#include "bench_row.h"
#include "command_line.h"
#include "engines.h"
#include "errors.h"
#include "gnuplot.h"
#include "paired_ratio.h"
#include "progress.h"
#include "scenes/catalogue.h"
#include "text_file.h"
#include "values.h"
#include "work_precision.h"

namespace wells {
namespace {

namespace fs = std::filesystem;

struct CurveOptions {
  std::string scene = "T1";
  std::int64_t balls = 0;  // 0: the scene's
  std::int64_t steps = 0;
  std::int64_t repeats = 3;
  std::vector<std::int64_t> substeps = {1, 2, 4, 8};
  std::vector<std::int64_t> iterations = {1, 2, 4, 8, 16};
  fs::path out = "out/curve";
};

/// What was measured with one setting of ours, or of stock Bullet.
struct CurvePoint {
  std::int64_t substeps = 0;  // 0: stock Bullet
  std::int64_t iterations = 0;
  std::vector<double> times;    // ms a step, by repeat
  std::optional<BenchRow> row;  // of the first repeat; physics is the same in all
  bool isBullet() const { return substeps == 0; }
};

/// Bullet's time over that of `point`, repeat by repeat.
double speedUp(const CurvePoint& point, const CurvePoint& bullet) {
  return pairedRatio(bullet.times, point.times).median;
}

std::optional<CurveOptions> parseCurveOptions(std::span<const std::string> arguments) {
  CLI::App app{
      "Overlap against time: runs a scene with each number of substeps and of solver passes, and "
      "with stock Bullet, in turn, each in a process of its own.\n"
      "Writes a table (CSV), a gnuplot script and a plot (PNG). The whole takes about half an "
      "hour.",
      "./run.sh bench curve"};
  CurveOptions options;
  addName(app, "--scene", options.scene, "what to simulate (default T1)",
          [](std::string_view name) { findScene(name); });
  addInteger(app, "--balls", options.balls, 1, 1'000'000, "default: the scene's");
  addInteger(app, "--steps", options.steps, 1, 1'000'000, "default: the scene's");
  addInteger(app, "--repeats", options.repeats, 1, 100,
             "of everything; the median counts (default 3)");
  addIntegers(app, "--substeps", options.substeps, 1000, "of ours (default 1,2,4,8)");
  addIntegers(app, "--iterations", options.iterations, 1000,
              "passes a substep, of ours (default 1,2,4,8,16)");
  addPath(app, "--out", options.out, "FOLDER", "for all files (default out/curve)");
  if (parseArguments(app, arguments) == Parsed::HelpShown) return {};
  return options;
}

std::vector<CurvePoint> pointsOf(const CurveOptions& options) {
  std::vector<CurvePoint> points(1);
  for (const std::int64_t substeps : options.substeps)
    for (const std::int64_t iterations : options.iterations)
      points.push_back({substeps, iterations, {}, {}});
  return points;
}

std::vector<std::string> argumentsOf(const CurveOptions& options, const CurvePoint& point) {
  std::vector<std::string> arguments = {"--scene", options.scene};
  const auto add = [&](const char* name, std::int64_t value) {
    if (value == 0) return;
    arguments.emplace_back(name);
    arguments.push_back(std::to_string(value));
  };
  add("--balls", options.balls);
  add("--steps", options.steps);
  if (point.isBullet()) {
    arguments.insert(arguments.end(), {"--engine", "bullet", "--no-books"});
    return arguments;
  }
  add("--substeps", point.substeps);
  add("--iterations", point.iterations);
  if (!point.times.empty()) arguments.emplace_back("--no-books");
  return arguments;
}

void run(const CurveOptions& options, std::span<CurvePoint> points) {
  const StatusLine line;
  const std::size_t all = points.size() * static_cast<std::size_t>(options.repeats);
  std::size_t done = 0;
  for (std::int64_t repeat = 0; repeat < options.repeats; ++repeat)
    for (CurvePoint& point : points) {
      line.show(fmt::format("run {} of {}", ++done, all));
      BenchRow row = runBenchChild(argumentsOf(options, point), options.out);
      point.times.push_back(row.number("ms_per_step"));
      if (!point.row) point.row = std::move(row);
    }
}

std::string curveCsv(std::span<const CurvePoint> points) {
  std::string csv =
      "engine,substeps,iterations,ms_per_step,times_bullet,ball_overlap_m,ground_overlap_m,"
      "wall_overlap_m,escaped,contacts_J,friction_J,push_out_J,energy_start_J,energy_end_J,"
      "state_hash,commit,compiler,flags,cpu\n";
  for (const CurvePoint& p : points) {
    const auto cell = [&](const char* column) { return csvField(p.row->text(column)); };
    csv += fmt::format("{},{},{},{:.6g},{:.4g}", cell("engine"), p.isBullet() ? 1 : p.substeps,
                       p.isBullet() ? "" : std::to_string(p.iterations), median(p.times),
                       speedUp(p, points[0]));
    for (const char* column : {"ball_overlap_m", "ground_overlap_m", "wall_overlap_m", "escaped",
                               "contacts_J", "friction_J", "push_out_J", "energy_start_J",
                               "energy_end_J", "state_hash", "commit", "compiler", "flags", "cpu"})
      csv += ',' + cell(column);
    csv += '\n';
  }
  return csv;
}

std::string curveText(std::span<const CurvePoint> points) {
  std::string text =
      fmt::format("{:>9} {:>10} {:>10} {:>12} {:>14} {:>16} {:>8}\n", "substeps", "passes",
                  "ms a step", "times Bullet", "overlap (m)", "ground, wall (m)", "escaped");
  for (const CurvePoint& p : points)
    text +=
        fmt::format("{:>9} {:>10} {:>10.3g} {:>12.3g} {:>14.3g} {:>16.3g} {:>8}\n",
                    p.isBullet() ? "Bullet" : std::to_string(p.substeps),
                    p.isBullet() ? "" : std::to_string(p.iterations), median(p.times),
                    speedUp(p, points[0]), p.row->number("ball_overlap_m"),
                    std::max(p.row->number("ground_overlap_m"), p.row->number("wall_overlap_m")),
                    p.row->text("escaped"));
  return text;
}

std::string curveScript(const CurveOptions& options) {
  std::string script = fmt::format(
      "# Draws curve.png; in this folder: gnuplot curve.gp\n"
      "set terminal pngcairo size 1100,800 font 'DejaVu Sans,15' background 'white'\n"
      "set output 'curve.png'\n"
      "set datafile separator comma\n"
      "set datafile columnheaders\n"
      "set logscale xy\n"
      "set grid lc rgb '#BBBBBB' lw 1 dt 1\n"
      "set title \"{{/:Bold {}}}: what the solver leaves, and what it takes\"\n"
      "set xlabel 'time of a step (ms)'\n"
      "set ylabel 'worst overlap of two balls at the end (m)'\n"
      "set key outside right top Left reverse spacing 1.3\n"
      "# None at all stands at the foot of the axis.\n"
      "shown(overlap) = overlap < 1e-5 ? 1e-5 : overlap\n"
      "is(s) = strcol('engine') eq 'ours' && column('substeps') == s\n"
      "plot",
      options.scene);
  // Okabe and Ito's, which the colour-blind tell apart.
  const char* const colours[] = {"#0072B2", "#009E73", "#D55E00", "#CC79A7", "#56B4E9", "#E69F00"};
  std::size_t next = 0;
  for (const std::int64_t substeps : options.substeps) {
    script += fmt::format(
        " \\\n  'curve.csv' using (is({0}) ? column('ms_per_step') : NaN)"
        ":(shown(column('ball_overlap_m'))) with linespoints lw 2 pt 7 lc rgb '{1}' title '{0} "
        "substep{2}', \\\n"
        "  '' using (is({0}) ? column('ms_per_step') : NaN):(shown(column('ball_overlap_m')))"
        ":(strcol('iterations')) with labels offset 0,0.8 tc rgb '{1}' notitle,",
        substeps, colours[next++ % std::size(colours)], substeps == 1 ? "" : "s");
  }
  return script +
         " \\\n  'curve.csv' using (strcol('engine') eq 'bullet' ? column('ms_per_step') : NaN)"
         ":(shown(column('ball_overlap_m'))) with points pt 9 ps 2 lc rgb '#000000' title 'stock "
         "Bullet'\n";
}

}  // namespace

int runCurveBench(std::span<const std::string> arguments, char** argv) {
  const std::optional<CurveOptions> options = parseCurveOptions(arguments);
  if (!options) return 0;
  becomeExecutableOf("ours", argv);  // the one that starts the other
  makeFolder("--out", options->out);
  std::vector<CurvePoint> points = pointsOf(*options);
  run(*options, points);
  writeAtomically(options->out / "curve.csv", curveCsv(points));
  writeAtomically(options->out / "curve.txt", curveText(points));
  writeAtomically(options->out / "curve.gp", curveScript(*options));
  fmt::print("{}", curveText(points));
  runGnuplot(options->out, "curve.gp");
  fmt::print("\nTable and plot: {}\n", options->out.string());
  return 0;
}

}  // namespace wells
