#include "plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "accuracy_run.h"
#include "errors.h"
#include "gnuplot.h"
#include "plot_styles.h"
#include "text_file.h"

namespace wells {
namespace {

namespace fs = std::filesystem;

// Errors, in the unit of the case.
constexpr double kLowestShown = 1e-16;
constexpr double kExact = 1e-9;  // at any step
constexpr double kHighestShown = 1e3;

constexpr int kCellWidth = 480;  // pixels, in the overview
constexpr int kCellHeight = 380;
constexpr int kMostColumns = 5;

enum class Legend { Shown, Hidden };

/// What every script begins with. `width` and `height` in pixels.
std::string preamble(const std::string& file, int width, int height, int fontSize) {
  return fmt::format(
      "# Draws {0}.png; in this folder: gnuplot {0}.gp\n"
      "reset\n"
      "set terminal pngcairo size {1},{2} font 'DejaVu Sans,{3}' background 'white'\n"
      "set output '{0}.png'\n"
      "set datafile separator comma\n"
      "set datafile columnheaders\n"
      "set logscale xy\n"
      "set format '10^{{%T}}'\n"
      "set grid xtics ytics lc rgb '#BBBBBB' lw 1 dt 1\n"
      "# Errors that the axis does not reach stand at its ends.\n"
      "clipped(e) = e < {4:g} ? {4:g} : e > {5:g} ? {5:g} : e\n"
      "is(engine, integrator, contacts) = strcol('engine') eq engine && strcol('integrator') eq "
      "integrator && strcol('contacts') eq contacts\n\n",
      file, width, height, fontSize, kLowestShown, kHighestShown);
}

std::string legendName(const Method& method) {
  return method == defaultMethod() ? fmt::format("{{/:Bold {} (default)}}", name(method))
                                   : name(method);
}

std::string label(const Ladder& ladder) {
  const auto order = fittedOrder(ladder.points);
  const auto isExact = [](const WorkPoint& point) { return point.error <= kExact; };
  const std::string verdict =
      order ? fmt::format("order {:.1f}", *order)
            : (std::all_of(ladder.points.begin(), ladder.points.end(), isExact) ? "exact"
                                                                                : "no order");
  return fmt::format("{}: {}", legendName(ladder.method), verdict);
}

/// Those that ran. The default first: it is the widest line and must not hide others.
std::vector<Ladder> inDrawingOrder(std::vector<Ladder> ladders) {
  std::erase_if(ladders, [](const Ladder& ladder) { return ladder.points.empty(); });
  std::stable_partition(ladders.begin(), ladders.end(),
                        [](const Ladder& ladder) { return ladder.method == defaultMethod(); });
  return ladders;
}

/// The plot command: a line for each method.
std::string plotLines(const CaseResult& result, Legend legend, double scale) {
  std::string lines = "plot";
  for (const Ladder& ladder : inDrawingOrder(result.ladders)) {
    lines += fmt::format(
        "{} \\\n  '{}.csv' using (is('{}', '{}', '{}') ? column('cpu_s') : NaN)"
        ":(clipped(column('error'))) with linespoints {} {}",
        lines == "plot" ? "" : ",", result.scene, ladder.method.engine, ladder.method.integrator,
        ladder.method.contacts, plotStyle(ladder.method, scale),
        legend == Legend::Shown ? fmt::format("title \"{}\"", label(ladder)) : "notitle");
  }
  return lines + "\n";
}

struct Span {
  double low;
  double high;
};

/// The powers of ten around the CPU times.
Span timeSpan(const CaseResult& result) {
  Span span{1, 1e-6};
  for (const Ladder& ladder : result.ladders)
    for (const WorkPoint& point : ladder.points)
      span = {std::min(span.low, point.cpu), std::max(span.high, point.cpu)};
  return {std::pow(10, std::floor(std::log10(span.low))),
          std::pow(10, std::ceil(std::log10(span.high)))};
}

/// Short lines of slope -1, -2 and -4 that start from one point.
std::string slopeGuides(const Span& times, int fontSize) {
  std::string guides;
  const double from = times.low * 1.5;
  const double top = 1e-8;
  for (const int order : {1, 2, 4}) {
    const double to = from * 10;
    const double bottom = top * std::pow(10.0, -order);
    guides += fmt::format(
        "set arrow from {:g},{:g} to {:g},{:g} nohead lc rgb '#666666' lw 1.5 dt 3\n"
        "set label 'order {}' at {:g},{:g} left offset 0.3,0 tc rgb '#666666' font ',{}'\n",
        from, top, to, bottom, order, to, bottom, fontSize);
  }
  return guides;
}

std::string frame(const CaseResult& result, int fontSize) {
  const Span times = timeSpan(result);
  return fmt::format(
             "set xrange [{:g}:{:g}]\nset yrange [{:g}:{:g}]\nset ytics 1e-15,1e3,1e3\nset mytics "
             "1\n"
             "set arrow from {:g},1e-3 to {:g},1e-3 nohead back lc rgb '#000000' lw 1 dt 2\n",
             times.low, times.high, kLowestShown, kHighestShown * 10, times.low, times.high) +
         slopeGuides(times, fontSize);
}

std::string caseScript(const CaseResult& result) {
  return preamble(result.scene, 1600, 1000, 16) +
         fmt::format(
             "set title \"{{/:Bold {}}}: {}\"\n"
             "set xlabel 'CPU time of the steps until t = {:g} s (s)'\n"
             "set ylabel '{} ({})'\n"
             "set key outside right top Left reverse spacing 1.3 samplen 3 font ',15'\n",
             result.scene, result.about, result.duration, describe(result.error),
             unitOf(result.error)) +
         frame(result, 13) + plotLines(result, Legend::Shown, 1);
}

/// An empty plot with the legend of all.
std::string legendCell(const CaseResult& result) {
  std::string cell =
      "\nunset arrow\nunset label\nunset title\nunset tics\nunset border\n"
      "unset logscale\nset key inside left center Left reverse spacing 1.05\n"
      "set xrange [0:1]\nset yrange [0:1]\nplot";
  for (const Ladder& ladder : inDrawingOrder(result.ladders))
    cell += fmt::format("{} \\\n  NaN with linespoints {} title \"{}\"",
                        cell.ends_with("plot") ? "" : ",", plotStyle(ladder.method, 0.6),
                        legendName(ladder.method));
  return cell + "\n";
}

std::string overviewScript(std::span<const CaseResult> cases) {
  const int cells = static_cast<int>(cases.size()) + 1;
  const int columns = std::min(kMostColumns, cells);
  const int rows = (cells + columns - 1) / columns;
  std::string script = preamble("overview", kCellWidth * columns, kCellHeight * rows, 11) +
                       fmt::format(
                           "set multiplot layout {},{} title \"error against CPU time of the steps "
                           "(s)\" font ',16'\n",
                           rows, columns);
  for (const CaseResult& result : cases)
    script += fmt::format(
                  "\nunset arrow\nunset label\nunset key\n"
                  "set title \"{{/:Bold {}}}, t = {:g} s, error in {}\" offset 0,-0.6\n",
                  result.scene, result.duration, unitOf(result.error)) +
              frame(result, 9) + plotLines(result, Legend::Hidden, 0.6);
  return script + legendCell(cases.front()) + "unset multiplot\n";
}

}  // namespace

void writePlotScripts(const fs::path& folder, std::span<const CaseResult> cases) {
  for (const CaseResult& result : cases)
    writeAtomically(folder / (result.scene + ".gp"), caseScript(result));
  writeAtomically(folder / "overview.gp", overviewScript(cases));
}

void drawPlots(const fs::path& folder, std::span<const CaseResult> cases) try {
  for (const CaseResult& result : cases) runGnuplot(folder, result.scene + ".gp");
  runGnuplot(folder, "overview.gp");
} catch (const RunError& error) {
  throw RunError(
      fmt::format("no plots: {}\nThe tables are complete. \"app/install.sh plots\" installs "
                  "gnuplot; then, in {}: gnuplot *.gp",
                  error.what(), folder.string()));
}

}  // namespace wells
