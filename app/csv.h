// Tables of numbers in CSV files with a fixed header line.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "values.h"

namespace wells {

class CsvTable {
 public:
  /// Reads the whole file. Throws UsageError (file, line, what is allowed) unless its first line is
  /// exactly `header` and each further one has as many cells; blank lines don't count.
  CsvTable(std::filesystem::path file, std::string_view header);

  std::size_t rows() const { return rows_.size(); }

  /// A number of a row, in range. Throws UsageError with file, line, column, value and range.
  double number(std::size_t row, std::string_view column, const Range& range) const;
  std::int64_t integer(std::size_t row, std::string_view column, std::int64_t low,
                       std::int64_t high) const;

  /// Throws UsageError for that cell.
  [[noreturn]] void refuse(std::size_t row, std::string_view column, std::string_view why,
                           std::string_view allowed) const;

  int line(std::size_t row) const { return rows_[row].line; }

 private:
  struct Row {
    int line;
    std::string text;
  };
  std::string_view cell(std::size_t row, std::string_view column) const;

  std::filesystem::path file_;
  std::vector<std::string> columns_;
  std::vector<Row> rows_;
};

}  // namespace wells
