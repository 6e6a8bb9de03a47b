#include "bench_child.h"

#include <fmt/format.h>

#include <vector>

#include "child_process.h"
#include "errors.h"
#include "text_file.h"
#include "values.h"

namespace wells {
namespace {

namespace fs = std::filesystem;

constexpr double kLongest = 3600;  // s

/// As csvField() writes them: quoted where they hold commas or quotes.
std::vector<std::string> splitRow(const std::string& row) {
  std::vector<std::string> cells(1);
  bool isQuoted = false;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const bool isQuote = row[i] == '"';
    if (isQuote && isQuoted && i + 1 < row.size() && row[i + 1] == '"')
      cells.back() += row[++i];
    else if (isQuote)
      isQuoted = !isQuoted;
    else if (row[i] == ',' && !isQuoted)
      cells.emplace_back();
    else
      cells.back() += row[i];
  }
  return cells;
}

}  // namespace

BenchRow::BenchRow(const fs::path& file) : file_(file) {
  const std::vector<std::string> lines = readLines(file);
  const std::vector<std::string> names = splitRow(lines.empty() ? "" : lines[0]);
  const std::vector<std::string> cells = splitRow(lines.size() < 2 ? "" : lines[1]);
  if (names.size() != cells.size())
    throw RunError(fmt::format("{}: {} columns and {} cells in the first row", file.string(),
                               names.size(), cells.size()));
  for (std::size_t i = 0; i < names.size(); ++i) cells_[names[i]] = cells[i];
}

const std::string& BenchRow::text(const std::string& column) const {
  const auto found = cells_.find(column);
  if (found == cells_.end())
    throw RunError(fmt::format("{}: no column {}", file_.string(), column));
  return found->second;
}

double BenchRow::number(const std::string& column) const try {
  return parseNumber(text(column));
} catch (const BadValue& bad) {
  throw RunError(fmt::format("{}: {}={}: {}", file_.string(), column, text(column), bad.what()));
}

BenchRow runBenchChild(std::span<const std::string> arguments, const fs::path& folder) {
  const fs::path row = folder / ".bench.csv";
  const fs::path log = folder / ".bench.log";
  fs::remove(row);
  std::vector<std::string> all = {"bench", "--csv", row.string()};
  all.insert(all.end(), arguments.begin(), arguments.end());
  ChildProcess process(all, log);
  const std::optional<int> status = process.wait(kLongest);
  if (!status)
    throw RunError(fmt::format("{}: not done after {:.0f} s", joined(all, " "), kLongest));
  if (*status != 0)
    throw RunError(fmt::format("{}: ended with status {}; it said:\n{}", joined(all, " "), *status,
                               joined(readLines(log), "\n")));
  BenchRow result(row);
  fs::remove(row);
  fs::remove(log);
  return result;
}

}  // namespace wells
