#include "stress_row.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "bench_row.h"
#include "errors.h"
#include "values.h"

namespace wells {
namespace {

constexpr char kSeparator = '\t';

struct TableColumn {
  std::string_view cell;
  std::string_view title;
  int width;
  TableWidth shownFrom;
};

constexpr std::array kTable = {
    TableColumn{"lost", "lost", 4, TableWidth::Narrow},
    TableColumn{"not_finite", "NaN", 4, TableWidth::Narrow},
    TableColumn{"gain_J", "gain/J", 8, TableWidth::Narrow},
    TableColumn{"gain_relative", "gain/E", 8, TableWidth::Wide},
    TableColumn{"overlap_m", "overlap/m", 9, TableWidth::Narrow},
    TableColumn{"exact_share", "exact", 5, TableWidth::Wide},
    TableColumn{"impacts", "impacts", 7, TableWidth::Wide},
    TableColumn{"handed_over", "handed", 6, TableWidth::Wide},
    TableColumn{"ms_per_step", "ms/step", 8, TableWidth::Narrow},
};

// What follows the engine's name on a line.
template <class Text>
std::string tableColumns(TableWidth width, Text text) {
  std::string line;
  for (const TableColumn& column : kTable)
    if (width == TableWidth::Wide || column.shownFrom == TableWidth::Narrow)
      line += fmt::format(" {:>{}}", text(column), column.width);
  return line;
}

std::string number(double x) {
  return fmt::format("{:.3g}", x);
}

std::string share(std::int64_t part, std::int64_t other) {
  if (part + other == 0) return "-";
  return fmt::format("{:.0f}%",
                     100 * static_cast<double>(part) / static_cast<double>(part + other));
}

}  // namespace

StressRow::StressRow(const StressCase& stress, const Stepper& ran, const StressResult& r) {
  const StepCounts& counts = r.counts;
  const double msPerStep = r.steps > 0 ? 1e3 * r.stepTime / static_cast<double>(r.steps) : 0;
  cells_ = {std::string(stress.name),
            ran.name(),
            ran.integrator(),
            ran.contactMethod(),
            std::to_string(stress.versions),
            std::to_string(r.steps),
            std::to_string(r.lost),
            std::to_string(r.notFinite),
            number(r.gain),
            number(r.relativeGain),
            number(r.overlap),
            std::to_string(counts.exactBalls),
            std::to_string(counts.substepBalls),
            share(counts.exactBalls, counts.substepBalls),
            std::to_string(counts.impacts),
            std::to_string(counts.handedOver),
            std::to_string(counts.directContacts),
            std::to_string(counts.unsolvedIslands),
            std::to_string(counts.latePairs),
            number(msPerStep),
            r.firstBroken,
            wells::verdict(stress, r),
            r.gaveUp.empty() ? "" : r.gaveUp.front()};
  // A separator within a reason would make two cells of it.
  for (std::string& cell : cells_) std::ranges::replace(cell, kSeparator, ' ');
}

StressRow::StressRow(const StressCase& stress, const std::string& engine,
                     const std::string& verdict, const std::string& reason)
    : cells_(splitAtCommas(kStressColumns).size(), "-") {
  cells_.front() = stress.name;
  cells_[1] = engine;
  cells_[cells_.size() - 2] = verdict;
  cells_.back() = reason;
}

StressRow::StressRow(std::string_view text) {
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(kSeparator, begin), text.size());
    cells_.emplace_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  if (cells_.size() != splitAtCommas(kStressColumns).size())
    throw RunError(fmt::format("\"{}\": no row of the stress benchmark", text));
}

std::string StressRow::text() const {
  return joined(cells_, std::string(1, kSeparator));
}

std::string StressRow::csv() const {
  std::vector<std::string> quoted;
  for (const std::string& cell : cells_) quoted.push_back(csvField(cell));
  return joined(quoted, ",");
}

const std::string& StressRow::cell(std::string_view column) const {
  const auto names = splitAtCommas(kStressColumns);
  const auto place = std::ranges::find(names, column) - names.begin();
  return cells_.at(static_cast<std::size_t>(place));
}

std::string tableHeader(TableWidth width) {
  return fmt::format("  {:24}{}  verdict", "engine",
                     tableColumns(width, [](const TableColumn& column) { return column.title; }));
}

std::string tableLine(const StressRow& row, TableWidth width) {
  return fmt::format(
      "  {:24}{}  {}", row.cell("engine"),
      tableColumns(width, [&](const TableColumn& column) { return row.cell(column.cell); }),
      row.cell("verdict"));
}

}  // namespace wells
