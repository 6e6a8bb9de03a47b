// One benchmark in a process of its own: for engines of the other executable, and so that nothing
// that one run left in memory or caches helps or hinders the next.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>

namespace wells {

/// The row of a CSV file by column name.
class BenchRow {
 public:
  /// Throws RunError unless `file` holds a header and one row of as many cells.
  explicit BenchRow(const std::filesystem::path& file);

  /// Throws RunError where there is no such column, or for number() no number in it.
  const std::string& text(const std::string& column) const;
  double number(const std::string& column) const;

 private:
  std::filesystem::path file_;
  std::map<std::string, std::string> cells_;
};

/// Runs "bench" with these arguments and returns its row. `folder` is for files in between. Throws
/// RunError when it fails, or is not done within an hour.
BenchRow runBenchChild(std::span<const std::string> arguments, const std::filesystem::path& folder);

}  // namespace wells
