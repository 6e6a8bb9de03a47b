#include "accuracy_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "accuracy_run.h"
#include "bench_row.h"
#include "build_info.h"
#include "world/measures.h"

namespace wells {
namespace {

constexpr double kComparedErrors[] = {1e-3, 1e-6, 1e-9};

template <class Wanted>
Reach soonestOf(const CaseResult& result, double error, Wanted wanted) {
  std::vector<Ladder> ladders;
  std::copy_if(result.ladders.begin(), result.ladders.end(), std::back_inserter(ladders),
               [&](const Ladder& ladder) { return wanted(ladder.method); });
  return soonest(ladders, error);
}

bool isTextbook(const Method& method) {
  return method.engine == "reference-heun" || method.engine == "reference-rk4";
}

bool isPublished(const Method& method) {
  return method.engine.starts_with("reference-") && !isTextbook(method);
}

std::string seconds(const std::optional<double>& time) {
  return time ? fmt::format("{:.4g}", *time) : "";
}

/// "12.3 us", "4.56 ms", "> 250 ms"
std::string readable(const Reach& reach) {
  if (reach.tried == 0) return "not run";
  const double time = reach.cpu.value_or(reach.tried);
  const bool isShort = time < 1e-3;
  return fmt::format("{}{:.3g} {}", reach.cpu ? "" : "> ", time * (isShort ? 1e6 : 1e3),
                     isShort ? "us" : "ms");
}

}  // namespace

std::span<const double> comparedErrors() {
  return kComparedErrors;
}

std::vector<CaseReach> compare(std::span<const CaseResult> cases) {
  std::vector<CaseReach> reaches;
  for (const CaseResult& result : cases)
    for (const double error : kComparedErrors)
      reaches.push_back(
          {result.scene, error, unitOf(result.error),
           soonestOf(result, error, [](const Method& m) { return m == defaultMethod(); }),
           soonestOf(result, error, [](const Method& m) { return m.engine == "ours"; }),
           soonestOf(result, error, isPublished), soonestOf(result, error, isTextbook),
           soonestOf(result, error, [](const Method& m) { return m.engine == "bullet"; })});
  return reaches;
}

std::string pointsCsv(const CaseResult& result) {
  std::string csv = fmt::format(
      "case,engine,integrator,contacts,dt,steps,error,error_unit,energy_error,escaped,cpu_s,"
      "repeats,{},"
      "state_hash,{}\n",
      kStepColumns, kBuildColumns);
  const std::string build = buildColumns();
  for (const Ladder& ladder : result.ladders)
    for (const WorkPoint& p : ladder.points)
      csv += fmt::format(
          "{},{},{},{},{:.17g},{},{:.6g},{},{},{},{:.4g},{},{},{},{}\n", result.scene,
          ladder.method.engine, csvField(ladder.method.integrator),
          csvField(ladder.method.contacts), p.dt, p.steps, p.error, unitOf(result.error),
          std::isnan(p.energyError) ? "" : fmt::format("{:.3g}", p.energyError), p.escaped, p.cpu,
          p.repeats, stepColumns(p.shares, p.books), hashText(p.stateHash), build);
  return csv;
}

std::string overviewCsv(std::span<const CaseReach> reaches) {
  std::string csv =
      "case,error,error_unit,ours_cpu_s,best_of_ours_cpu_s,best_of_ours,published_cpu_s,published,"
      "textbook_cpu_s,textbook,bullet_cpu_s,ratio_published,ratio_textbook,ratio_bullet\n";
  for (const CaseReach& r : reaches)
    csv += fmt::format("{},{:g},{},{},{},{},{},{},{},{},{},{},{},{}\n", r.scene, r.error, r.unit,
                       seconds(r.ours.cpu), seconds(r.bestOfOurs.cpu), r.bestOfOurs.method,
                       seconds(r.published.cpu), r.published.method, seconds(r.textbook.cpu),
                       r.textbook.method, seconds(r.bullet.cpu), ratioText(r.ours, r.published),
                       ratioText(r.ours, r.textbook), ratioText(r.ours, r.bullet));
  return csv;
}

std::string overviewText(std::span<const CaseReach> reaches) {
  const auto row = [](const auto&... cells) {
    return fmt::format("{:<22} {:>9} {:>9} {:>9} {:>9} {:>9}  {:>26} {:>26} {:>26}\n", cells...);
  };
  std::string text = fmt::format(
      "Least CPU time of the steps to an error (conditions.txt says of what); ours by default "
      "({}), "
      "the\nbest of the custom integrator's variants as published, the best of those with textbook "
      "methods, stock\nBullet; and how many times the time of ours they need.\n\n",
      name(defaultMethod()));
  text += row("case", "error", "ours", "published", "textbook", "Bullet", "published / ours",
              "textbook / ours", "Bullet / ours");
  for (const CaseReach& r : reaches)
    text += row(r.error == kComparedErrors[0] ? r.scene : "",
                fmt::format("{:g}{}", r.error, r.unit == "1" ? "" : fmt::format(" {}", r.unit)),
                readable(r.ours), readable(r.published), readable(r.textbook), readable(r.bullet),
                ratioText(r.ours, r.published), ratioText(r.ours, r.textbook),
                ratioText(r.ours, r.bullet));
  return text;
}

std::string conditionsText(std::span<const CaseResult> cases, std::string_view command) {
  std::string text = fmt::format(
      "command    {}\ncommit     {}\ncompiler   {}\nflags      {}\nprocessor  {}\n\n"
      "Error, from a run of its own: in m the largest distance of a ball from the exact answer at "
      "the end;\nin 1 the root mean square of what the energy is off, relative to that of the "
      "start; in m^2 the mean of\nthe sum of the squares of all overlaps (means over the states "
      "with which steps begin).\n"
      "CPU time: of the process, in the step calls alone, of an engine that has run before; "
      "median. Bullet,\nwhich cannot start over, is made anew; its first step, which builds its "
      "world, is not timed but\ncounted like the others.\nBooks (.._J): of runs of up to {} "
      "steps.\n\nNot run:\n",
      command, build_info::kCommit, build_info::kCompiler, build_info::kFlags, processorInUse(),
      kMostBookedSteps);
  for (const CaseResult& result : cases)
    for (const Ladder& ladder : result.ladders)
      for (const std::string& note : ladder.notes)
        text += fmt::format("{}, {}: {}\n", result.scene, name(ladder.method), note);
  return text;
}

}  // namespace wells
