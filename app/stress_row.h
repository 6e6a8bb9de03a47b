// One row of the stress benchmark: cells of text, all of them for the CSV file and between
// processes, some of them for the table on the terminal.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "stress_run.h"

namespace wells {

/// Names of the cells.
inline constexpr std::string_view kStressColumns =
    "case,engine,integrator,contacts,worlds,steps,lost,not_finite,gain_J,gain_relative,overlap_m,"
    "exact_balls,substep_balls,exact_share,impacts,handed_over,direct_contacts,unsolved_islands,"
    "late_pairs,ms_per_step,first_broken,verdict,reason";

class StressRow {
 public:
  /// Of a run; `ran` is a stepper that has made a step with the settings of the run.
  StressRow(const StressCase& stress, const Stepper& ran, const StressResult& result);

  /// Of a run that did not come to its end: nothing is known but `verdict` and why.
  StressRow(const StressCase& stress, const std::string& engine, const std::string& verdict,
            const std::string& reason);

  /// From text(). Throws RunError where the number of cells is another.
  explicit StressRow(std::string_view text);

  /// All cells on one line.
  std::string text() const;
  std::string csv() const;

  const std::string& cell(std::string_view column) const;

 private:
  std::vector<std::string> cells_;
};

/// How much of a row the table shows. Narrow fits into 80 columns: without relative energy and
/// without the contact methods' shares.
enum class TableWidth { Narrow, Wide };

std::string tableHeader(TableWidth width);
std::string tableLine(const StressRow& row, TableWidth width);

/// Columns that a wide table may take, but for more than two words of verdict.
inline constexpr int kWideTable = 116;

}  // namespace wells
