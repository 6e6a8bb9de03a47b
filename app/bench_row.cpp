#include "bench_row.h"

#include <fmt/format.h>

#include <fstream>

#include "build_info.h"
#include "math/instruction_set.h"

namespace wells {

std::string stepColumns(const ContactShares& shares, const std::optional<Books>& books) {
  const std::string first = shares.exactBalls + shares.substepBalls > 0
                                ? fmt::format("{:.6g},{:.6g},{},{},{},{}", shares.exact(),
                                              shares.substep(), shares.impacts, shares.handedOver,
                                              shares.directContacts, shares.unsolvedIslands)
                                : ",,,,,";
  if (!books) return first + ",,,,,,";
  return fmt::format("{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}", first, books->contacts,
                     books->friction, books->drag, books->wells, books->pushOut, books->flight);
}

std::string buildColumns() {
  return fmt::format("{},{},{},{}", build_info::kCommit, csvField(build_info::kCompiler),
                     csvField(build_info::kFlags), csvField(processorInUse()));
}

std::string processorInUse() {
  return fmt::format("{} ({})", processor(), name(instructionSet()));
}

std::string processor() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

std::string csvField(std::string_view text) {
  if (text.find_first_of(",\"") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace wells
