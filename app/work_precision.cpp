#include "work_precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wells {
namespace {

// Between these an error shows the order of a method: above, steps are too coarse for any;
// below, sums of rounding errors come near.
constexpr double kLargestFitted = 0.3;
constexpr double kSmallestFitted = 1e-11;
constexpr double kLargestRounding = 1e-9;
constexpr std::size_t kMostFitted = 6;
constexpr std::size_t kFewestFitted = 3;

// Where the error (logarithm) hardly rises with dt, coarser points say nothing either: an engine
// that divides long steps takes the same ones for several dt.
constexpr double kLeastRise = 0.2;

constexpr double kRounding = 1e-10;
constexpr std::size_t kSurestPoints = 8;

double slope(std::span<const double> x, std::span<const double> y) {
  const auto n = static_cast<double>(x.size());
  double meanX = 0;
  double meanY = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    meanX += x[i] / n;
    meanY += y[i] / n;
  }
  double xy = 0;
  double xx = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - meanX) * (y[i] - meanY);
    xx += (x[i] - meanX) * (x[i] - meanX);
  }
  return xy / xx;
}

double between(const WorkPoint& above, const WorkPoint& below, double error) {
  if (!std::isfinite(above.error) || below.error <= 0) return below.cpu;
  const double part = std::log(above.error / error) / std::log(above.error / below.error);
  return above.cpu * std::pow(below.cpu / above.cpu, part);
}

/// Errors below this may be sums of rounding errors: once the error is small it falls no
/// longer, and what it is from there on is rounding.
double roundingFloor(std::span<const WorkPoint> points) {
  const auto smaller = [](const WorkPoint& a, const WorkPoint& b) { return a.error < b.error; };
  const auto least = std::min_element(points.begin(), points.end(), smaller);
  if (least == points.end() || least->error > kLargestRounding) return kSmallestFitted;
  return std::max(kSmallestFitted, 10 * std::max_element(least, points.end(), smaller)->error);
}

std::string threeDigits(double ratio) {
  return ratio < 100 ? fmt::format("{:.3g}", ratio) : fmt::format("{:.0f}", ratio);
}

}  // namespace

std::string name(const Method& method) {
  if (method.engine != "ours") return method.engine;
  return fmt::format("ours {} {}", method.integrator, method.contacts);
}

std::vector<std::int64_t> stepLadder(double duration, double coarsest, int rungs) {
  std::vector<std::int64_t> ladder;
  for (int rung = 0; rung < rungs; ++rung) {
    const auto steps =
        std::max<std::int64_t>(2, std::llround(duration / (coarsest * std::ldexp(1.0, -rung))));
    if (ladder.empty() || steps > ladder.back()) ladder.push_back(steps);
  }
  return ladder;
}

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  if (values.size() % 2 == 1) return values[middle];
  return (values[middle - 1] + values[middle]) / 2;
}

std::optional<double> fittedOrder(std::span<const WorkPoint> points) {
  const double floor = roundingFloor(points);
  std::vector<double> steps;
  std::vector<double> errors;
  for (auto point = points.rbegin(); point != points.rend() && steps.size() < kMostFitted;
       ++point) {
    if (!(point->error >= floor && point->error <= kLargestFitted)) continue;
    const double error = std::log(point->error);
    if (steps.size() >= kFewestFitted && error < errors.back() + kLeastRise) break;
    steps.push_back(std::log(point->dt));
    errors.push_back(error);
  }
  if (steps.size() < kFewestFitted) return {};
  return slope(steps, errors);
}

bool isAtRounding(std::span<const WorkPoint> points) {
  if (points.size() < kSurestPoints) return false;
  const double last = points.back().error;
  return last < kRounding && last >= points[points.size() - 3].error;
}

std::optional<double> cheapest(std::span<const WorkPoint> points, double error) {
  std::optional<double> least;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(points[i].error <= error)) continue;
    const bool crosses = i > 0 && !(points[i - 1].error <= error);
    const double cpu = crosses ? between(points[i - 1], points[i], error) : points[i].cpu;
    least = std::min(cpu, least.value_or(cpu));
  }
  return least;
}

Reach soonest(std::span<const Ladder> ladders, double error) {
  Reach reach;
  for (const Ladder& ladder : ladders) {
    if (ladder.points.empty()) continue;
    const double longest = ladder.points.back().cpu;
    reach.tried = reach.tried > 0 ? std::min(reach.tried, longest) : longest;
    const auto cpu = cheapest(ladder.points, error);
    if (!cpu || (reach.cpu && *reach.cpu <= *cpu)) continue;
    reach.cpu = cpu;
    reach.method = name(ladder.method);
  }
  return reach;
}

std::string ratioText(const Reach& ours, const Reach& theirs) {
  if (theirs.tried == 0 || ours.tried == 0) return "not run";
  if (!ours.cpu) return "ours never reached it";
  if (!theirs.cpu)
    return fmt::format(">= {} (never reached)", threeDigits(theirs.tried / *ours.cpu));
  return threeDigits(*theirs.cpu / *ours.cpu);
}

}  // namespace wells
