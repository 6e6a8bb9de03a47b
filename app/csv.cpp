#include "csv.h"

#include <fmt/format.h>

#include <algorithm>

#include "errors.h"
#include "text_file.h"

namespace wells {

CsvTable::CsvTable(std::filesystem::path file, std::string_view header) : file_(std::move(file)) {
  for (const std::string_view name : splitAtCommas(header)) columns_.emplace_back(name);
  int number = 0;
  for (std::string& line : readLines(file_)) {
    ++number;
    if (number == 1) {
      if (line != header)
        throw UsageError(fmt::format("{}:1: the header is \"{}\"; allowed: exactly \"{}\"",
                                     file_.string(), line, header));
      continue;
    }
    if (trimmed(line).empty()) continue;
    const auto cells = static_cast<std::size_t>(std::count(line.begin(), line.end(), ',') + 1);
    if (cells != columns_.size())
      throw UsageError(fmt::format("{}:{}: {} cell(s); allowed: {}, one for each of {}",
                                   file_.string(), number, cells, columns_.size(), header));
    rows_.push_back({number, std::move(line)});
  }
  if (number == 0)
    throw UsageError(
        fmt::format("{}:1: the file is empty; allowed: the header \"{}\" and a line "
                    "for each row",
                    file_.string(), header));
}

std::string_view CsvTable::cell(std::size_t row, std::string_view column) const {
  const auto at = std::find(columns_.begin(), columns_.end(), column) - columns_.begin();
  std::string_view rest = rows_[row].text;
  for (auto i = at; i > 0; --i) rest.remove_prefix(rest.find(',') + 1);
  return trimmed(rest.substr(0, rest.find(',')));
}

double CsvTable::number(std::size_t row, std::string_view column, const Range& range) const {
  try {
    return parseNumber(cell(row, column), range);
  } catch (const BadValue& bad) {
    refuse(row, column, bad.what(), fmt::format("a number {}", range.text()));
  }
}

std::int64_t CsvTable::integer(std::size_t row, std::string_view column, std::int64_t low,
                               std::int64_t high) const {
  try {
    return parseInteger(cell(row, column), low, high);
  } catch (const BadValue& bad) {
    refuse(row, column, bad.what(), fmt::format("a whole number {} to {}", low, high));
  }
}

void CsvTable::refuse(std::size_t row, std::string_view column, std::string_view why,
                      std::string_view allowed) const {
  throw UsageError(fmt::format("{}:{}: {}={}: {}; allowed: {}", file_.string(), rows_[row].line,
                               column, cell(row, column), why, allowed));
}

}  // namespace wells
